// Head of a contact rivet, R = 2, 2.4 wide and 1 high, on a plate 4 x 1, lengths in mm. The lowest point of the head is
// the origin.
SetFactory("OpenCASCADE");

R = 2;
half = 1.2;
rise = R - Sqrt(R * R - half * half);

Point(1) = {-half, rise, 0};
Point(2) = { 0, 0, 0};
Point(3) = { half, rise, 0};
Point(4) = { 0, R, 0};
Point(5) = { half, 1, 0};
Point(6) = {-half, 1, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 5};
Line(4) = {5, 6};
Line(5) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(7) = {-2, -1, 0};
Point(8) = { 2, -1, 0};
Point(9) = { 2,  0, 0};
Point(10) = {-2,  0, 0};
Line(6) = {7, 8};
Line(7) = {8, 9};
Line(8) = {9, 10};
Line(9) = {10, 7};
Curve Loop(2) = {6, 7, 8, 9};
Plane Surface(2) = {2};

Physical Surface("rivet") = {1};
Physical Surface("plate") = {2};
Physical Curve("head") = {1, 2};
Physical Curve("back") = {4};
Physical Curve("face") = {8};
Physical Curve("foot") = {6};
