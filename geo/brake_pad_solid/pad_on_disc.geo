// A brake pad, 60 x 40 and 10 thick (z 0 to 10), on a disc of outer radius 130 and inner radius 70, 12 thick below z = 0, mm.
// The disc's axis is z; the pad's middle lies at x = 0, y = 100, so y is the radial and x the sliding direction.
SetFactory("OpenCASCADE");
Box(1) = {-30, 80, 0, 60, 40, 10};
Cylinder(2) = {0, 0, -12, 0, 0, 12, 130};
Cylinder(3) = {0, 0, -12, 0, 0, 12, 70};
BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Physical Volume("pad") = {1};
Physical Volume("disc") = {4};
