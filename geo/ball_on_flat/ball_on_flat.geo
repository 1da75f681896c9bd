// A quarter of the lower half of a ball (R = 50, centre at z = 50) on a quarter of a block (50 x 50 x 50 below z = 0), mm,
// cut by the symmetry planes x = 0 and y = 0. They touch at the origin.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 50, 50, -Pi/2, 0, Pi/2};
Box(2) = {0, 0, -50, 50, 50, 50};
Physical Volume("ball") = {1};
Physical Volume("flat") = {2};
Physical Surface("ball_contact") = {1};
Physical Surface("ball_top") = {2};
Physical Surface("ball_sx") = {4};
Physical Surface("ball_sy") = {3};
Physical Surface("flat_sx") = {5};
Physical Surface("flat_sy") = {7};
Physical Surface("flat_bottom") = {9};
Physical Surface("flat_contact") = {10};
