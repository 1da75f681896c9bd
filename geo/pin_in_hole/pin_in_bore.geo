// Half a pin, R = 4.95, in half a bore of R = 5 in a block; lengths in mm. They touch at the bottom of the bore, (0, -5).
SetFactory("OpenCASCADE");

Point(1) = {-4.95, -0.05, 0};
Point(2) = { 0, -5, 0};
Point(3) = { 4.95, -0.05, 0};
Point(4) = { 0, -0.05, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = {-10, -12, 0};
Point(6) = { 10, -12, 0};
Point(7) = { 10,   0, 0};
Point(8) = {  5,   0, 0};
Point(9) = {  0,  -5, 0};
Point(10) = {-5,   0, 0};
Point(11) = {-10,  0, 0};
Point(12) = {  0,  0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Circle(7) = {8, 12, 9};
Circle(8) = {9, 12, 10};
Line(9) = {10, 11};
Line(10) = {11, 5};
Curve Loop(2) = {4, 5, 6, 7, 8, 9, 10};
Plane Surface(2) = {2};
Delete { Point{12}; }

Physical Surface("pin") = {1};
Physical Curve("round") = {1, 2};
Physical Curve("holder") = {3};
Physical Surface("block") = {2};
Physical Curve("base") = {4};
Physical Curve("bore") = {7, 8};
