// A box of 2 x 1 x 1 mm whose bottom is to have quadrilaterals.
Point(1) = {0, 0, 0, 0.01};
Point(2) = {2, 0, 0, 0.01};
Point(3) = {2, 1, 0, 0.01};
Point(4) = {0, 1, 0, 0.01};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Transfinite Curve{1, 2, 3, 4} = 3;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface{1};
Recombine Surface{1};
out() = Extrude {0, 0, 1} { Surface{1}; };
Physical Volume("block") = {out(1)};
Physical Surface("bottom") = {1};
