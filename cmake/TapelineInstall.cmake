# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` lays down: the command, the libraries with their public headers, and a CMake package, so that
# another project can say find_package(Tapeline) and link Tapeline::runner or one of the layers beneath it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Tapeline")

install(TARGETS tapeline_kernel tapeline_bspline tapeline_io tapeline_runner EXPORT TapelineTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT TapelineTargets NAMESPACE Tapeline:: DESTINATION "${package_dir}")
install(TARGETS tapeline RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")

foreach(folder kernel bspline io plugin/runner)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tapeline/${folder}"
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/resources/schema" DESTINATION "${CMAKE_INSTALL_DATADIR}/tapeline")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# The FreeCAD addon, laid out as in the source folder: link share/tapeline/freecad into FreeCAD's Mod folder.
install(FILES "${PROJECT_SOURCE_DIR}/package.xml" "${PROJECT_SOURCE_DIR}/LICENSE"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/tapeline/freecad")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/plugin/freecad"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/tapeline/freecad/plugin" PATTERN "__pycache__" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/TapelineConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/TapelineConfig.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/TapelineConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/TapelineConfig.cmake" "${PROJECT_BINARY_DIR}/TapelineConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/TapelineDependencies.cmake" DESTINATION "${package_dir}")
