// The plate and, 5 mm above it, its copy, both turned by 40 degrees about the x axis.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 3};
Disk(2) = {1, 2, 0, 0.5};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Translate {10, 0, 5} { Duplicata { Surface{3}; } }
Rotate {{1, 0, 0}, {0, 0, 0}, 40 * Pi / 180} { Surface{:}; }
