// Half disc R = 5, flat side up, on a block [-8, 8] x [-5, 0], lengths in mm. The lowest point of the disc is the origin.
SetFactory("OpenCASCADE");

R = 5;

Point(1) = {-R, R, 0};
Point(2) = { 0, 0, 0};
Point(3) = { R, R, 0};
Point(4) = { 0, R, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(5) = {-8, -5, 0};
Point(6) = { 8, -5, 0};
Point(7) = { 8,  0, 0};
Point(8) = {-8,  0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};

Physical Surface("pin") = {1};
Physical Curve("tip") = {1, 2};
Physical Curve("holder") = {3};
Physical Surface("plate") = {2};
Physical Curve("base") = {4};
Physical Curve("face") = {6};
