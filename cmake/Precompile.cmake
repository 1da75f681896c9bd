# What most files of the tests read, compiled once for several folders. The rooms do without: their units are so few that
# what is precompiled would take as long as it saves. A file must name what it uses all the same: without REYE_PRECOMPILE,
# as in the dev preset, it is compiled with nothing else.
option(REYE_PRECOMPILE "precompile the headers that most files of the tests read" ON)

# The files of a room, or of a folder of tests, compiled several at a time, since they need the same headers and templates.
# Names without a namespace of their own are unique in a room for that reason. Who
# works on a room turns it off, as the dev preset does: one file is then compiled at a time, with all warnings.
option(REYE_UNITY "compile several files of a folder at a time" ON)
if(REYE_UNITY)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
  # Names of other files shadow, or seem to be in a header; what is inlined across files seems uninitialised.
  target_compile_options(reye_options INTERFACE -Wno-shadow -Wno-subobject-linkage -Wno-maybe-uninitialized)
endif()

# What a unit of several files needs is in use until its end: to look for what is not takes a tenth of the time and frees a
# fifth of the memory. The largest unit takes 2.5 GB.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(reye_options INTERFACE --param=ggc-min-heapsize=1048576)   # kB
  # Two searches whose time grows faster than the function: a third of what the mortar integrals took to compile, which run as fast.
  target_compile_options(reye_options INTERFACE -fno-gcse-after-reload --param=sccvn-max-alias-queries-per-access=100)
endif()

# reye_unity(<target> [most]): the fewest equal units of at most 48 files, or of as many as are given
function(reye_unity target)
  set(most 48)
  if(ARGC GREATER 1)
    set(most ${ARGV1})
  endif()
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources files)
  math(EXPR units "(${files} + ${most} - 1) / ${most}")
  math(EXPR batch "(${files} + ${units} - 1) / ${units}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${batch})
endfunction()

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
