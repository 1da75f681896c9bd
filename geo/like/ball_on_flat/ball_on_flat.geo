// Half of the lower half of a ball on half of a block, mm, cut by the plane y = 0, along which the ball moves; they touch at the origin.
// A script of gmsh; STEP files of your own take its place.
SetFactory("OpenCASCADE");
R = 10;              // radius of the ball
width = 20;          // of the block, along x; y has half of it
height = 10;         // of the block

Sphere(1) = {0, 0, R, R, -Pi/2, 0, Pi};
Box(2) = {-width / 2, 0, -height, width, width / 2, height};
Physical Volume("ball") = {1};
Physical Volume("flat") = {2};
