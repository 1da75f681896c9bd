# Every third-party library, found once; which room may name it is decided in src/CMakeLists.txt.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)   # the dev preset is a debug build
find_package(CGAL 5.5 REQUIRED)
find_package(TBB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel IOCore IOXML)

find_path(GMSH_INCLUDE_DIR gmsh.h REQUIRED)
find_library(GMSH_LIBRARY gmsh REQUIRED)
add_library(Gmsh::Gmsh UNKNOWN IMPORTED)
set_target_properties(Gmsh::Gmsh PROPERTIES IMPORTED_LOCATION "${GMSH_LIBRARY}"
                      INTERFACE_INCLUDE_DIRECTORIES "${GMSH_INCLUDE_DIR}")

find_path(SUITESPARSE_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
add_library(SuiteSparse INTERFACE)
target_include_directories(SuiteSparse SYSTEM INTERFACE "${SUITESPARSE_INCLUDE_DIR}")
foreach(component cholmod umfpack amd camd colamd ccolamd suitesparseconfig)
  find_library(SUITESPARSE_${component} ${component} REQUIRED)
  target_link_libraries(SuiteSparse INTERFACE "${SUITESPARSE_${component}}")
endforeach()

find_library(OPENBLAS_LIBRARY openblas REQUIRED)
find_package(OpenMP REQUIRED)   # only to tell CHOLMOD to do without
find_path(CEREAL_INCLUDE_DIR cereal/cereal.hpp REQUIRED)

find_path(MUPARSER_INCLUDE_DIR muParser.h REQUIRED)
find_library(MUPARSER_LIBRARY muparser REQUIRED)

# For `import reye` alone (apps/python), which is left out without them; the package reads TOML by Python's own reader.
# numpy is installed for the interpreter of the system; -DPython_EXECUTABLE=... names another one.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python 3.11 COMPONENTS Interpreter Development.Module)
set(PYBIND11_FINDPYTHON ON)
find_package(pybind11 CONFIG)

if(REYE_MPI)   # MUMPS as Debian's libmumps-dev brings it, over the MPI of mpi-default-dev
  find_package(MPI REQUIRED COMPONENTS C)
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
  find_library(MUMPS_LIBRARY dmumps REQUIRED)
  add_library(Mumps INTERFACE)
  target_include_directories(Mumps SYSTEM INTERFACE "${MUMPS_INCLUDE_DIR}")
  target_link_libraries(Mumps INTERFACE "${MUMPS_LIBRARY}" MPI::MPI_C)
endif()
