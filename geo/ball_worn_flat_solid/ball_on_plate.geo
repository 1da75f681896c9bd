// A quarter of half a ball R = 5, flat side up, on a quarter of a disc R = 8, 5 high, lengths in mm: the bodies of
// geo/ball_worn_flat in space. The axis is z; they touch in the origin.
SetFactory("OpenCASCADE");
R = 5;
Sphere(1) = {0, 0, R, R, -Pi/2, 0, Pi/2};
Cylinder(2) = {0, 0, -5, 0, 0, 5, 8, Pi/2};
Physical Volume("ball") = {1};
Physical Volume("plate") = {2};
