// A pin [-2, 2] x [0, 4] with a rounded tip of radius 4 on a rigid plate [-8, 12] x [-2, 0], mm.
SetFactory("OpenCASCADE");
h = 4 - Sqrt(12);
Point(1) = {0, 0, 0};
Point(2) = {0, 4, 0};
Point(3) = {-2, h, 0};
Point(4) = {2, h, 0};
Point(5) = {2, 4, 0};
Point(6) = {-2, 4, 0};
Circle(1) = {3, 2, 1};
Circle(2) = {1, 2, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {6, 3};
Curve Loop(1) = {1 : 5};
Plane Surface(1) = {1};
Delete { Point{2}; }
Rectangle(2) = {-8, -2, 0, 20, 2};
Physical Surface("pin") = {1};
Physical Surface("plate") = {2};
Physical Curve("tip") = {1, 2};
Physical Curve("head") = {4};
Physical Curve("face") = {8};
