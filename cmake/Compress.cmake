# What Debian wants compressed, in the folder of which cpack makes the package.
file(GLOB_RECURSE texts "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/share/man/*.1" "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/share/doc/changelog")
execute_process(COMMAND gzip -9n ${texts} COMMAND_ERROR_IS_FATAL ANY)
