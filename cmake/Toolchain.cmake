# Compiler flags, ccache and the packages of scripts/packages.txt.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
if(SHADESIM_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

find_package(verilator REQUIRED HINTS $ENV{VERILATOR_ROOT} /usr/share/verilator)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)  # FST waveforms
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(assimp REQUIRED)
pkg_check_modules(systemc REQUIRED IMPORTED_TARGET systemc)
# Through pkg-config: Debian's CMake package of OpenImageIO demands the headers of OpenCV.
pkg_check_modules(openimageio REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO)
add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::openimageio)

set(SHADESIM_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow)

# shadesim_library(name sources...): a static library of the project, included from its root.
function(shadesim_library name)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${SHADESIM_WARNINGS})
endfunction()
