// A flat of 8 x 2 mm, and on it two pins of 0.8 mm with round feet (R = 2 mm), 1.2 mm apart.
Point(1) = {0, -2, 0};
Point(2) = {8, -2, 0};
Point(3) = {8, 0, 0};
Point(4) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

sag = 2 - Sqrt(2 * 2 - 0.4 * 0.4);
For i In {0:1}
  x = 2.4 + 1.2 * i;
  n = 10 * (i + 1);
  Point(n + 1) = {x - 0.4, sag, 0};
  Point(n + 2) = {x + 0.4, sag, 0};
  Point(n + 3) = {x + 0.4, 1, 0};
  Point(n + 4) = {x - 0.4, 1, 0};
  Point(n + 5) = {x, 2, 0};
  Circle(n + 1) = {n + 1, n + 5, n + 2};
  Line(n + 2) = {n + 2, n + 3};
  Line(n + 3) = {n + 3, n + 4};
  Line(n + 4) = {n + 4, n + 1};
  Curve Loop(n) = {n + 1, n + 2, n + 3, n + 4};
  Plane Surface(n) = {n};
EndFor

Physical Surface("flat") = {1};
Physical Surface("first") = {10};
Physical Surface("second") = {20};
Physical Curve("bottom") = {1};
Physical Curve("track") = {3};
Physical Curve("first_foot") = {11};
Physical Curve("first_head") = {13};
Physical Curve("second_foot") = {21};
Physical Curve("second_head") = {23};
