#include "cad/meshing/kernel.hpp"

#include "cad/solid/solid_kernel.hpp"

extern "C" const reye::cad::Kernel reye_kernel = {&reye::cad::read_by_gmsh, &reye::cad::fill_by_gmsh,
                                                  &reye::cad::write_step_by_gmsh};
extern "C" const reye::cad::SolidKernel reye_solid_kernel = {&reye::cad::open_by_gmsh, &reye::cad::mesh_by_gmsh,
                                                             &reye::cad::fill_skin_by_gmsh};
