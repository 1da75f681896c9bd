// Half section of half a ball R = 5, flat side up, on a disc R = 8, 5 high, lengths in mm. The axis is x = 0; they touch in
// the origin.
SetFactory("OpenCASCADE");
R = 5;
Point(1) = {0, 0, 0};
Point(2) = {R, R, 0};
Point(3) = {0, R, 0};
Circle(1) = {1, 3, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Point(5) = {0, -5, 0};
Point(6) = { 8, -5, 0};
Point(7) = { 8,  0, 0};
Point(8) = {0,  0, 0};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 5};
Curve Loop(2) = {4, 5, 6, 7};
Plane Surface(2) = {2};
Physical Surface("ball") = {1};
Physical Curve("tip") = {1};
Physical Curve("holder") = {2};
Physical Surface("plate") = {2};
Physical Curve("base") = {4};
Physical Curve("face") = {6};
