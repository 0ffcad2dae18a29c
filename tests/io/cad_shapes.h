// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/model_file.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <gp_Trsf.hxx>
#include <string>
#include <vector>

namespace tapeline::testing {

/// A folder of its own below the test's temporary folder, removed at the end.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

void write_brep(const std::filesystem::path& path, const TopoDS_Shape& shape);
/// `unit`: "MM", "INCH", "M". A compound becomes an assembly of its parts.
void write_step(const std::filesystem::path& path, const TopoDS_Shape& shape, const char* unit = "MM");
void write_iges(const std::filesystem::path& path, const TopoDS_Shape& shape);

TopoDS_Shape compound_of(const std::vector<TopoDS_Shape>& shapes);
/// The same shape at another place; mirrors are allowed.
TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement);
/// The flat rectangle [x0, x1] × [y0, y1] at height z, facing up, with edges of its own.
TopoDS_Face rectangle(double x0, double y0, double x1, double y1, double z = 0);

/// Enclosed volume by the divergence theorem, positive when triangles face outward [mm³].
double enclosed_volume(const Mesh& mesh);
/// Number of pieces that hang together by edges.
int component_count(const Mesh& mesh);

/// TAPELINE_DATA/models/NAME; empty when the variable is not set.
std::filesystem::path data_file(const std::string& name);

} // namespace tapeline::testing
