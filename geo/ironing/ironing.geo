// Ironing (references C6), mm: strip [0, 12] x [0, 4] of 70 x 10 elements; tool: rectangle 2 x 1 over a semicircle of
// radius 1 about (1.2, 5.02), its arc of 18 edges. The mesh is part of the case: scenes read ironing.msh.
x = 1.2;  y = 5.02;  R = 1;

Point(1) = {0, 0, 0};
Point(2) = {12, 0, 0};
Point(3) = {12, 4, 0};
Point(4) = {0, 4, 0};
For i In {1 : 4}
  Line(i) = {i, i % 4 + 1};
EndFor
Transfinite Curve {1, 3} = 71;
Transfinite Curve {2, 4} = 11;
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

// The tool: a core below the flat, three blocks between core and arc, and a row of three above.
Point(10) = {x, y, 0};
Point(11) = {x - R, y, 0};
Point(12) = {x - R * Cos(Pi / 3), y - R * Sin(Pi / 3), 0};
Point(13) = {x + R * Cos(Pi / 3), y - R * Sin(Pi / 3), 0};
Point(14) = {x + R, y, 0};
Point(15) = {x - 0.45, y, 0};
Point(16) = {x - 0.30, y - 0.50, 0};
Point(17) = {x + 0.30, y - 0.50, 0};
Point(18) = {x + 0.45, y, 0};
Point(19) = {x - R, y + 1, 0};
Point(20) = {x - 0.45, y + 1, 0};
Point(21) = {x + 0.45, y + 1, 0};
Point(22) = {x + R, y + 1, 0};
Circle(11) = {11, 10, 12};
Circle(12) = {12, 10, 13};
Circle(13) = {13, 10, 14};
Line(14) = {15, 16};
Line(15) = {16, 17};
Line(16) = {17, 18};
Line(17) = {11, 15};
Line(18) = {12, 16};
Line(19) = {13, 17};
Line(20) = {14, 18};
Line(21) = {15, 18};
Line(22) = {19, 11};
Line(23) = {20, 15};
Line(24) = {21, 18};
Line(25) = {22, 14};
Line(26) = {20, 19};
Line(27) = {21, 20};
Line(28) = {22, 21};
Transfinite Curve {11, 12, 13, 14, 15, 16, 21, 27} = 7;
Transfinite Curve {17, 18, 19, 20, 26, 28} = 5;
Transfinite Curve {22, 23, 24, 25} = 7;
Curve Loop(11) = {11, 18, -14, -17};
Curve Loop(12) = {12, 19, -15, -18};
Curve Loop(13) = {13, 20, -16, -19};
Curve Loop(14) = {14, 15, 16, -21};
Curve Loop(15) = {22, 17, -23, 26};
Curve Loop(16) = {23, 21, -24, 27};
Curve Loop(17) = {24, -20, -25, 28};
For i In {11 : 17}
  Plane Surface(i) = {i};
  Transfinite Surface {i};
  Recombine Surface {i};
EndFor

Physical Surface("strip") = {1};
Physical Surface("tool") = {11 : 17};
Physical Curve("strip_bottom") = {1};
Physical Curve("strip_right") = {2};
Physical Curve("strip_top") = {3};
Physical Curve("strip_left") = {4};
Physical Curve("arc") = {11, 12, 13};
Physical Curve("tool_top") = {26, 27, 28};
