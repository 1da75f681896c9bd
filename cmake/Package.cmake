# `cpack -G DEB` in the build folder: reye_<version>_<architecture>.deb of what Install.cmake installs.
set(CPACK_PACKAGE_NAME reye)
set(CPACK_PACKAGE_CONTACT "Reye developers <reye@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "wear of frictional contacts by finite elements")
set(CPACK_PACKAGE_DESCRIPTION "Reye computes how frictional contacts wear: from CAD geometry, materials and a
load cycle to the worn shape after many thousand cycles, and to the cycle at
which an allowed wear depth is reached. Bodies are plane, axisymmetric or
solid; contact, Coulomb friction and wear are solved together by a dual mortar
method. Results are a page with pictures, tables and ParaView series.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)   # by dpkg-shlibdeps of dpkg-dev
set(CPACK_DEBIAN_PACKAGE_SUGGESTS paraview)
if(TARGET reye_python)   # a module of one version of the interpreter
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/Compress.cmake")
set(CPACK_GENERATOR DEB)
include(CPack)
