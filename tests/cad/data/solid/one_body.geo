// Two boxes with a common face that are one body.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, -1, 1, 1, 1};
Box(2) = {0, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("both") = {1, 2};
