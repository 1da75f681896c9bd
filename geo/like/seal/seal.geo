// Half section of a lip seal and its shaft, mm: x is the radius, y the axis. The lip is drawn as moulded, its tip inside the shaft by the
// interference. A script of gmsh; a STEP file of your own takes its place.
SetFactory("OpenCASCADE");
shaft = 20;          // radius of the shaft
interference = 0.2;  // of the radius, of the lip before it is mounted
rho = 0.25;          // radius of the tip
oil = 45;            // degrees between the lip's free side and the shaft
air = 25;            // degrees between its other side and the shaft
housing = 27;        // radius of the housing's bore

o = oil * Pi / 180;
a = air * Pi / 180;
r = shaft - interference + rho;      // the centre of the tip
Point(1) = {r, 0, 0};
Point(2) = {r - rho * Cos(o), -rho * Sin(o), 0};
Point(3) = {r - rho * Cos(a), rho * Sin(a), 0};
Point(11) = {r - rho, 0, 0};
Point(4) = {r - rho * Cos(o) + 1.6 * Sin(o), -rho * Sin(o) - 1.6 * Cos(o), 0};
Point(5) = {r + 2.6, -rho * Sin(o) - 1.6 * Cos(o), 0};
Point(6) = {r + 2.6, 2.2, 0};
Point(7) = {housing - 1.5, 5, 0};
Point(8) = {housing, 5, 0};
Point(9) = {housing, 8, 0};
Point(10) = {housing - 2, 8, 0};
Point(12) = {housing - 2.7, 6.4, 0};
Point(13) = {r - rho * Cos(a) + 3.2 * Sin(a), rho * Sin(a) + 3.2 * Cos(a), 0};
Circle(1) = {3, 1, 11};
Circle(2) = {11, 1, 2};
Line(3) = {2, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 10};
Line(10) = {10, 12};
Line(11) = {12, 13};
Line(12) = {13, 3};
Curve Loop(1) = {1 : 12};
Plane Surface(1) = {1};
Delete { Point{1}; }
Rectangle(2) = {shaft - 4, -6, 0, 4, 16};
Physical Surface("lip") = {1};
Physical Curve("edge") = {12, 1, 2, 3};    // the tip and both of its sides
Physical Curve("press_fit") = {8};
Physical Surface("shaft") = {2};
Physical Curve("surface") = {14};
