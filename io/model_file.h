// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tapeline {

/// How to read a model. Values of 0 mean: chosen from the model's size.
struct ImportOptions {
    double linear_deflection_mm = 0;    ///< CAD: chord height; 0 = 1e-4 of the bounding diagonal
    double angular_deflection = 5;      ///< CAD: [deg]
    double sew_tolerance_mm = 0;        ///< CAD: gap that sewing closes; 0 = 1e-3 mm
    double units_mm = 1;                ///< mesh files: length of one file unit [mm]
};

/// What was found and done while reading; every count is 0 when there was nothing.
struct ImportReport {
    std::string format;                 ///< "STEP", "IGES", "BREP", "STL ascii", "STL binary", "OBJ", "PLY ascii", …
    std::string units;                  ///< unit named in the file, or "mm" as given
    int vertices = 0, faces = 0;
    int welded_corners = 0;             ///< STL: triangle corners merged into shared vertices
    int triangulated_polygons = 0;
    int degenerate_faces = 0, duplicate_faces = 0, isolated_vertices = 0; ///< found and removed
    int flipped_faces = 0;              ///< turned round to make orientation consistent
    int non_manifold_edges = 0, non_manifold_vertices = 0; ///< found; split apart so that the mesh is manifold
    int border_edges = 0;
    int cad_faces = 0, cad_edges = 0;
    int sewn_edges = 0;                 ///< CAD: edges joined by sewing
    int faces_without_triangles = 0;
    double area_mm2 = 0;                ///< of the triangles
    double exact_area_mm2 = 0;          ///< CAD: of the exact faces
    std::vector<std::string> warnings;
};

struct ImportedModel {
    Model model;
    ImportReport report;
};

/// Reads a model by content (STEP, IGES, BREP, STL, OBJ, PLY, OFF).
Result<ImportedModel> read_model(const std::filesystem::path& path, const ImportOptions& options = {});

/// True when the file's content is a CAD format (STEP, IGES, BREP).
bool is_cad_file(const std::filesystem::path& path);

/// The two halves of `read_model`: CAD in io/cad_file.cpp, meshes in io/mesh_file.cpp.
Result<ImportedModel> read_cad(const std::filesystem::path& path, const ImportOptions& options);
Result<ImportedModel> read_mesh(const std::filesystem::path& path, const ImportOptions& options);

enum class PlyEncoding { ascii, binary_little, binary_big };
struct ExportOptions {
    bool ascii = false; ///< STL and PLY: text instead of binary
    double units_mm = 1; ///< length of one file unit [mm]
};
/// Writes by the name's ending: .stl .obj .ply (.off). Doubles keep their value in text (shortest round-trip form)
/// and in PLY; binary STL is float32 by its nature. Written to a temporary file beside the goal, then renamed.
Result<void> write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ExportOptions& options = {});

/// Writes text or bytes in one go: temporary file beside the goal, then rename; nothing is left behind on failure.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);

} // namespace tapeline
