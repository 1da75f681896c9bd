// A plate [0, 4] x [0, 3] with a round hole of radius 0.5 at (1, 2), mm. Area 12 - pi / 4.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 3};
Disk(2) = {1, 2, 0, 0.5};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Surface("plate") = {3};
