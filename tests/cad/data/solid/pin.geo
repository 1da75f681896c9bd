// A pin, 4 mm long and 4 mm thick, whose end z = 0 wears.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 4, 2};
Physical Volume("pin") = {1};
Physical Surface("end") = {3};
Physical Surface("top") = {2};
Physical Surface("side") = {1};
