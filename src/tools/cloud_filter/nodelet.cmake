# cloud_filter as a nodelet, where nodelet is installed.
install(FILES ${PROJECT_SOURCE_DIR}/nodelet_plugins.xml
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

# Not by find_package: Debian's pluginlib is that of ROS 2, whose CMake files need all of ament. Its
# headers are in folders named after their packages; only pluginlib needs the last two.
set(nodelet_includes "")
foreach(header nodelet/nodelet.h pluginlib/class_list_macros.hpp class_loader/class_loader.hpp
    rcpputils/shared_library.hpp rcutils/macros.h)
  get_filename_component(package ${header} DIRECTORY)
  find_path(${package}_INCLUDE ${header} PATH_SUFFIXES ${package})
  if(${package}_INCLUDE)
    list(APPEND nodelet_includes ${${package}_INCLUDE})
  endif()
endforeach()
find_library(nodelet_LIBRARY nodeletlib)
find_library(class_loader_LIBRARY class_loader)
if(NOT nodelet_INCLUDE OR NOT pluginlib_INCLUDE OR NOT nodelet_LIBRARY OR NOT class_loader_LIBRARY)
  message(WARNING "cloud_filter is not built as a nodelet, because there is no nodelet or no "
    "pluginlib (libnodeletlib-dev, pluginlib-dev); everything else is")
  return()
endif()
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  message(STATUS "cloud_filter is not built as a nodelet: no manager loads what has a sanitizer")
  return()
endif()

# As in programs, the compiler may inline across functions, because nobody replaces them.
foreach(library ${PROJECT_NAME}_world ${PROJECT_NAME}_node ${PROJECT_NAME}_cloud_filter)
  set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${library} PRIVATE -fno-semantic-interposition)
endforeach()
set(nodelets ${PROJECT_NAME}_nodelets)
add_library(${nodelets} MODULE cloud_filter_nodelet.cpp)
set_target_properties(${nodelets} PROPERTIES PREFIX "")
add_dependencies(${nodelets} mesh_worker)
target_include_directories(${nodelets} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS} ${nodelet_includes})
target_link_libraries(${nodelets} PRIVATE ${PROJECT_NAME}_flags ${PROJECT_NAME}_cloud_filter
  ${nodelet_LIBRARY} ${class_loader_LIBRARY})
# Other libraries in the manager cannot call our functions by accident.
target_link_options(${nodelets} PRIVATE -Wl,--exclude-libs,ALL)
install(TARGETS ${nodelets} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
