// Half disc R = 8, flat side up at y = 0, on a stiff foundation (references C4), mm.
SetFactory("OpenCASCADE");

R = 8;

Point(1) = {-R,  0, 0};
Point(2) = { 0, -R, 0};
Point(3) = { R,  0, 0};
Point(4) = { 0,  0, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = {-10, -13, 0};
Point(6) = { 10, -13, 0};
Point(7) = { 10,  -R, 0};
Point(8) = {-10,  -R, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};

Physical Surface("disc") = {1};
Physical Surface("foundation") = {2};
Physical Curve("disc_round") = {1, 2};
Physical Curve("disc_top") = {3};
Physical Curve("foundation_bottom") = {4};
Physical Curve("foundation_top") = {6};
