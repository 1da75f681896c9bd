// A plate (40 x 30 x 6 below z = 0), on it a pin block with a cylindrical foot (R = 20 about y, 8 wide, 12 long), under it
// a clamp, a round bar of 10 mm with a spherical foot (R = 30), mm: source of assembly.step, written by gmsh; its product
// names are edited by hand. The block touches the plate along x = 0, z = 0, the clamp at (0, 0, -6).
SetFactory("OpenCASCADE");
Box(1) = {-20, -15, -6, 40, 30, 6};
Cylinder(2) = {0, -6, 20, 0, 12, 0, 20};
Box(3) = {-4, -6, -1, 8, 12, 11};
BooleanIntersection(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Sphere(5) = {0, 0, -36, 30};
Cylinder(6) = {0, 0, -20, 0, 0, 15, 5};
BooleanIntersection(7) = { Volume{5}; Delete; }{ Volume{6}; Delete; };
