# SPDX-License-Identifier: GPL-3.0-or-later
# pip makes a wheel of the source tree, with what is built already, and the module in it works.
execute_process(COMMAND "${PYTHON}" -c "import setuptools, wheel, pip" RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
if(missing)
  message(STATUS "skipped: this Python has no pip, setuptools or wheel")
  return()
endif()
file(REMOVE_RECURSE "${WORK}" "${SOURCE}/build/pip")
set(ENV{TAPELINE_BUILD} "${BUILD}")
execute_process(COMMAND "${PYTHON}" -m pip install --no-index --no-deps --no-build-isolation --no-cache-dir
                        --disable-pip-version-check --target "${WORK}/site" "${SOURCE}"
                RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "pip failed: ${said}")
endif()
set(ENV{PYTHONPATH} "${WORK}/site:${CMAKE_CURRENT_LIST_DIR}")
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
execute_process(COMMAND "${PYTHON}" -c "import importlib.metadata, os, shapes, tapeline
assert tapeline.__file__.startswith('${WORK}'), tapeline.__file__
assert importlib.metadata.version('tapeline') == tapeline.__version__
assert {'py.typed', '_tapeline.pyi'} <= set(os.listdir(os.path.dirname(tapeline.__file__)))
model, line = shapes.panel()
assert tapeline.move(model, line, slide=10).measures['line_error_max_mm'] < 1e-9" RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the module that pip installed does not work")
endif()
file(REMOVE_RECURSE "${WORK}" "${SOURCE}/build/pip")
