// A box: no body of a plane scene.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
