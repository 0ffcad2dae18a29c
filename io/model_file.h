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
    double linear_deflection_mm = 0; ///< CAD: chord height; 0 = 1e-4 of the bounding diagonal
    double angular_deflection = 5;   ///< CAD: [deg]
    double sew_tolerance_mm = 0;     ///< CAD: gap that sewing closes; 0 = 1e-3 mm
    double units_mm = 1;             ///< mesh files: length of one file unit [mm]
};

/// What was found and done while reading; every count is 0 when there was nothing.
struct ImportReport {
    std::string format; ///< "STEP", "IGES", "BREP", "STL ascii", "STL binary", "OBJ", "PLY ascii", …
    std::string units;  ///< unit named in the file, or "mm" as given
    int vertices = 0, faces = 0;
    int welded_corners = 0; ///< STL: triangle corners merged into shared vertices
    int triangulated_polygons = 0;
    int degenerate_faces = 0;  ///< fewer than three different corners, or crossing itself: removed
    int duplicate_faces = 0;   ///< removed
    int zero_area_faces = 0;   ///< kept, since a hole would be worse; refused where a region touches one
    int isolated_vertices = 0; ///< in no triangle; kept, so that vertex indices are those of the file
    int flipped_faces = 0;     ///< turned round to make orientation consistent
    int non_manifold_edges = 0, non_manifold_vertices = 0; ///< found; split apart where that is unambiguous
    int non_manifold_edges_left = 0; ///< edges of more than two triangles still there; refused where touched
    int non_orientable_pieces = 0;   ///< one-sided like a Möbius strip; refused where touched
    int border_edges = 0;
    int cad_faces = 0, cad_edges = 0;
    int sewn_edges = 0; ///< CAD: edges joined by sewing; meshes: border edges with equal ends joined
    int faces_without_triangles = 0;
    int folded_triangles = 0;      ///< CAD: lay back to front against the exact surface: put right
    int folded_triangles_left = 0; ///< CAD: still do
    double area_mm2 = 0;           ///< of the triangles
    double exact_area_mm2 = 0;     ///< CAD: of the exact faces
    std::vector<std::string> warnings;
};

struct ImportedModel {
    Model model;
    ImportReport report;
};

/// Reads a model by content (STEP, IGES, BREP, STL, OBJ, PLY, OFF; io/file_format.h tells which).
Result<ImportedModel> read_model(const std::filesystem::path& path, const ImportOptions& options = {});

/// True when the file's content is a CAD format (STEP, IGES, BREP).
bool is_cad_file(const std::filesystem::path& path);

/// The two halves of `read_model`: CAD in io/cad_file.cpp, meshes in io/mesh_file.cpp.
Result<ImportedModel> read_cad(const std::filesystem::path& path, const ImportOptions& options);
/// A mesh is repaired as kernel/repair.h says. Vertex i of OBJ, PLY and OFF files is vertex i of the mesh; STL corners
/// with equal coordinates are welded, vertices then come in the order of their first corner. Fails with
/// ErrorKind::unreadable and the line (text) or byte (binary) of the first mistake.
Result<ImportedModel> read_mesh(const std::filesystem::path& path, const ImportOptions& options = {});

/// A mesh given as arrays, taken as `read_mesh` takes one from a file: coordinates scaled by `options.units_mm`, then
/// repaired; `name` is what messages call it. Rejected when an index or coordinate is out of range.
Result<ImportedModel> take_mesh(std::string_view name, Mesh mesh, const ImportOptions& options = {});

struct ExportOptions {
    bool ascii = false;  ///< STL and PLY: text instead of binary
    double units_mm = 1; ///< length of one file unit [mm]
};
/// Writes by the name's ending: .stl .obj .ply (.off). Doubles keep their value in text (shortest round-trip form)
/// and in PLY; binary STL is float32 by its nature. Written to a temporary file beside the goal, then renamed.
Result<void> write_mesh(const std::filesystem::path& path, const Mesh& mesh, const ExportOptions& options = {});

/// Writes text or bytes in one go: temporary file beside the goal, then rename; nothing is left behind on failure.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content);

} // namespace tapeline
