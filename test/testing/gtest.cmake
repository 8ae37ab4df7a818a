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

# Several sources at a time, which takes less time than one by one.
function(compile_together program)
  if(NOT DEFINED LINK_BOUNDS_UNITY_BUILD OR LINK_BOUNDS_UNITY_BUILD)
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON)
  endif()
endfunction()

# A program of the given sources, linked with what its room may know.
function(bounds_test_program program)
  catkin_add_executable_with_gtest(${program} $<TARGET_OBJECTS:${PROJECT_NAME}_gtest_main> ${ARGN}
    EXCLUDE_FROM_ALL)
  target_include_directories(${program} PRIVATE ${bounds_test_folder})
  target_include_directories(${program} SYSTEM PRIVATE ${catkin_INCLUDE_DIRS})
  target_compile_options(${program} PRIVATE ${LINK_BOUNDS_TEST_FLAGS})
  target_link_libraries(${program} ${PROJECT_NAME}_flags ${room_libraries} ${CMAKE_DL_LIBS})
  target_precompile_headers(${program} REUSE_FROM ${PROJECT_NAME}_gtest_main)
  add_dependencies(tests ${program})
endfunction()

# The test NAME: a process of the program with these arguments.
function(bounds_test_of name program)
  name_in_room(${name}_test test)
  set(xml gtest-${test}.xml)
  catkin_run_tests_target(gtest ${test} ${xml} COMMAND
    "$<TARGET_FILE:${program}> ${ARGN} --gtest_output=xml:${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/${xml}"
    DEPENDENCIES ${program} WORKING_DIRECTORY ${bounds_test_folder})
  # catkin gives the test a longer name. The code is that of gtest_main.cpp.
  foreach(ctest ${test} _ctest_${PROJECT_NAME}_gtest_${test})
    if(TEST ${ctest})
      set_tests_properties(${ctest} PROPERTIES SKIP_RETURN_CODE 4)
    endif()
  endforeach()
endfunction()

# A test of NAME_test.cpp and further sources, in a program of its own.
function(bounds_gtest name)
  name_in_room(${name}_test program)
  bounds_test_program(${program} ${name}_test.cpp ${ARGN})
  bounds_test_of(${name} ${program})
endfunction()

# A test of each NAME_test.cpp, which runs what stands in it. They are one program, which is compiled and
# linked in less time than many.
function(bounds_gtests)
  name_in_room(tests program)
  set(sources ${ARGN})
  list(TRANSFORM sources APPEND _test.cpp)
  bounds_test_program(${program} ${sources})
  compile_together(${program})
  foreach(name ${ARGN})
    bounds_test_of(${name} ${program} --file=${name}_test.cpp)
  endforeach()
endfunction()
