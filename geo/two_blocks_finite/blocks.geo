// Two blocks, mm: lower [0, 4] x [0, 2], upper [1.5, 3.5] x [2, 3].
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 2};
Rectangle(2) = {1.5, 2, 0, 2, 1};
Physical Surface("lower") = {1};
Physical Surface("upper") = {2};
Physical Curve("lower_bottom") = {1};
Physical Curve("lower_top") = {3};
Physical Curve("upper_bottom") = {5};
Physical Curve("upper_top") = {7};
