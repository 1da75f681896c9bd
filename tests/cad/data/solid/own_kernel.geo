// A box of 2 x 1 x 1 mm in gmsh's own kernel, with element sizes and a field in whose place Reye sets its own.
Point(1) = {0, 0, 0, 0.01};
Point(2) = {2, 0, 0, 0.01};
Point(3) = {2, 1, 0, 0.01};
Point(4) = {0, 1, 0, 0.01};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Field[1] = MathEval;
Field[1].F = "0.02";
Background Field = 1;
Mesh.MeshSizeMax = 0.05;
out() = Extrude {0, 0, 1} { Surface{1}; };
Physical Volume("block") = {out(1)};
Physical Surface("bottom") = {1};
