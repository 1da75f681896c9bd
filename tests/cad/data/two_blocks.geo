// A punch [-1, 1] x [0, 2] on a block [-3, 3] x [-2, 0]: source of named.step, whose product names are edited by hand.
SetFactory("OpenCASCADE");
Rectangle(1) = {-1, 0, 0, 2, 2};
Rectangle(2) = {-3, -2, 0, 6, 2};
