// A half cylinder (R = 6, z from 0 to 8) on a block (z from 0 to 10) with a hole (R = 1) along z, mm: source of
// two_solids.step, written by gmsh; its product names are edited by hand.
SetFactory("OpenCASCADE");
Box(1) = {-6, -6, 0, 12, 6, 10};
Cylinder(2) = {3, -3, 0, 0, 0, 10, 1};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 6, 0, 0, 0, 8, 6};
Box(5) = {-6, 6, 0, 12, 6, 8};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
