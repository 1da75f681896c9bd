// A unit square whose top is a spline; its control points are no corners.
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {1, 1, 0};
Point(4) = {0.7, 1.1, 0};
Point(5) = {0.3, 0.9, 0};
Point(6) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Spline(3) = {3, 4, 5, 6};
Line(4) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("body") = {1};
Physical Curve("top") = {3};
