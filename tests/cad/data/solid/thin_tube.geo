// A tube of radius 10 with a wall of 0.2 mm, and a rod of a kilometre.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 20, 10.2};
Cylinder(2) = {0, 0, 0, 0, 0, 20, 10};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Box(4) = {1000, 0, 0, 200000, 200000, 200000};
Physical Volume("tube") = {3};
Physical Volume("far_too_large") = {4};
