# smd_add_test(name [LINK library...] [LABELS label...]): the GoogleTest program name.cpp.
# For each label there is a target of that name that builds the programs that carry it.
function(smd_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK;LABELS")
  add_executable(${name} ${name}.cpp)
  smd_link_program(${name} GTest::gtest_main ${arg_LINK})
  # to compile takes longer than to run
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  smd_register_test(${name} LABELS ${arg_LABELS})
endfunction()

function(smd_register_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LABELS")
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
  # gtest_discover_tests() cannot pass on more than one label
  set(labels_file ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
  file(CONFIGURE OUTPUT ${labels_file} @ONLY CONTENT
    "if(@name@_TESTS)\n  set_tests_properties(\${@name@_TESTS} PROPERTIES LABELS \"@arg_LABELS@\")\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${labels_file})
  smd_add_to_label_targets(${name} ${arg_LABELS})
endfunction()

function(smd_add_to_label_targets name)
  foreach(label IN LISTS ARGN)
    if(NOT TARGET ${label})
      add_custom_target(${label})
    endif()
    add_dependencies(${label} ${name})
  endforeach()
endfunction()

# smd_add_compile_failure_test(name source message [ERRORS n]): compiling `source` gives an error
# that matches the regular expression `message`, and n errors in all.
function(smd_add_compile_failure_test name source message)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "ERRORS" "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  smd_link_program(${name})
  smd_expect_compile_failure(${name} "${message}" "${arg_ERRORS}")
endfunction()

# The same of an existing target: each of its sources gives the message once, and n errors.
function(smd_expect_compile_failure target message errors)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources number_of_sources)
  add_test(NAME ${target} COMMAND ${CMAKE_COMMAND}
    -D BUILD_DIR=${CMAKE_BINARY_DIR} -D CONFIG=$<CONFIG> -D TARGET=${target} -D MESSAGE=${message}
    -D GENERATOR=${CMAKE_GENERATOR} -D SOURCES=${number_of_sources} -D ERRORS=${errors}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_compile_failure.cmake)
  # builds inside one build tree must not meet
  set_tests_properties(${target} PROPERTIES RESOURCE_LOCK build_tree LABELS compatibility)
endfunction()

set(SMD_SAME_TOOLS
  -D CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -D CMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
  -D CMAKE_BUILD_TYPE=Debug -D CGAL_DIR=${CGAL_DIR}) # Debug compiles fastest

# smd_add_install_test(name [option...]): configures the package anew, with the options, and installs
# it into the folder name/prefix, for the tests that require the fixture `name`.
function(smd_add_install_test name)
  set(scratch ${CMAKE_CURRENT_BINARY_DIR}/${name})
  add_test(NAME ${name}_clean COMMAND ${CMAKE_COMMAND} -E rm -rf ${scratch})
  add_test(NAME ${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${PROJECT_SOURCE_DIR} ${scratch}/build
    --build-generator ${CMAKE_GENERATOR} --build-target install
    --build-options ${SMD_SAME_TOOLS} ${ARGN} -D CMAKE_INSTALL_PREFIX=${scratch}/prefix
      -D SMD_BUILD_TESTING=OFF -D SMD_BUILD_EXAMPLES=OFF -D SMD_BUILD_BENCHMARKS=OFF)
  set_tests_properties(${name}_clean PROPERTIES FIXTURES_SETUP ${name}_clean)
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED ${name}_clean FIXTURES_SETUP ${name})
endfunction()

# smd_add_outside_project_test(name option...): configures the outside project with the options,
# builds it and runs its program.
function(smd_add_outside_project_test name)
  add_test(NAME ${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/outside_project ${CMAKE_CURRENT_BINARY_DIR}/${name}
    --build-generator ${CMAKE_GENERATOR} --build-options ${SMD_SAME_TOOLS} ${ARGN}
    --test-command main)
endfunction()
