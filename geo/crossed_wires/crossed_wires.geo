// Half (y > 0) of two crossed wires of 2 mm that touch at the origin, mm: the upper one along y with its axis at z = 1, of which
// the lower half is drawn, 3 long from the symmetry plane y = 0; the lower one along x with its axis at z = -1, of which
// the upper half is drawn, 6 long. What is left out of each wire sits in its holder.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 1, 0, 3, 0, 1};
Box(2) = {-1, 0, 0, 2, 3, 1};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {-3, 0, -1, 6, 0, 0, 1};
Box(5) = {-3, 0, -1, 6, 1, 1};
BooleanIntersection(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
Physical Volume("upper") = {3};
Physical Volume("lower") = {6};
