// Part of a ring, R = 20 cut at y = 6, on a block [-4, 4] x [-6, 0], lengths in mm (references C2).
// The lowest point of the ring is the origin.
SetFactory("OpenCASCADE");

R = 20;
top = 6;
half = Sqrt(R * R - (R - top) * (R - top));

Point(1) = {-half, top, 0};
Point(2) = { 0, 0, 0};
Point(3) = { half, top, 0};
Point(4) = { 0, R, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = {-4, -6, 0};
Point(6) = { 4, -6, 0};
Point(7) = { 4,  0, 0};
Point(8) = {-4,  0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};

Physical Surface("ring") = {1};
Physical Curve("running") = {1, 2};
Physical Curve("holder") = {3};
Physical Surface("block") = {2};
Physical Curve("base") = {4};
Physical Curve("worn") = {6};
