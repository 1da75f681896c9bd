// Ring, inner radius 4 and outer 5, standing on a strip [-4, 16] x [-2, 0], mm.
SetFactory("OpenCASCADE");
Disk(1) = {0, 5, 0, 5};
Disk(2) = {0, 5, 0, 3};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Rectangle(4) = {-4, -2, 0, 20, 2};
Physical Surface("ring") = {3};
Physical Surface("strip") = {4};
