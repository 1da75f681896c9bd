// Section of a half-round ring (half disc of radius 30 about r = 100, flat side up) on a flat ring r in [50, 150],
// lengths in mm (references C7). x is the radius, y the axis. The lowest point of the half disc is (100, 0).
SetFactory("OpenCASCADE");

R = 30;
r = 100;

Point(1) = {r - R, R, 0};
Point(2) = {r, 0, 0};
Point(3) = {r + R, R, 0};
Point(4) = {r, R, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = { 50, -40, 0};
Point(6) = {150, -40, 0};
Point(7) = {150,   0, 0};
Point(8) = { 50,   0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};

Physical Surface("half_round") = {1};
Physical Curve("round") = {1, 2};
Physical Curve("top") = {3};
Physical Surface("flat_ring") = {2};
Physical Curve("bottom") = {4};
Physical Curve("face") = {6};
