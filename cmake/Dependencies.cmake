# Every dependency is a Debian package; the launcher script lists the package names.
option(SANDGRAPH_TESTS "Build the tests and benchmarks" ON)
string(COMPARE EQUAL "${CMAKE_BUILD_TYPE}" Debug debug_build)
option(SANDGRAPH_CONTRACTS "Check SG_EXPECT and SG_ENSURE (base/contracts.hpp)" ${debug_build})
option(SANDGRAPH_MPI "Share the packings of a run out among processes (engine/mpi); the preset mpi" OFF)
set(SANDGRAPH_SANITIZE "" CACHE STRING "Sanitizers passed to -fsanitize= (empty: none)")

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
find_package(nlohmann_json REQUIRED)

if(SANDGRAPH_MPI)
  find_package(MPI REQUIRED COMPONENTS C)
endif()

# Only training/ uses it; without it everything else is built.
find_package(Torch QUIET)
