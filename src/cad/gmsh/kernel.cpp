#include "cad/meshing/kernel.hpp"

extern "C" const reye::cad::Kernel reye_kernel = {&reye::cad::read_by_gmsh, &reye::cad::fill_by_gmsh};
