#include "cad/import/script_words.hpp"

#include <algorithm>
#include <iterator>

namespace reye::cad {

namespace {

constexpr std::string_view words[] = {
    // order of events
    "If", "ElseIf", "Else", "EndIf", "For", "In", "EndFor", "Macro", "Function", "Return", "Call", "SetFactory",
    "Include", "Printf", "DefineConstant",
    // how DefineConstant describes a number
    "Name", "Min", "Max", "Step", "Range", "Choices", "Label", "Help", "Visible", "ReadOnly", "Highlight",
    // entities
    "Point", "Line", "Curve", "Circle", "Ellipse", "Spline", "BSpline", "Bezier", "CatmullRom", "Nurbs", "Knots",
    "Order", "Wire", "Loop", "Plane", "Ruled", "Surface", "Volume", "Rectangle", "Disk", "Box", "Block", "Sphere",
    "Cylinder", "Cone", "Torus", "Wedge", "Compound", "Physical", "Boundary", "CombinedBoundary", "PointsOf",
    "BoundingBox", "Parent", "Unique", "Physicals",
    // what is done to them
    "Extrude", "Layers", "Recombine", "Translate", "Rotate", "Dilate", "Affine", "Symmetry", "Duplicata", "Intersect",
    "Split", "Fillet", "Chamfer", "ThruSections", "BooleanUnion", "BooleanFuse", "BooleanIntersection", "BooleanCommon",
    "BooleanDifference", "BooleanCut", "BooleanFragments", "BooleanCoherence", "BooleanSection", "Delete", "Recursive",
    "Coherence", "Reverse", "ReverseMesh",
    // sizes
    "MeshSize", "Characteristic", "Length", "Transfinite", "Using", "Progression", "Bump", "Left", "Right", "Alternate",
    "AlternateLeft", "AlternateRight", "Periodic", "Smoother", "MeshAlgorithm", "Mesh", "Geometry", "General", "Field",
    "Background", "Attractor", "Distance", "Threshold", "Ball", "Frustum", "MathEval", "Restrict", "Constant",
    // numbers
    "Pi", "newp", "newc", "newl", "newcl", "newll", "news", "newsl", "newv", "newf", "newreg", "Abs", "Fabs", "Sqrt",
    "Exp", "Log", "Log10", "Sin", "Cos", "Tan", "Asin", "Acos", "Atan", "Atan2", "ArcSin", "ArcCos", "ArcTan",
    "ArcTan2", "Sinh", "Cosh", "Tanh", "Hypot", "Floor", "Ceil", "Round", "Fmod", "Modulo", "LinSpace", "LogSpace",
    "List", "Exists", "Find", "Str", "StrCat", "Sprintf"};

constexpr std::string_view field_options[] = {"CurvesList",
                                              "EdgesList",
                                              "PointsList",
                                              "NodesList",
                                              "SurfacesList",
                                              "FacesList",
                                              "NumPointsPerCurve",
                                              "Sampling",
                                              "NNodesByEdge",
                                              "InField",
                                              "IField",
                                              "FieldsList",
                                              "SizeMin",
                                              "SizeMax",
                                              "DistMin",
                                              "DistMax",
                                              "LcMin",
                                              "LcMax",
                                              "Sigmoid",
                                              "StopAtDistMax",
                                              "VIn",
                                              "VOut",
                                              "XMin",
                                              "XMax",
                                              "YMin",
                                              "YMax",
                                              "ZMin",
                                              "ZMax",
                                              "Thickness",
                                              "Radius",
                                              "XCenter",
                                              "YCenter",
                                              "ZCenter",
                                              "XAxis",
                                              "YAxis",
                                              "ZAxis",
                                              "F"};

}  // namespace

bool is_allowed_word(std::string_view word) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

bool is_allowed_option(std::string_view group, std::string_view option) {
  return group == "Mesh" || group == "Geometry" ||
         (group == "General" && (option == "Terminal" || option == "Verbosity"));
}

bool is_allowed_field_option(std::string_view option) {
  return std::find(std::begin(field_options), std::end(field_options), option) != std::end(field_options);
}

}  // namespace reye::cad
