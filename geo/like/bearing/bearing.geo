// Section of a plain bearing, mm: a hollow shaft in a bush, which touch at the lowest point of the bore. A script of gmsh; a STEP file of your
// own takes its place.
SetFactory("OpenCASCADE");
diameter = 20;       // of the shaft
hole = 8;            // diameter of the hole along the shaft
clearance = 0.05;    // of the radius
wall = 4;            // thickness of the bush

bore = diameter / 2 + clearance;
Circle(1) = {0, -clearance, 0, diameter / 2};
Circle(2) = {0, -clearance, 0, hole / 2};
Curve Loop(1) = {1};
Curve Loop(2) = {2};
Plane Surface(1) = {1, 2};
Circle(3) = {0, 0, 0, bore + wall};
Circle(4) = {0, 0, 0, bore};
Curve Loop(3) = {3};
Curve Loop(4) = {4};
Plane Surface(2) = {3, 4};
Physical Surface("shaft") = {1};
Physical Curve("journal") = {1};
Physical Curve("inner") = {2};
Physical Surface("bush") = {2};
Physical Curve("outside") = {3};
Physical Curve("bore") = {4};
