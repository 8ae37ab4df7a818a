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

# Adds the files of each peer, and what the reports say about it and the build.
function(add_peers program)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} -std=c++17 -ffp-contract=off")
  set(peers "")
  foreach(peer BULLET FCL GEOMETRIC_SHAPES PCL)
    string(TOLOWER ${peer} name)
    if(${peer}_FOUND)
      string(APPEND peers "${name} ${${peer}_VERSION}, ")
      file(GLOB files ${CMAKE_CURRENT_SOURCE_DIR}/*/${name}.cpp)
      target_sources(${program} PRIVATE ${files})
      target_compile_definitions(${program} PRIVATE LINK_BOUNDS_WITH_${peer})
      target_include_directories(${program} SYSTEM PRIVATE ${${peer}_INCLUDE_DIRS})
      target_link_libraries(${program} PRIVATE ${${peer}_LINK_LIBRARIES})
    else()
      string(APPEND peers "no ${name}, ")
    endif()
  endforeach()
  target_compile_definitions(${program} PRIVATE
    LINK_BOUNDS_COMPILER="${compiler} ${flags}"
    LINK_BOUNDS_PEERS="${peers}Eigen ${Eigen3_VERSION}, Google Benchmark ${benchmark_VERSION}")
endfunction()

# Adds the program that uses rosbag's own reader, which may be missing, as bag.py says. Its files for
# CMake and pkg-config do not work on Debian 12, where headers of pluginlib are a folder deeper.
function(add_rosbag_reader program file)
  find_path(ROSBAG_FOLDER rosbag/view.h PATHS ${catkin_INCLUDE_DIRS})
  find_library(ROSBAG_STORAGE rosbag_storage PATHS ${catkin_LIBRARY_DIRS})
  if(NOT ROSBAG_FOLDER OR NOT ROSBAG_STORAGE)
    return()
  endif()
  set(CMAKE_REQUIRED_INCLUDES ${ROSBAG_FOLDER} ${catkin_INCLUDE_DIRS})
  foreach(folder pluginlib class_loader rcutils rcpputils ament_index_cpp)
    if(EXISTS "${ROSBAG_FOLDER}/${folder}/${folder}")
      list(APPEND CMAKE_REQUIRED_INCLUDES ${ROSBAG_FOLDER}/${folder})
    endif()
  endforeach()
  set(CMAKE_REQUIRED_FLAGS -std=c++17)
  include(CheckIncludeFileCXX)
  check_include_file_cxx(rosbag/view.h HAS_ROSBAG_VIEW)
  if(HAS_ROSBAG_VIEW)
    add_executable(${program} ${file})
    target_compile_definitions(${program} PRIVATE LINK_BOUNDS_WITH_ROSBAG)
    target_include_directories(${program} SYSTEM PRIVATE ${CMAKE_REQUIRED_INCLUDES})
    target_link_libraries(${program} PRIVATE ${PROJECT_NAME}_flags ${catkin_LIBRARIES}
      ${ROSBAG_STORAGE})
  endif()
endfunction()
