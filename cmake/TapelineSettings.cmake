# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings shared by all targets, and the one function that makes a library of the house.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Without this, ccache would never find a file that uses a precompiled header again.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CCACHE_PROGRAM}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()

# Contracted multiply-adds would make results depend on the processor.
add_compile_options(-ffp-contract=off)

add_library(tapeline_warnings INTERFACE)
target_compile_options(tapeline_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       $<$<BOOL:${TAPELINE_WERROR}>:-Werror>)

# Headers that nearly every source reads; parsing them once a target saves about a third of the build.
set(TAPELINE_COMMON_HEADERS <algorithm> <filesystem> <functional> <string> <vector> <Eigen/Core> <Eigen/Geometry>
                            <fmt/format.h> <tl/expected.hpp>)

# tapeline_library(NAME [HEADER...]): a static library of all .cpp files of the current folder. Further headers are
# precompiled with the common ones.
function(tapeline_library name)
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
  add_library(${name} STATIC ${sources})
  string(REPLACE "tapeline_" "" short_name ${name})
  add_library(Tapeline::${short_name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short_name})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                            $<INSTALL_INTERFACE:include/tapeline>)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:tapeline_warnings>)
  target_precompile_headers(${name} PRIVATE ${TAPELINE_COMMON_HEADERS} ${ARGN})
endfunction()
