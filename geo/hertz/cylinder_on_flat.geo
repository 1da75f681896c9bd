// Half disc R = 6 on a block [-6, 6] x [-6, 0], lengths in mm (references B1b, B2, C1).
// The lowest point of the disc is the origin, its flat side is y = 6. The bodies touch in one point and share nothing.
SetFactory("OpenCASCADE");

R = 6;

Point(1) = {-R, R, 0};
Point(2) = { 0, 0, 0};
Point(3) = { R, R, 0};
Point(4) = { 0, R, 0};
Circle(1) = {1, 4, 2};   // two quarters: an arc of 180 degrees has no plane for the kernel
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = {-R, -R, 0};
Point(6) = { R, -R, 0};
Point(7) = { R,  0, 0};
Point(8) = {-R,  0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};
