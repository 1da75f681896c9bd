// Two boxes with a common face.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, -1, 1, 1, 1};
Box(2) = {0, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
