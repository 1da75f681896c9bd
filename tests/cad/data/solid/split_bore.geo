// Half of a bush (bore R = 10, outside R = 16, 10 long) whose round faces are in two parts each, as a seam leaves them.
SetFactory("OpenCASCADE");
Cylinder(4) = {0, 0, 0, 0, 0, 10, 16};
Cylinder(5) = {0, 0, 0, 0, 0, 10, 10};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
Box(7) = {0, -20, 0, 20, 40, 10};
BooleanIntersection(8) = { Volume{6}; Delete; }{ Volume{7}; Delete; };
