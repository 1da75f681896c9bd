// Quarters of two cylinders that cross at a right angle and touch at the origin, mm: the upper one R = 20 about y at
// z = 20, the lower one R = 40 about x at z = -40; each 20 long from its symmetry plane. Symmetry planes x = 0, y = 0.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 20, 0, 20, 0, 20};
Box(2) = {0, 0, 0, 20, 20, 20};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, -40, 20, 0, 0, 40};
Box(5) = {0, 0, -40, 20, 40, 40};
BooleanIntersection(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
Physical Volume("upper") = {3};
Physical Volume("lower") = {6};
Physical Surface("upper_contact") = {1};
Physical Surface("upper_end") = {2};  // y = 20
Physical Surface("upper_sx") = {3};
Physical Surface("upper_sy") = {4};
Physical Surface("upper_top") = {5};
Physical Surface("lower_contact") = {6};
Physical Surface("lower_sy") = {7};
Physical Surface("lower_sx") = {8};
Physical Surface("lower_bottom") = {9};
Physical Surface("lower_end") = {10};  // x = 20
