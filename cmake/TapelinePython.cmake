# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's Python, whose numpy and FreeCAD go with its packages; another one may come first on PATH.
if(NOT TAPELINE_PYTHON)
  return()
endif()
set(PYBIND11_FINDPYTHON ON)
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is built for")
endif()
find_package(pybind11 2.10 CONFIG QUIET)
if(NOT pybind11_FOUND)
  message(STATUS "Python module: none, pybind11 was not found (Debian: pybind11-dev python3-dev)")
  set(TAPELINE_PYTHON OFF)
endif()
