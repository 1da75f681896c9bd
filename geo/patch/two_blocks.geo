// Contact patch (references C3), mm: a block [3, 9] x [5, 10] of 5 x 5 elements on a block [0, 10] x [0, 5] of unit
// squares, whose nodes at y = 5 sit at x = 0, 1, 2, 2.8, 4, 5, 6, 7, 8, 9.4, 10. The meshes do not match.
// The mesh is part of the case: scenes read two_blocks.msh.

// Upper block
Point(1) = {3,  5, 0};
Point(2) = {9,  5, 0};
Point(3) = {9, 10, 0};
Point(4) = {3, 10, 0};
For i In {1 : 4}
  Line(i) = {i, i % 4 + 1};
  Transfinite Curve {i} = 6;
EndFor
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

// Lower block: four regular rows and the top row with its shifted nodes
Point(11) = { 0, 0, 0};
Point(12) = {10, 0, 0};
Point(13) = {10, 4, 0};
Point(14) = { 0, 4, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Transfinite Curve {11, 13} = 11;
Transfinite Curve {12, 14} = 5;
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};
Transfinite Surface {2};
Recombine Surface {2};

top() = {0, 1, 2, 2.8, 4, 5, 6, 7, 8, 9.4, 10};
For i In {0 : 10}
  Point(20 + i) = {top(i), 5, 0};
EndFor
For i In {0 : 9}
  Line(20 + i) = {20 + i, 21 + i};
  Transfinite Curve {20 + i} = 2;
EndFor
Line(31) = {14, 20};
Line(32) = {30, 13};
Transfinite Curve {31, 32} = 2;
Curve Loop(3) = {31, 20 : 29, 32, 13};
Plane Surface(3) = {3};
Transfinite Surface {3} = {14, 13, 30, 20};
Recombine Surface {3};

Physical Surface("upper") = {1};
Physical Surface("lower") = {2, 3};
Physical Curve("upper_bottom") = {1};
Physical Curve("upper_right") = {2};
Physical Curve("upper_top") = {3};
Physical Curve("upper_left") = {4};
Physical Curve("lower_bottom") = {11};
Physical Curve("lower_right") = {12, 32};
Physical Curve("lower_top") = {20 : 29};
Physical Curve("lower_left") = {14, 31};
