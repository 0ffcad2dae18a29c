// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/python/objects.h"
#include "plugin/runner/keywords.h"

#include <nlohmann/json.hpp>

PYBIND11_MODULE(_tapeline, module)
{
    using namespace tapeline;
    module.doc() = "The compiled part of the package tapeline.";
    python::add_errors(module);
    module.def(
        "version", [] { return std::string(version()); }, "Version of the program, as 'X.Y.Z'.");
    module.def(
        "options", [] { return python::object_of(options_json()); },
        "list of dict, one per option of commands, jobs and keywords: name, section, type, default, "
        "minimum, maximum, choices, unit, help, zero (what 0 means), count, file, commands.");
    python::add_models(module);
    python::add_targets(module);
    python::add_moves(module);
    python::add_edits(module);
    python::add_comparisons(module);
}
