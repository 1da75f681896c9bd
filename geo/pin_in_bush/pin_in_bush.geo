// Half of a pin (R = 9.95) in half of a bush (bore R = 10, outside R = 16), mm, cut by the symmetry planes x = 0 and
// z = 0 of the bearing; the bush is 10 long from there and the pin 14. They touch along x = 0, y = -10.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 14, 9.95};
Rotate{{0, 0, 1}, {0, 0, 0}, Pi} { Volume{1}; }  // its seam is cut away
Translate{0, -0.05, 0} { Volume{1}; }
Box(2) = {0, -20, 0, 20, 40, 14};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, 0, 0, 0, 10, 16};
Cylinder(5) = {0, 0, 0, 0, 0, 10, 10};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
Rotate{{0, 0, 1}, {0, 0, 0}, Pi} { Volume{6}; }
Box(7) = {0, -20, 0, 20, 40, 10};
BooleanIntersection(8) = { Volume{6}; Delete; }{ Volume{7}; Delete; };
Physical Volume("pin") = {3};
Physical Volume("bush") = {8};
Physical Surface("pin_contact") = {1};
Physical Surface("pin_end") = {2};
Physical Surface("pin_sx") = {3};
Physical Surface("pin_sz") = {4};
Physical Surface("bush_outside") = {5};
Physical Surface("bush_end") = {6};
Physical Surface("bush_sx") = {7, 9};
Physical Surface("bush_sz") = {8};
Physical Surface("bush_contact") = {10};
