// A plate [-2, 2] x [0, 3] with a round hole of radius 0.5 at (0, 2), mm: source of the others of this name. Half its area is 6 - pi / 8.
SetFactory("OpenCASCADE");
Rectangle(1) = {-2, 0, 0, 4, 3};
Disk(2) = {0, 2, 0, 0.5};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Surface("plate") = {3};
