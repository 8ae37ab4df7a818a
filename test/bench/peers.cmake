# Peers that are not installed are left out, which the programs say. Of their flags only the include
# folders count: all of us are compiled alike.
pkg_check_modules(BULLET bullet)
pkg_check_modules(FCL fcl>=0.6)
# With pkg-config like the others, because the package does not depend on it.
#catkin_lint: ignore_once misconfigured_catkin_package
pkg_check_modules(GEOMETRIC_SHAPES geometric_shapes)
# Its hulls are those of geometric_shapes. Older versions have theirs in the name.
if(GEOMETRIC_SHAPES_FOUND)
  pkg_search_module(PCL pcl_filters pcl_filters-1.11 pcl_filters-1.10)
endif()
set(peers "")
foreach(peer BULLET FCL GEOMETRIC_SHAPES PCL)
  if(${peer}_FOUND)
    string(TOLOWER ${peer} name)
    string(APPEND peers "${name} ${${peer}_VERSION}, ")
  endif()
endforeach()

# Adds the file of each peer that is beside the program's own files.
function(bench_peers program)
  foreach(peer BULLET FCL GEOMETRIC_SHAPES PCL)
    string(TOLOWER ${peer} name)
    if(${peer}_FOUND AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp")
      target_sources(${program} PRIVATE ${name}.cpp)
      target_compile_definitions(${program} PRIVATE LINK_BOUNDS_WITH_${peer})
      target_include_directories(${program} SYSTEM PRIVATE ${${peer}_INCLUDE_DIRS})
      target_link_libraries(${program} PRIVATE ${${peer}_LINK_LIBRARIES})
    endif()
  endforeach()
  target_compile_definitions(${program} PRIVATE
    LINK_BOUNDS_COMPILER="${compiler} ${flags}"
    LINK_BOUNDS_PEERS="${peers}Eigen ${Eigen3_VERSION}, Google Benchmark ${benchmark_VERSION}")
endfunction()
