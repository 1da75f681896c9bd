# What `cmake --install build --prefix P` puts where. P may be moved as a whole: the program seeks reye-import beside itself and
# the module of gmsh in ../lib/reye, nowhere else.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

install(TARGETS reye reye-import RUNTIME DESTINATION bin)
install(TARGETS reye_gmsh LIBRARY DESTINATION lib/reye)

install(DIRECTORY geo/ DESTINATION share/reye/geo FILES_MATCHING REGEX "\\.(toml|md|csv|geo|msh|step|vtu)$"
        REGEX "\\.(out|sweep)$" EXCLUDE)   # of runs that were started there
install(FILES geo/scene.schema.json DESTINATION share/reye)
configure_file(apps/install/changelog.in changelog @ONLY)
install(FILES README.md LICENSE apps/install/copyright "${PROJECT_BINARY_DIR}/changelog" DESTINATION share/doc/reye)

install(FILES apps/install/reye.1 apps/install/reye-import.1 DESTINATION share/man/man1)
install(FILES apps/install/completion.bash DESTINATION share/bash-completion/completions RENAME reye)

if(TARGET reye_python)
  install(TARGETS reye_python LIBRARY DESTINATION lib/python3/dist-packages/reye)
  install(DIRECTORY apps/python/reye DESTINATION lib/python3/dist-packages FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
endif()
# Examples seek scenes in ../../../geo, here as in the sources.
install(DIRECTORY apps/python/examples DESTINATION share/reye/apps/python FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
