// Two blocks pressed sideways (references C5), mm: left [-0.35, -0.05] x [-1, 0] of 2 x 6 elements, right
// [0, 0.3] x [-1, 0] of 2 x 4, a gap of 0.05 between. The mesh is part of the case: scenes read two_blocks.msh.
x0() = {-0.35, 0};
x1() = {-0.05, 0.3};
rows() = {6, 4};

For b In {0 : 1}
  p = 4 * b;
  Point(p + 1) = {x0(b), -1, 0};
  Point(p + 2) = {x1(b), -1, 0};
  Point(p + 3) = {x1(b),  0, 0};
  Point(p + 4) = {x0(b),  0, 0};
  For i In {1 : 4}
    Line(p + i) = {p + i, p + i % 4 + 1};
  EndFor
  Transfinite Curve {p + 1, p + 3} = 3;
  Transfinite Curve {p + 2, p + 4} = rows(b) + 1;
  Curve Loop(b + 1) = {p + 1 : p + 4};
  Plane Surface(b + 1) = {b + 1};
  Transfinite Surface {b + 1};
  Recombine Surface {b + 1};
EndFor

Physical Surface("left") = {1};
Physical Surface("right") = {2};
Physical Curve("left_bottom") = {1};
Physical Curve("left_right") = {2};
Physical Curve("left_top") = {3};
Physical Curve("left_left") = {4};
Physical Curve("right_bottom") = {5};
Physical Curve("right_right") = {6};
Physical Curve("right_top") = {7};
Physical Curve("right_left") = {8};
