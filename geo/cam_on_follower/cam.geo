// Nose of a cam, R = 12, on a flat follower 32 x 6, lengths in mm. The lowest point of the nose is the origin.
SetFactory("OpenCASCADE");

R = 12;
half = 6;
rise = R - Sqrt(R * R - half * half);

Point(1) = {-half, rise, 0};
Point(2) = { 0, 0, 0};
Point(3) = { half, rise, 0};
Point(4) = { 0, R, 0};
Point(5) = { half, 6, 0};
Point(6) = {-half, 6, 0};
Circle(1) = {1, 4, 2};
Circle(2) = {2, 4, 3};
Line(3) = {3, 5};
Line(4) = {5, 6};
Line(5) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Delete { Point{4}; }

Point(7) = {-16, -6, 0};
Point(8) = { 16, -6, 0};
Point(9) = { 16,  0, 0};
Point(10) = {-16,  0, 0};
Line(6) = {7, 8};
Line(7) = {8, 9};
Line(8) = {9, 10};
Line(9) = {10, 7};
Curve Loop(2) = {6, 7, 8, 9};
Plane Surface(2) = {2};

Physical Surface("cam") = {1};
Physical Curve("nose") = {1, 2};
Physical Curve("back") = {4};
Physical Surface("follower") = {2};
Physical Curve("base") = {6};
Physical Curve("face") = {8};
