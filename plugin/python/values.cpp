// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/python/values.h"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace tapeline::python {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

PyObject* tapeline_error = nullptr;
PyObject* cancelled_error = nullptr;

const char* kind_name(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::usage:
        return "usage";
    case ErrorKind::unreadable:
        return "unreadable";
    case ErrorKind::rejected:
        return "rejected";
    case ErrorKind::not_converged:
        return "not_converged";
    case ErrorKind::quality_gate:
        return "quality_gate";
    case ErrorKind::cancelled:
        break;
    }
    return "cancelled";
}

py::array read_only(py::array array)
{
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

template <class T>
py::array table(const T* data, Eigen::Index rows, const py::capsule& owner)
{
    return read_only(py::array_t<T>(std::vector<py::ssize_t>{rows, 3}, data, owner));
}

template <class T>
py::array list_of(const std::vector<T>& list, const py::capsule& owner)
{
    return read_only(py::array_t<T>(static_cast<py::ssize_t>(list.size()), list.data(), owner));
}

[[noreturn]] void refuse(const std::string& sentence) { raise({ErrorKind::usage, sentence}); }

/// The object as an n×3 array of one of these kinds of numbers.
py::array table_of(const py::object& object, const char* what, const char* kinds)
{
    py::array array = py::array::ensure(object);
    if (!array) {
        PyErr_Clear();
        refuse(fmt::format("{} must be an array of shape (n, 3)", what));
    }
    if (array.ndim() != 2 || array.shape(1) != 3) {
        refuse(fmt::format("{} must be an array of shape (n, 3)", what));
    }
    if (std::string_view(kinds).find(array.dtype().kind()) == std::string_view::npos) {
        refuse(fmt::format("{} must be an array of {}", what, kinds[0] == 'f' ? "numbers" : "whole numbers"));
    }
    return array;
}

} // namespace

void add_errors(py::module_& module)
{
    // Never released: exceptions may outlive the module.
    tapeline_error = PyErr_NewExceptionWithDoc("tapeline.TapelineError",
                                               "A failure: str() is one sentence on what, where and what to do; `kind` "
                                               "is one of 'usage', 'unreadable', 'rejected', 'not_converged', "
                                               "'quality_gate', 'cancelled'.",
                                               PyExc_Exception, nullptr);
    cancelled_error = PyErr_NewExceptionWithDoc("tapeline.Cancelled", "The call was cancelled; nothing was changed.",
                                                tapeline_error, nullptr);
    py::handle(tapeline_error).attr("kind") = "rejected";
    module.attr("TapelineError") = py::handle(tapeline_error);
    module.attr("Cancelled") = py::handle(cancelled_error);
}

void raise(const Error& error)
{
    const py::handle type = error.kind == ErrorKind::cancelled ? cancelled_error : tapeline_error;
    const py::object exception = type(py::str(py::bytes(error.message).attr("decode")("utf-8", "replace")));
    exception.attr("kind") = kind_name(error.kind);
    PyErr_SetObject(type.ptr(), exception.ptr());
    throw py::error_already_set();
}

py::array shown(const Positions& V, const py::capsule& owner) { return table(V.data(), V.rows(), owner); }
py::array shown(const Triangles& F, const py::capsule& owner) { return table(F.data(), F.rows(), owner); }
py::array shown(const std::vector<int>& list, const py::capsule& owner) { return list_of(list, owner); }
py::array shown(const std::vector<double>& list, const py::capsule& owner) { return list_of(list, owner); }

py::array copied(std::span<const int> list)
{
    return py::array_t<int>(static_cast<py::ssize_t>(list.size()), list.data());
}

py::array copied(std::span<const double> list)
{
    return py::array_t<double>(static_cast<py::ssize_t>(list.size()), list.data());
}

py::array copied(std::span<const Vec3> points)
{
    py::array_t<double> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(points.size()), 3});
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::copy_n(points[i].data(), 3, array.mutable_data(static_cast<py::ssize_t>(i), 0));
    }
    return array;
}

Positions positions_of(const py::object& object, const char* what)
{
    const auto doubles =
        py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(table_of(object, what, "fiu"));
    return Eigen::Map<const Positions>(doubles.data(), doubles.shape(0), 3);
}

Triangles triangles_of(const py::object& object)
{
    const auto wide = py::array_t<long long, py::array::c_style | py::array::forcecast>::ensure(
        table_of(object, "the triangles", "iu"));
    Triangles F(wide.shape(0), 3);
    for (py::ssize_t k = 0; k < wide.size(); ++k) {
        const long long v = wide.data()[k];
        // Out of an int's range is out of any mesh's: the reader of the mesh names the triangle.
        F.data()[k] = v < 0 || v > std::numeric_limits<int>::max() ? -1 : static_cast<int>(v);
    }
    return F;
}

std::vector<Vec3> points_of(const py::object& object, const char* what)
{
    const Positions V = positions_of(object, what);
    std::vector<Vec3> points(static_cast<std::size_t>(V.rows()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = V.row(static_cast<Eigen::Index>(i));
    }
    return points;
}

std::string path_text(const py::object& path)
{
    return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

json json_of(const py::handle& object)
{
    if (object.is_none()) {
        return nullptr;
    }
    if (py::isinstance<py::bool_>(object)) {
        return object.cast<bool>();
    }
    if (py::isinstance<py::int_>(object)) {
        int overflow = 0;
        const long long whole = PyLong_AsLongLongAndOverflow(object.ptr(), &overflow);
        return overflow != 0 ? json(PyLong_AsDouble(object.ptr()))
               : whole >= 0  ? json(static_cast<std::uint64_t>(whole))
                             : json(whole);
    }
    if (py::isinstance<py::float_>(object)) {
        return object.cast<double>();
    }
    if (py::isinstance<py::str>(object)) {
        return object.cast<std::string>();
    }
    if (py::isinstance<py::dict>(object)) {
        json fields = json::object();
        for (const auto& [key, field] : py::reinterpret_borrow<py::dict>(object)) {
            fields[py::str(key).cast<std::string>()] = json_of(field);
        }
        return fields;
    }
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
        json list = json::array();
        for (const py::handle entry : object) {
            list.push_back(json_of(entry));
        }
        return list;
    }
    if (py::hasattr(object, "__fspath__")) {
        return json_of(object.attr("__fspath__")());
    }
    // Arrays and scalars of numpy.
    if (py::hasattr(object, "tolist")) {
        return json_of(object.attr("tolist")());
    }
    refuse(fmt::format("a value of type {} means nothing here; give a number, a text, a path, a list or None",
                       py::str(py::type::of(object).attr("__name__")).cast<std::string>()));
}

py::object object_of(const ordered_json& json)
{
    switch (json.type()) {
    case ordered_json::value_t::boolean:
        return py::bool_(json.get<bool>());
    case ordered_json::value_t::number_integer:
    case ordered_json::value_t::number_unsigned:
        return py::int_(json.get<long long>());
    case ordered_json::value_t::number_float:
        return py::float_(json.get<double>());
    case ordered_json::value_t::string:
        return py::bytes(json.get_ref<const std::string&>()).attr("decode")("utf-8", "replace");
    case ordered_json::value_t::array: {
        py::list list;
        for (const ordered_json& entry : json) {
            list.append(object_of(entry));
        }
        return list;
    }
    case ordered_json::value_t::object: {
        py::dict dict;
        for (const auto& [key, entry] : json.items()) {
            dict[py::str(key)] = object_of(entry);
        }
        return dict;
    }
    default:
        return py::none();
    }
}

} // namespace tapeline::python
