// A shallow cylinder R = 100 on a block, both 20 mm to either side and 20 mm deep (references B1, low load), mm.
// At a contact half width a = 0.2 mm (p0 / E* = a / 2R = 1e-3) the bodies reach 100 a in every direction,
// so that the half-plane formula holds. The lowest point of the cylinder is the origin.
SetFactory("OpenCASCADE");

R = 100;
W = 20;
s = R - Sqrt(R * R - W * W);   // height of the arc's ends

Point(1) = {-W, W, 0};
Point(2) = {-W, s, 0};
Point(3) = { 0, 0, 0};
Point(4) = { W, s, 0};
Point(5) = { W, W, 0};
Point(6) = { 0, R, 0};
Line(1) = {1, 2};
Circle(2) = {2, 6, 3};
Circle(3) = {3, 6, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Delete { Point{6}; }

Point(7) = {-W, -W, 0};
Point(8) = { W, -W, 0};
Point(9) = { W,  0, 0};
Point(10) = {-W, 0, 0};
Line(6) = {7, 8};
Line(7) = {8, 9};
Line(8) = {9, 10};
Line(9) = {10, 7};
Curve Loop(2) = {6, 7, 8, 9};
Plane Surface(2) = {2};
