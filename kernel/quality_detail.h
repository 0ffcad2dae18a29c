// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/quality.h"
#include "kernel/topology.h"

#include <vector>

/// Inside of kernel/quality: what the measures share. Not for other modules.
namespace tapeline::quality {

enum class SideOf : char { none, compressed, tension };

/// The input with what several measures need of it, computed once.
struct Context {
    explicit Context(const QualityInput& quality_input);

    const QualityInput& input;
    const Mesh& rest;
    Mesh moved;
    Topology topology;
    std::vector<int> faces;    ///< triangles of both sides, ascending
    std::vector<int> vertices; ///< their vertices, ascending
    std::vector<SideOf> side;  ///< per triangle of the mesh
    std::vector<char> on_line; ///< per vertex
    Positions rest_normals;    ///< per triangle: unit normal, zero without area
    Positions moved_normals;
    std::vector<double> rest_areas, moved_areas; ///< per triangle [mm²]

    /// Number of edges of the line.
    int line_edges() const;
    int line_from(int k) const { return input.line[k]; }
    int line_to(int k) const { return input.line[(k + 1) % static_cast<int>(input.line.size())]; }
};

/// Signed angle between the triangles of edge e from their normals [rad]: 0 = flat, positive = convex; 0 on borders.
double dihedral(const Mesh& mesh, const Topology& topology, const Positions& normals, int e);

/// Why the input cannot be measured; empty when it can.
std::string complaint(const QualityInput& input);

void measure_line(const Context& context, QualityReport& report);
void measure_creases(const Context& context, QualityReport& report);
void measure_rim(const Context& context, QualityReport& report);
void measure_extension(const Context& context, QualityReport& report);

/// Signed distance of the moved vertices to the region's rest surface, NaN for vertices outside the region [mm].
std::vector<double> bulge_map(const Context& context);
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
int new_self_intersections(const Context& context);

std::optional<double> symmetry_residual(const Context& context);

} // namespace tapeline::quality
