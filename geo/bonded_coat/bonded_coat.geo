// A half disc of 6 mm on a coat of 20 um, which lies on a block.
SetFactory("OpenCASCADE");
Disk(1) = {0, 6.02, 0, 6};
Rectangle(2) = {-7, 6.02, 0, 14, 7};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Rectangle(4) = {-6, 0, 0, 12, 0.02};
Rectangle(5) = {-6, -6, 0, 12, 6};
Physical Surface("cylinder") = {3};
Physical Surface("coat") = {4};
Physical Surface("substrate") = {5};
