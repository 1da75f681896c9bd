// A quarter of a ring, radii 8 and 10, under a flat die, mm.
SetFactory("OpenCASCADE");
Point(1) = {8, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {0, 10, 0};
Point(4) = {0, 8, 0};
Point(5) = {0, 0, 0};
Line(1) = {1, 2};
Circle(2) = {2, 5, 3};
Line(3) = {3, 4};
Circle(4) = {4, 5, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};
Delete { Point{5}; }
Rectangle(2) = {-1, 10, 0, 16, 1};
Physical Surface("ring") = {1};
Physical Surface("die") = {2};
Physical Curve("equator") = {1};
Physical Curve("outside") = {2};
Physical Curve("crown") = {3};
Physical Curve("face") = {5};
