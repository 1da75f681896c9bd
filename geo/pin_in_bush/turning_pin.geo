// A pin (R = 9.95) in a bush (bore R = 10, outside R = 16), mm, whole around and cut by the symmetry plane z = 0 of the
// bearing; the bush is 10 long from there and the pin 14. They touch along x = 0, y = -10.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 14, 9.95};
Rotate{{0, 0, 1}, {0, 0, 0}, Pi/2} { Volume{1}; }  // its seam lies at the top
Translate{0, -0.05, 0} { Volume{1}; }
Cylinder(2) = {0, 0, 0, 0, 0, 10, 16};
Cylinder(3) = {0, 0, 0, 0, 0, 10, 10};
BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Rotate{{0, 0, 1}, {0, 0, 0}, Pi/2} { Volume{4}; }
Physical Volume("pin") = {1};
Physical Volume("bush") = {4};
