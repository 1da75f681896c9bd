// A quarter of a billet, 20 wide and 30 high with rounded edges, under a flat die, mm.
SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {10, 14, 0};
Point(4) = {9, 14, 0};
Point(5) = {9, 15, 0};
Point(6) = {0, 15, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 4, 5};
Line(4) = {5, 6};
Line(5) = {6, 1};
Curve Loop(1) = {1 : 5};
Plane Surface(1) = {1};
Delete { Point{4}; }
Rectangle(2) = {-1, 15, 0, 24, 1};
Physical Surface("billet") = {1};
Physical Surface("die") = {2};
Physical Curve("equator") = {1};
Physical Curve("outside") = {2, 3, 4};
Physical Curve("middle") = {5};
Physical Curve("face") = {6};
