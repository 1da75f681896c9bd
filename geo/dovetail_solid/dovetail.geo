// Half of a blade's root (5 thick from its symmetry plane z = 0) in half of a slot of a disc (6 thick), mm; x = 0 is a
// symmetry plane, too. Blade and disc touch on flanks at 45 degrees; the disc's flank ends in round edges, R = 1.
SetFactory("OpenCASCADE");
Point(1) = {0, -7, 0};
Point(2) = {8, -7, 0};
Point(3) = {8, -5, 0};
Point(4) = {3, 0, 0};
Point(5) = {3, 8, 0};
Point(6) = {0, 8, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Extrude {0, 0, 5} { Surface{1}; }
Point(101) = {0, -16, 0};
Point(102) = {16, -16, 0};
Point(103) = {16, 1, 0};
Point(104) = {5, 1, 0};
Point(105) = {4, -1, 0};
Point(106) = {7, -4, 0};
Point(107) = {9.5, -4, 0};
Point(108) = {9.5, -9, 0};
Point(109) = {0, -9, 0};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 104};
Line(104) = {104, 105};
Line(105) = {105, 106};
Line(106) = {106, 107};
Line(107) = {107, 108};
Line(108) = {108, 109};
Line(109) = {109, 101};
Curve Loop(101) = {101, 102, 103, 104, 105, 106, 107, 108, 109};
Plane Surface(101) = {101};
Extrude {0, 0, 6} { Surface{101}; }
Fillet{1}{12}{1}
Fillet{2}{117, 119, 121, 123}{1}
Physical Volume("blade") = {3};
Physical Volume("disc") = {4};
Physical Surface("blade_contact") = {112};
Physical Surface("blade_sz") = {116};
Physical Surface("blade_top") = {119};
Physical Surface("blade_sx") = {120};
Physical Surface("disc_contact") = {123, 126, 128};  // with the round edges
Physical Surface("disc_sz") = {125};
Physical Surface("disc_side") = {127};
Physical Surface("disc_bottom") = {129};
Physical Surface("disc_sx") = {131};
