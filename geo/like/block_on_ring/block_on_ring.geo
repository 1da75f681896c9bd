// Part of a ring that turns on a block, mm: they touch at the origin. A script of gmsh; a STEP file of your own takes its place.
SetFactory("OpenCASCADE");
R = 20;              // radius of the ring
top = 6;             // height at which the ring is cut off
width = 8;           // of the block
height = 6;          // of the block

half = Sqrt(R * R - (R - top) * (R - top));
Point(1) = {-half, top, 0};
Point(2) = {0, 0, 0};
Point(3) = {half, top, 0};
Point(4) = {0, R, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }
Rectangle(2) = {-width / 2, -height, 0, width, height};
Physical Surface("ring") = {1};
Physical Curve("running") = {1, 2};
Physical Curve("holder") = {3};
Physical Surface("block") = {2};
Physical Curve("base") = {4};
Physical Curve("worn") = {6};
