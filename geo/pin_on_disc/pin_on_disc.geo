// A pin of 6 mm with a round end (R = 5, centre at z = 5), 8 long, that touches a disc of 50 mm at the origin, mm. The disc's axis
// is z at x = -20, its face lies at z = 0, and it is 3 thick.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 5, 5};
Cylinder(2) = {0, 0, -1, 0, 0, 6, 3};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, 5, 0, 0, 3, 3};
BooleanUnion(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Cylinder(6) = {-20, 0, -3, 0, 0, 3, 25};
Physical Volume("pin") = {5};
Physical Volume("disc") = {6};
