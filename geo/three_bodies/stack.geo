// A stack, mm: base [0, 6] x [0, 2], slice [1, 5] x [2, 3], block [2, 4] x [3, 5].
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 6, 2};
Rectangle(2) = {1, 2, 0, 4, 1};
Rectangle(3) = {2, 3, 0, 2, 2};
Physical Surface("base") = {1};
Physical Surface("slice") = {2};
Physical Surface("block") = {3};
Physical Curve("base_bottom") = {1};
Physical Curve("base_top") = {3};
Physical Curve("slice_bottom") = {5};
Physical Curve("slice_top") = {7};
Physical Curve("block_bottom") = {9};
Physical Curve("block_top") = {11};
