# The house: rooms in order. A room may include only rooms that stand before it.
# The same list drives the link order and the architecture test.
set(REYE_ROOMS base algebra mesh cad material fem body mortar wear fit contact solver adapt scene sim output)

# Large rooms are divided into floors, folders that are in order, too: a floor includes only itself and floors before it.
set(REYE_FLOORS_mesh solid)
set(REYE_FLOORS_cad part meshing build solid)
set(REYE_FLOORS_fem solid)
set(REYE_FLOORS_body solid)
set(REYE_FLOORS_mortar solid)
set(REYE_FLOORS_contact solid)
set(REYE_FLOORS_solver solid)
set(REYE_FLOORS_adapt shape redraw transfer solid)
set(REYE_FLOORS_scene solid)
set(REYE_FLOORS_sim problem measure place reshape march solid study)
set(REYE_FLOORS_output folder picture report run solid export)
foreach(room IN LISTS REYE_ROOMS)
  string(JOIN "/" order ${room} ${REYE_FLOORS_${room}})
  list(APPEND REYE_HOUSE ${order})   # sim/problem/measure/...: a room and its floors in order
endforeach()

add_library(reye_options INTERFACE)
target_compile_options(reye_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                       -Wno-restrict -Wno-stringop-overread)  # g++ 12 warns falsely about std::string, added or moved
# The rooms are linked into programs and into modules, so all of them are position independent; calls between their own
# functions stay direct.
target_compile_options(reye_options INTERFACE -fPIC -fno-semantic-interposition)
if(REYE_WERROR)
  target_compile_options(reye_options INTERFACE -Werror)
endif()
# libgmsh brings its own build of Eigen: ours must not take the place of its functions, nor share its memory with them.
target_link_options(reye_options INTERFACE "LINKER:--exclude-libs,ALL")
# No table of functions can be written to once the program runs.
target_link_options(reye_options INTERFACE "LINKER:-z,relro,-z,now")
# Rooms that read what others wrote: a fault there ends the program and does not go on. The rooms that compute do without:
# their loops are hot, and what reaches them has been looked over.
set(REYE_READING_ROOMS base mesh cad scene)
add_library(reye_hardened INTERFACE)
target_compile_options(reye_hardened INTERFACE -fstack-protector-strong)
target_compile_definitions(reye_hardened INTERFACE _GLIBCXX_ASSERTIONS $<$<NOT:$<CONFIG:Debug>>:_FORTIFY_SOURCE=2>)
# Rooms that read, decide, draw and write, whose time is that of the rooms, libraries and files that they call: they compile in
# three to four fifths of the time with less optimisation, and run as fast. Of a run `sim` itself takes 0.3 %. `cad` is none of
# them: gmsh asks it for a size at every point.
set(REYE_COLD_ROOMS scene sim output)
add_library(reye_cold INTERFACE)
target_compile_options(reye_cold INTERFACE $<$<CONFIG:Release>:-O1>)
# Rooms that -O3 makes 7 % slower to compile and, by their tests, no faster to run: CGAL's templates, and chains of small vectors.
set(REYE_MILD_ROOMS fit adapt)
add_library(reye_mild INTERFACE)
target_compile_options(reye_mild INTERFACE $<$<CONFIG:Release>:-O2>)
if(REYE_SANITIZE)
  target_compile_options(reye_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(reye_options INTERFACE -fsanitize=address,undefined)
endif()

# Files that read a large library first, so that few units of several files (cmake/Precompile.cmake) read it.
function(reye_heavy_first list)
  foreach(source IN LISTS ${list})
    file(STRINGS "${source}" includes REGEX "#include <(CGAL/|vtk|nlohmann/)")
    if(includes)
      list(APPEND heavy "${source}")
    else()
      list(APPEND light "${source}")
    endif()
  endforeach()
  set(${list} ${heavy} ${light} PARENT_SCOPE)
endfunction()

# reye_room(<name> [libraries private to this room...])
function(reye_room name)
  set(sources)
  foreach(folder "" ${REYE_FLOORS_${name}})
    file(GLOB found CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${folder}/*.cpp")
    list(APPEND sources ${found})
  endforeach()
  reye_heavy_first(sources)
  if(sources)
    add_library(reye_${name} STATIC ${sources})
    reye_unity(reye_${name})
    set(scope PUBLIC)
    set(own PRIVATE)
  else()
    add_library(reye_${name} INTERFACE)
    set(scope INTERFACE)
    set(own INTERFACE)
  endif()
  target_include_directories(reye_${name} ${scope} "${PROJECT_SOURCE_DIR}/src")
  target_link_libraries(reye_${name} ${scope} Eigen3::Eigen)
  target_link_libraries(reye_${name} ${own} reye_options ${ARGN})
  if(name IN_LIST REYE_READING_ROOMS AND sources)
    target_link_libraries(reye_${name} PRIVATE reye_hardened)
  endif()
  if(name IN_LIST REYE_COLD_ROOMS)
    target_link_libraries(reye_${name} PRIVATE reye_cold)
  elseif(name IN_LIST REYE_MILD_ROOMS)
    target_link_libraries(reye_${name} PRIVATE reye_mild)
  endif()
  list(FIND REYE_ROOMS ${name} position)
  if(position GREATER 0)
    math(EXPR previous "${position} - 1")
    list(GET REYE_ROOMS ${previous} below)
    target_link_libraries(reye_${name} ${scope} reye_${below})
  endif()
endfunction()
