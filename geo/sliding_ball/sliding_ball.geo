// The half y > 0 of the lower half of a ball (R = 50, centre at z = 50) on a block (100 x 50 x 50 below z = 0), mm, cut by the
// symmetry plane y = 0, so that the ball can slide along x. They touch at the origin.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 50, 50, -Pi/2, 0, Pi};
Box(2) = {-50, 0, -50, 100, 50, 50};
Physical Volume("ball") = {1};
Physical Volume("flat") = {2};
