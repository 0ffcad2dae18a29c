# SPDX-License-Identifier: GPL-3.0-or-later
# tapeline_embed(TARGET NAME=FILE...): puts files into the program, byte for byte. Each is had by
# `std::string_view tapeline::embedded::NAME()`, declared in "<build folder>/embedded.h", which TARGET finds as
# "embedded.h". The assembler copies the bytes, so that a file of a megabyte costs no compile time.
function(tapeline_embed target)
  set(header "// Made by the build: the files embedded in the program.\n#pragma once\n#include <string_view>\n\nnamespace tapeline::embedded {\n")
  set(source "// Made by the build.\n#include \"embedded.h\"\n\n")
  set(files)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/embedded")
  foreach(item IN LISTS ARGN)
    string(FIND "${item}" "=" at)
    string(SUBSTRING "${item}" 0 ${at} name)
    math(EXPR at "${at} + 1")
    string(SUBSTRING "${item}" ${at} -1 file)
    get_filename_component(file "${file}" ABSOLUTE)
    list(APPEND files "${file}")
    string(APPEND header "std::string_view ${name}();\n")
    string(APPEND source
      "asm(\".section .rodata\\n\"\n"
      "    \"tapeline_embedded_${name}: .incbin \\\"${file}\\\"\\n\"\n"
      "    \"tapeline_embedded_${name}_end: .byte 0\\n\"\n"
      "    \".globl tapeline_embedded_${name}, tapeline_embedded_${name}_end\\n\"\n"
      "    \".hidden tapeline_embedded_${name}, tapeline_embedded_${name}_end\\n\"\n"
      "    \".previous\\n\");\n"
      "extern \"C\" const char tapeline_embedded_${name}[], tapeline_embedded_${name}_end[];\n"
      "std::string_view tapeline::embedded::${name}()\n{\n"
      "    return {tapeline_embedded_${name}, tapeline_embedded_${name}_end};\n}\n\n")
  endforeach()
  string(APPEND header "}\n")
  file(CONFIGURE OUTPUT "${folder}/embedded.h" CONTENT "${header}" @ONLY)
  file(CONFIGURE OUTPUT "${folder}/embedded.cpp" CONTENT "${source}" @ONLY)
  set_source_files_properties("${folder}/embedded.cpp" PROPERTIES OBJECT_DEPENDS "${files}"
                              SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE "${folder}/embedded.cpp")
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()
