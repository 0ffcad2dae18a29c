// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <span>
#include <vector>

namespace tapeline::python {

namespace py = pybind11;

/// Makes TapelineError and Cancelled members of the module.
void add_errors(py::module_& module);
/// Raises TapelineError, or Cancelled, with the sentence and the kind's name. Holds the GIL.
[[noreturn]] void raise(const Error& error);

/// The value, or its error as a Python exception.
template <class T>
T value(Result<T> result)
{
    if (!result) {
        raise(result.error());
    }
    if constexpr (!std::is_void_v<T>) {
        return std::move(*result);
    }
}

/// Owner of arrays that show memory of ours: keeps `shared` alive.
template <class T>
py::capsule keep(std::shared_ptr<const T> shared)
{
    using Kept = std::shared_ptr<const T>;
    return py::capsule(new Kept(std::move(shared)), [](void* p) { delete static_cast<Kept*>(p); });
}

/// Arrays that show the memory of `owner` and are not to be written: n×3 doubles, n×3 int32, n int32, n doubles.
py::array shown(const Positions& V, const py::capsule& owner);
py::array shown(const Triangles& F, const py::capsule& owner);
py::array shown(const std::vector<int>& list, const py::capsule& owner);
py::array shown(const std::vector<double>& list, const py::capsule& owner);
/// Arrays with a memory of their own.
py::array copied(std::span<const int> list);
py::array copied(std::span<const double> list);
py::array copied(std::span<const Vec3> points);

/// n×3 numbers of any kind as positions; `what` is what messages call them.
Positions positions_of(const py::object& object, const char* what);
/// m×3 whole numbers of any kind as triangles.
Triangles triangles_of(const py::object& object);
std::vector<Vec3> points_of(const py::object& object, const char* what);

/// The name of a file given as text or path object.
std::string path_text(const py::object& path);

/// Python values as JSON: None, bool, numbers, text, paths, lists, tuples, arrays, dicts. TapelineError (usage) for
/// anything else.
nlohmann::json json_of(const py::handle& object);
py::object object_of(const nlohmann::ordered_json& json);

} // namespace tapeline::python
