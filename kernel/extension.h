// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/correspondence.h"
#include "kernel/face_patch.h"
#include "kernel/region.h"

#include <vector>

namespace tapeline {

enum class ExtensionPath {
    geodesic, ///< straight across triangles, which are cut: new vertices are appended (default)
    edges     ///< along mesh edges: nothing is appended
};
enum class ExtensionTarget {
    tapered, ///< the end displacement fades to zero at the rim (method.md A4)
    free     ///< the tension side decides (the paper's Section 5.1)
};

struct ExtensionOptions {
    ExtensionPath path = ExtensionPath::geodesic;
    ExtensionTarget target = ExtensionTarget::tapered;
    bool on_surface = true;    ///< tapered targets are laid back on the model's surface
    bool exact_surface = true; ///< on the exact CAD faces, where the model has them
};

/// A vertex that the geodesic cut put on an edge of the input: position = (1 - t) V[a] + t V[b].
struct AppendedVertex {
    int a = -1;
    int b = -1;
    double t = 0;
};

/// L̂0: the used line prolonged to the rim at both ends, and the model and region with the triangles cut along it.
struct ExtendedLine {
    Model model;               ///< the input's vertices in order, then the appended ones; cut triangles replaced in
                               ///< place by their first part, further parts appended at the end of F
    Region region;             ///< the same region on the new triangles
    std::vector<int> vertices; ///< L̂0 from rim to rim; the used line is vertices[first .. last]
    bool closed = false;       ///< a loop: no extension, first = 0, last = size - 1
    int first = 0;
    int last = 0;
    std::vector<AppendedVertex> appended; ///< in the order of their indices
    /// Targets, one per entry of `vertices`; NaN rows where the extension is free.
    std::vector<Vec3> targets;
    std::vector<VertexPair> features; ///< mesh edges of the model's other feature lines and of kept lines, ascending
    std::vector<std::string> warnings;
};

/// Prolongs the used line to the rim at both ends (Section 5.1; method.md A4): along the rest of the feature line
/// where it goes on (`before`, `after`), then by a geodesic (or along edges) to the rim point near the plane of the
/// end tangent and normal that keeps clear of the line. An end that lies on the rim or on an open border is left as
/// it is. Rejected when no path to the rim exists or when the paths would meet the line or each other.
Result<ExtendedLine> extend_line(const Model& model, const Region& region, const Correspondence& correspondence,
                                 const ExtensionOptions& options = {});

/// The line as it is, with nothing beyond its ends, for methods that keep the region in one piece.
ExtendedLine unextended(const Model& model, const Region& region, const Correspondence& correspondence);

} // namespace tapeline
