// A ball (R = 14) in a hemispherical cup (inner radius 14.1, outer 22, open upwards), mm; the ball's centre is the origin, and
// the cup lies 0.1 lower so that they touch at the pole, x = y = 0, z = -14. z is the axis of the cup.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 14, -Pi/2, 0};
Sphere(2) = {0, 0, 0.1, 22, -Pi/2, 0};
Sphere(3) = {0, 0, 0.1, 14.1, -Pi/2, 0};
BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Physical Volume("ball") = {1};
Physical Volume("cup") = {4};
