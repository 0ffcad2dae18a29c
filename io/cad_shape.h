// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/file_format.h"
#include "kernel/error.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class TopoDS_Edge;
class TopoDS_Face;
class TopoDS_Shape;

namespace tapeline {

/// A CAD file in memory, lengths in mm.
struct CadShape {
    std::shared_ptr<const TopoDS_Shape> shape; ///< whole content, placements included; never null
    std::string units;                         ///< length unit of the file ("mm", "inch", …)
    std::vector<std::string> warnings;
};

/// What a caller needs to find in a CAD file.
enum class CadContent {
    faces, ///< a model
    curves ///< a target line: edges, with or without faces
};

/// Reads STEP (AP203, AP214, AP242), IGES or BREP (text or binary). Units are taken from the file; a BREP has none and
/// counts as mm. Fails with ErrorKind::unreadable (not whole, not parsed) or ErrorKind::rejected (nothing of the wanted
/// content in it). The file is parsed in a process of its own, so that a file on which OpenCASCADE breaks down is a
/// failure like any other; nothing is printed.
Result<CadShape> read_cad_shape(const std::filesystem::path& path, FileFormat format,
                                CadContent content = CadContent::faces);

/// The faces and edges of a shape in a fixed numbering: faces as the file's exploration meets them, edges as the faces
/// in that order meet them. A part placed twice has its faces twice.
struct CadFaces {
    std::vector<TopoDS_Face> faces; ///< placed, with the orientation that they have in their shell or solid
    std::vector<int> solid;         ///< per face the number of its solid, -1 = loose face or open shell
    std::vector<TopoDS_Edge> edges; ///< degenerated edges included
    int sewn_edges = 0;             ///< pairs of edges that became one
    double sew_tolerance_mm = 0;    ///< the widest tolerance that joined something
    int dropped_faces = 0;          ///< faces smaller than the sewing tolerance

    CadFaces();
    CadFaces(CadFaces&&) noexcept;
    CadFaces& operator=(CadFaces&&) noexcept;
    ~CadFaces();

    /// Number of an edge in `edges` (orientation does not matter), -1 when it is not there.
    int edge_number(const TopoDS_Edge& edge) const;

    struct Index;
    std::unique_ptr<Index> index; ///< makes `edge_number` quick
};

/// Collects faces and edges, and sews: faces with edges that no neighbour shares are joined where the edges lie within
/// `tolerance_mm`. 0 = 1e-3 mm, then, while edges stay free, ten times wider again and again up to 1e-5 of the
/// model's diagonal. Parts that are closed already are left alone, so touching parts of an assembly stay apart.
Result<CadFaces> collect_faces(const TopoDS_Shape& shape, double tolerance_mm);

} // namespace tapeline
