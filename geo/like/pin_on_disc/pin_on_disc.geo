// Half section through the axis of a pin with a round end on a disc, mm: x is the radius, x = 0 the axis of the pin; they touch at the origin.
// A script of gmsh; a STEP file of your own takes its place.
SetFactory("OpenCASCADE");
diameter = 6;        // of the pin
tip = 10;            // radius of its round end
length = 8;          // of the pin
thickness = 5;       // of the disc

edge = tip - Sqrt(tip * tip - diameter * diameter / 4);
Point(1) = {0, 0, 0};
Point(2) = {diameter / 2, edge, 0};
Point(3) = {diameter / 2, length, 0};
Point(4) = {0, length, 0};
Point(5) = {0, tip, 0};
Circle(1) = {1, 5, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Delete { Point{5}; }
Rectangle(2) = {0, -thickness, 0, diameter, thickness};
Physical Surface("pin") = {1};
Physical Curve("pin_end") = {1};
Physical Curve("pin_top") = {3};
Physical Surface("disc") = {2};
Physical Curve("base") = {5};
Physical Curve("track") = {7};
