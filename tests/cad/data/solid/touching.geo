// Two boxes of 1 x 1 x 1 mm, one on the other, with a face each at z = 0, and a ball with a hollow beside them.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, -1, 1, 1, 1};
Box(2) = {0, 0, 0, 1, 1, 1};
Sphere(3) = {5, 0, 0, 1};
Sphere(4) = {5, 0, 0, 0.5};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
Physical Volume("hollow") = {5};
