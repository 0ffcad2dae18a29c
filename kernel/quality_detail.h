// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/closest_point.h"
#include "kernel/exact_sheet.h"
#include "kernel/quality.h"
#include "kernel/topology.h"

#include <memory>
#include <optional>
#include <vector>

/// Inside of kernel/quality: what the measures share. Not for other modules.
namespace tapeline::quality {

enum class SideOf : char { none, compressed, tension };

/// What depends on the rest mesh alone.
struct RestShape {
    explicit RestShape(const Mesh& rest);

    Topology topology;
    Positions normals;                        ///< per triangle: unit normal, zero without area
    std::vector<double> areas;                ///< per triangle [mm²]
    std::optional<ClosestPoint> surface = {}; ///< of all triangles, where it is worth keeping
    std::optional<ExactSheet> exact = {};     ///< the same with their CAD faces
};

/// The input with what several measures need of it, computed once. `rest_shape`: of the input's rest mesh, made here
/// when there is none.
struct Context {
    explicit Context(const QualityInput& quality_input, std::shared_ptr<const RestShape> rest_shape = nullptr);

    const QualityInput& input;
    const Mesh& rest;
    Mesh moved;
    std::shared_ptr<const RestShape> shape;
    const Topology& topology;
    std::vector<int> faces;                ///< triangles of both sides, ascending
    std::vector<int> vertices;             ///< their vertices, ascending
    std::vector<SideOf> side;              ///< per triangle of the mesh
    std::vector<char> on_line;             ///< per vertex
    const Positions& rest_normals;         ///< per triangle: unit normal, zero without area
    const std::vector<double>& rest_areas; ///< per triangle [mm²]
    Positions moved_normals;
    std::vector<double> moved_areas;

    /// Number of edges of the line.
    int line_edges() const;
    int line_from(int k) const { return input.line[k]; }
    int line_to(int k) const { return input.line[(k + 1) % static_cast<int>(input.line.size())]; }
};

/// Signed angle between the triangles of edge e from their normals [rad]: 0 = flat, positive = convex; 0 on borders.
double dihedral(const Mesh& mesh, const Topology& topology, const Positions& normals, int e);

/// Why the input cannot be measured; empty when it can.
std::string complaint(const QualityInput& input);

/// A report with what `measure` takes, or why nothing can be measured.
Result<QualityReport> measured(const QualityInput& input, void (*measure)(const Context&, QualityReport&),
                               std::shared_ptr<const RestShape> rest_shape = nullptr);
/// What the quality strip shows.
void measure_strip(const Context& context, QualityReport& report);

void measure_line(const Context& context, QualityReport& report);
void measure_creases(const Context& context, QualityReport& report);
void measure_rim(const Context& context, QualityReport& report);
void measure_extension(const Context& context, QualityReport& report);

/// Signed distances of the moved vertices of a list to the region's rest surface.
struct BulgeMap {
    std::vector<double> mm; ///< per vertex of the mesh, NaN for those not listed
    BulgeReference reference = BulgeReference::triangles;
    int fallbacks = 0; ///< see `QualityReport`
};
BulgeMap bulge_map(const Context& context, const std::vector<int>& vertices);
void measure_bulge(const Context& context, QualityReport& report);

std::vector<Section> cut_sections(const Context& context);
void measure_sections(const Context& context, QualityReport& report);

/// Curvature signs and the crown.
void measure_curvature(const Context& context, QualityReport& report);
/// Fills the curvature maps: NaN outside the region, on the line and where no whole ring of triangles is; 0 within the
/// dead band.
void curvature_maps(const Context& context, QualityMaps& maps);

void measure_triangles(const Context& context, QualityReport& report);
/// Pairs of region triangles that meet in the moved mesh but not at rest.
void measure_intersections(const Context& context, QualityReport& report);

std::optional<double> symmetry_residual(const Context& context);

} // namespace tapeline::quality
