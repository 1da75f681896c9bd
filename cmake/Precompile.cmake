# What most files of a room read, compiled once: it was more than half of the time of a build. A file must name what it uses
# all the same: without REYE_PRECOMPILE, as in the dev preset, it is compiled with nothing else.
option(REYE_PRECOMPILE "precompile the headers that most files read" ON)
if(REYE_PRECOMPILE)   # g++ 12 forgets that what it has precompiled is the system's, and warns falsely about std::string
  target_compile_options(reye_options INTERFACE -Wno-stringop-overflow -Wno-array-bounds)
endif()

set(REYE_COMMON_HEADERS <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <set> <string> <utility> <variant> <vector>
    "${PROJECT_SOURCE_DIR}/src/base/linalg.hpp")

# reye_precompile(<target> [headers of src/ or <...> besides the common ones])
function(reye_precompile target)
  if(NOT REYE_PRECOMPILE)
    return()
  endif()
  set(headers ${REYE_COMMON_HEADERS})
  foreach(header IN LISTS ARGN)
    if(header MATCHES "^<")
      list(APPEND headers "${header}")
    else()
      list(APPEND headers "${PROJECT_SOURCE_DIR}/src/${header}")
    endif()
  endforeach()
  target_precompile_headers(${target} PRIVATE ${headers})
endfunction()

# reye_precompiled_as(<target> <other>): with the headers of another target, whose options must be the same
function(reye_precompiled_as target other)
  if(REYE_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
