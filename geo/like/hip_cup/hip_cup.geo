// A ball in a hemispherical cup, open upwards, mm; the ball's centre is the origin and z the axis of the cup. They touch at the pole.
// A script of gmsh; STEP files of your own take its place.
SetFactory("OpenCASCADE");
R = 14;              // radius of the ball
clearance = 0.1;     // of the radius
wall = 8;            // thickness of the cup

Sphere(1) = {0, 0, 0, R, -Pi/2, 0};
Sphere(2) = {0, 0, clearance, R + clearance + wall, -Pi/2, 0};
Sphere(3) = {0, 0, clearance, R + clearance, -Pi/2, 0};
BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Physical Volume("ball") = {1};
Physical Volume("cup") = {4};
