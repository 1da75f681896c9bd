// A block on a wider one (references B5, the counter body wider by 5 mm on either side), mm.

Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {10, 5, 0};
Point(4) = {0, 5, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("slider") = {1};
Physical Curve("slider_bottom") = {1};
Physical Curve("slider_right") = {2};
Physical Curve("slider_top") = {3};
Physical Curve("slider_left") = {4};

Point(5) = {-5, -5, 0};
Point(6) = {15, -5, 0};
Point(7) = {15, 0, 0};
Point(8) = {-5, 0, 0};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(2) = {2};
Physical Surface("base") = {2};
Physical Curve("base_bottom") = {5};
Physical Curve("base_right") = {6};
Physical Curve("base_top") = {7};
Physical Curve("base_left") = {8};
