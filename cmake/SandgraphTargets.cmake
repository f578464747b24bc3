# One static library per folder of the architecture, one test program per tests/ folder.
# Bitwise repeatability asks that no translation unit contracts or reorders on its own whim.
add_library(sandgraph_flags INTERFACE)
target_compile_options(sandgraph_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -fno-math-errno
                       -ffp-contract=off)
target_include_directories(sandgraph_flags INTERFACE ${CMAKE_SOURCE_DIR}/engine ${CMAKE_SOURCE_DIR})
target_compile_definitions(sandgraph_flags INTERFACE EIGEN_MPL2_ONLY)
if(SANDGRAPH_CONTRACTS)
  target_compile_definitions(sandgraph_flags INTERFACE SANDGRAPH_CONTRACTS=1)
endif()
if(SANDGRAPH_SANITIZE)
  target_compile_options(sandgraph_flags INTERFACE -fsanitize=${SANDGRAPH_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_link_options(sandgraph_flags INTERFACE -fsanitize=${SANDGRAPH_SANITIZE})
endif()
# The kernels once, not for every instruction set: sanitized they take ten minutes to compile.
if(SANDGRAPH_SANITIZE AND NOT SANDGRAPH_SANITIZE MATCHES "fuzzer")
  target_compile_definitions(sandgraph_flags INTERFACE HWY_COMPILE_ONLY_STATIC)
endif()

# sandgraph_kernel(fast_kernel.cpp): a file of Highway loops. Sanitized it is compiled for this machine, for Highway's
# baseline is scalar: many times slower, and not what users run. Eigen keeps the alignment of the other files.
function(sandgraph_kernel file)
  if(SANDGRAPH_SANITIZE AND NOT SANDGRAPH_SANITIZE MATCHES "fuzzer")
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS
                                "-march=native;-DEIGEN_MAX_ALIGN_BYTES=16;-DEIGEN_MAX_STATIC_ALIGN_BYTES=16")
  endif()
endfunction()

# sandgraph_library(dem LINK base ...): library sg_<name> from every .cpp of the current folder.
function(sandgraph_library name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(NOT sources)  # a folder of headers only
    add_library(sg_${name} INTERFACE)
    target_link_libraries(sg_${name} INTERFACE sandgraph_flags ${ARG_LINK})
    return()
  endif()
  add_library(sg_${name} STATIC ${sources})
  target_link_libraries(sg_${name} PUBLIC sandgraph_flags ${ARG_LINK})
endfunction()

# sandgraph_program(main.cpp LINK sg_app): what users start.
function(sandgraph_program main)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(sandgraph ${main})
  target_link_libraries(sandgraph PRIVATE ${ARG_LINK})
  set_target_properties(sandgraph PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
endfunction()

# The tiers of tests are labels of ctest: `unit` (all of it in half a minute on two cores, without libtorch), `physics`,
# `slow`, and `mpi`, which only the preset of that name has. A target tests_<tier> builds what `ctest -L <tier>` runs.
foreach(tier unit physics slow mpi)
  add_custom_target(tests_${tier})
endforeach()

# sandgraph_tier(unit test_unit_dem unit/dem [TEST_FILTER Rve.*]): tests of a program, or those of a filter, are a tier's.
function(sandgraph_tier tier program prefix)
  gtest_discover_tests(${program} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_PREFIX "${prefix}:"
                       ${ARGN} PROPERTIES LABELS ${tier})
  add_dependencies(tests_${tier} ${program})
endfunction()

# sandgraph_test(unit/dem LINK sg_dem ... [TIER slow] [PHYSICS Rve.LongOne ...]): program test_unit_dem from every .cpp of
# tests/unit/dem. Its tier is the first folder's name unless told; tests named after PHYSICS take too long for it. Those
# that start the program (OUTSIDE) wait for it.
function(sandgraph_test folder)
  cmake_parse_arguments(ARG "OUTSIDE" "TIER" "LINK;PHYSICS" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${ARG_LINK} test_paths GTest::gtest GTest::gtest_main)
  if(ARG_OUTSIDE)
    add_dependencies(test_${name} sandgraph)
  endif()
  if(NOT ARG_TIER)
    string(REGEX MATCH "^[a-z]+" ARG_TIER ${folder})
  endif()
  if(NOT ARG_PHYSICS)
    sandgraph_tier(${ARG_TIER} test_${name} ${folder})
    return()
  endif()
  list(JOIN ARG_PHYSICS ":" long)
  sandgraph_tier(${ARG_TIER} test_${name} ${folder} TEST_FILTER "-${long}")
  sandgraph_tier(physics test_${name} ${folder} TEST_FILTER "${long}")
endfunction()
