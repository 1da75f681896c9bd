// Half disc R = 1, flat side up, on a block 2 x 1.
SetFactory("OpenCASCADE");
Point(1) = {-1, 1, 0};
Point(2) = {0, 0, 0};
Point(3) = {1, 1, 0};
Point(4) = {0, 1, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }
Rectangle(2) = {-1, -1, 0, 2, 1};
Physical Surface("disc") = {1};
Physical Surface("flat") = {2};
Physical Curve("round") = {1, 2};
Physical Curve("top") = {3};
Physical Curve("bottom") = {4};
Physical Curve("face") = {6};
