# SPDX-License-Identifier: GPL-3.0-or-later
# Installs into a fresh folder and uses the package there.
file(REMOVE_RECURSE "${WORK}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}" --component python
                RESULT_VARIABLE failed OUTPUT_QUIET)
if(failed)
  message(FATAL_ERROR "installing failed")
endif()
foreach(file __init__.py __init__.pyi _tapeline.pyi py.typed)
  if(NOT EXISTS "${WORK}/${FOLDER}/tapeline/${file}")
    message(FATAL_ERROR "${file} was not installed")
  endif()
endforeach()
set(ENV{PYTHONPATH} "${WORK}/${FOLDER}:${CMAKE_CURRENT_LIST_DIR}")
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
execute_process(COMMAND "${PYTHON}" -c "import shapes, tapeline
model, line = shapes.panel()
result = tapeline.move(model, line, slide=10)
assert tapeline.__file__.startswith('${WORK}'), tapeline.__file__
assert result.measures['line_error_max_mm'] < 1e-9" RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the installed package does not work")
endif()
file(REMOVE_RECURSE "${WORK}")
