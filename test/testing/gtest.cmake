# Unit tests, named by their room.
# After all others: what is tested has flags of its own, the tests only have to be built soon.
set(LINK_BOUNDS_TEST_FLAGS -O1 CACHE STRING "compiler flags of the tests' own code")
get_filename_component(bounds_test_folder ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)

# The name of a target or test in the room that the current folder is.
function(name_in_room name result)
  file(RELATIVE_PATH room ${bounds_test_folder} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" target ${room}_${name})
  set(${result} ${target} PARENT_SCOPE)
endfunction()

# NAME_test.cpp and further sources, linked with what its room may know.
function(bounds_gtest name)
  name_in_room(${name}_test target)
  catkin_add_gtest(${target} $<TARGET_OBJECTS:${PROJECT_NAME}_gtest_main> ${name}_test.cpp ${ARGN}
    WORKING_DIRECTORY ${bounds_test_folder})
  target_include_directories(${target} PRIVATE ${bounds_test_folder})
  target_include_directories(${target} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
  target_compile_options(${target} PRIVATE ${LINK_BOUNDS_TEST_FLAGS})
  target_link_libraries(${target} ${PROJECT_NAME}_flags ${room_libraries} ${CMAKE_DL_LIBS})
  target_precompile_headers(${target} REUSE_FROM ${PROJECT_NAME}_gtest_main)
  # catkin gives the test a longer name. The code is that of gtest_main.cpp.
  foreach(test ${target} _ctest_${PROJECT_NAME}_gtest_${target})
    if(TEST ${test})
      set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 4)
    endif()
  endforeach()
endfunction()
