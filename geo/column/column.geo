// A column of height 10 and width 1 on a wider base (references B6), mm. The base is meant to be a rigid body.

Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1, 10, 0};
Point(4) = {0, 10, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("column") = {1};
Physical Curve("column_bottom") = {1};
Physical Curve("column_right") = {2};
Physical Curve("column_top") = {3};
Physical Curve("column_left") = {4};

Point(5) = {-1, -1, 0};
Point(6) = {2, -1, 0};
Point(7) = {2, 0, 0};
Point(8) = {-1, 0, 0};
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
