# SPDX-License-Identifier: GPL-3.0-or-later
# Finds what Debian 12 packages supply; read by the build and, installed, by find_package(Tapeline). Eigen comes before
# CGAL, which looks for it in its own way otherwise.
find_package(Eigen3 3.4 REQUIRED CONFIG)
find_package(CGAL 5.5 REQUIRED CONFIG)
find_package(TBB REQUIRED CONFIG)
find_package(tl-expected REQUIRED CONFIG)
find_package(fmt REQUIRED CONFIG)
find_package(spdlog REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(CLI11 REQUIRED CONFIG)
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)

# OpenCASCADE: its version check accepts only the exact version, so none is asked for; libraries are named one by one.
find_package(OpenCASCADE REQUIRED CONFIG)
add_library(tapeline_occt INTERFACE IMPORTED GLOBAL)
target_include_directories(tapeline_occt SYSTEM INTERFACE "${OpenCASCADE_INCLUDE_DIR}")
target_link_libraries(tapeline_occt INTERFACE
  TKXDESTEP TKXDEIGES TKXCAF TKSTEP TKSTEPAttr TKSTEP209 TKSTEPBase TKIGES TKXSBase TKLCAF TKCAF TKCDF
  TKShHealing TKMesh TKFillet TKBool TKBO TKFeat TKOffset TKPrim TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d
  TKMath TKernel)

# SuiteSparse ships no CMake config.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
add_library(tapeline_cholmod INTERFACE IMPORTED GLOBAL)
target_include_directories(tapeline_cholmod SYSTEM INTERFACE "${CHOLMOD_INCLUDE_DIR}")
target_link_libraries(tapeline_cholmod INTERFACE "${CHOLMOD_LIBRARY}" "${OPENBLAS_LIBRARY}")

# Cairo draws the pictures' lines and text and writes their PNG files.
find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo REQUIRED)
find_library(CAIRO_LIBRARY cairo REQUIRED)
add_library(tapeline_cairo INTERFACE IMPORTED GLOBAL)
target_include_directories(tapeline_cairo SYSTEM INTERFACE "${CAIRO_INCLUDE_DIR}")
target_link_libraries(tapeline_cairo INTERFACE "${CAIRO_LIBRARY}")
