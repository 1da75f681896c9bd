// Right half of a blade's root in its slot in a disc, mm, cut at x = 0; they touch on a flank at 45 degrees, whose land on the disc ends in
// round edges. A script of gmsh; a STEP file of your own takes its place.
SetFactory("OpenCASCADE");
neck = 3;            // half width of the blade above its root
root = 8;            // half width of the root
round = 1.6;         // radius of the round edges of the disc's land

Point(1) = {0, -7, 0};
Point(2) = {root, -7, 0};
Point(3) = {root, neck - root, 0};
Point(4) = {neck, 0, 0};
Point(5) = {neck, 8, 0};
Point(6) = {0, 8, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1 : 6};
Plane Surface(1) = {1};

// The land from (neck + 1, -1) to (root - 1, neck - root + 1); beyond it the disc leaves the blade by 45 degrees at either end.
cut = round * Tan(Pi / 8);           // from a corner to the points where its round edge begins
d = cut / Sqrt(2);
bx = neck + 1;
by = -1;
ex = root - 1;
ey = neck - root + 1;
Point(11) = {0, -16, 0};
Point(12) = {16, -16, 0};
Point(13) = {16, 2, 0};
Point(14) = {bx, 2, 0};
Point(15) = {bx, by + cut, 0};
Point(16) = {bx + round, by + cut, 0};
Point(17) = {bx + d, by - d, 0};
Point(18) = {ex - d, ey + d, 0};
Point(19) = {ex + cut, ey + round, 0};
Point(20) = {ex + cut, ey, 0};
Point(21) = {root + 1.5, ey, 0};
Point(22) = {root + 1.5, -9, 0};
Point(23) = {0, -9, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 15};
Circle(15) = {15, 16, 17};
Line(16) = {17, 18};
Circle(17) = {18, 19, 20};
Line(18) = {20, 21};
Line(19) = {21, 22};
Line(20) = {22, 23};
Line(21) = {23, 11};
Curve Loop(2) = {11 : 21};
Plane Surface(2) = {2};
Delete { Point{16, 19}; }
Physical Surface("blade") = {1};
Physical Curve("blade_flank") = {3};
Physical Curve("blade_top") = {5};
Physical Curve("blade_middle") = {6};
Physical Surface("disc") = {2};
Physical Curve("disc_flank") = {15, 16, 17};
Physical Curve("disc_bottom") = {11};
Physical Curve("disc_side") = {12};
Physical Curve("disc_middle") = {21};
