// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/precision.h"
#include "kernel/quality_detail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tapeline::quality {

namespace {

/// Share of the Gauss image's squared perimeter that the image must enclose to count as curved both ways. A circle
/// encloses 0.08 of it, an ellipse of axes 1:20 encloses 0.01; zigzag of the tessellation adds perimeter but no area.
constexpr double gauss_band = 0.01;
/// Share of Σ l|θ| that the signed sum Σ l θ must reach to count as bent one way.
constexpr double mean_band = 0.05;

/// Vertices on edges at least this sharp [rad] keep their curvature to themselves.
constexpr double sharp = 20 * std::numbers::pi / 180;
/// Rings of vertices beside line and rim that do not count for the crown.
constexpr int crown_rings = 2;
constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// Discrete curvature of one vertex with the dead bands of its values.
struct Curvature {
    double gauss = not_measured; ///< angle defect / area [1/mm²]
    double mean = not_measured;  ///< Σ l θ / (4 area) [1/mm], positive = convex
    double gauss_zero = 0, mean_zero = 0;
    double area = 0; ///< of the vertex's cell [mm²]
    bool on_crease = false;

    bool measured() const { return !std::isnan(gauss); }
    double sure_gauss() const { return std::abs(gauss) > gauss_zero || !measured() ? gauss : 0; }
    double sure_mean() const { return std::abs(mean) > mean_zero || !measured() ? mean : 0; }
    void add(double weight, const Curvature& other)
    {
        gauss += weight * other.gauss;
        mean += weight * other.mean;
        gauss_zero += weight * other.gauss_zero;
        mean_zero += weight * other.mean_zero;
    }
};

/// What rounding leaves of an angle sum [rad].
constexpr double angle_rounding = 1e-12;

/// The part of a triangle that lies nearest to its corner, between edges e1 and e2; for obtuse triangles the half or the
/// quarters that Meyer et al. (2003) take instead.
double corner_area(const Vec3& e1, const Vec3& e2, double area)
{
    const Vec3 e3 = e2 - e1;
    const double at_corner = e1.dot(e2), at_first = -e1.dot(e3), at_second = e2.dot(e3);
    if (at_corner < 0) {
        return area / 2;
    }
    if (at_first < 0 || at_second < 0) {
        return area / 4;
    }
    // cot = dot / (2 area); each edge adds its squared length times the opposite cotangent over 8.
    return area > 0 ? (e1.squaredNorm() * at_second + e2.squaredNorm() * at_first) / (16 * area) : 0;
}

/// Whether the curvature at v is defined: a whole ring of triangles, away from the line's crease.
bool measurable(const Context& context, int v)
{
    const auto edges = context.topology.vertex_edges(v);
    return !context.on_line[v] &&
           std::all_of(edges.begin(), edges.end(), [&](int e) { return context.topology.edge(e).face_count == 2; });
}

/// `noise` is the precision of a coordinate [mm]. The normals around a vertex, turned by noise / h with h the ring's
/// smallest altitude, move the border of the Gauss image (perimeter P = Σ|θ|) by that much: its area, the angle defect,
/// is known to ± (P noise/h + (noise/h)²).
Curvature curvature_at(const Context& context, const Mesh& mesh, const std::vector<double>& areas,
                       const std::vector<double>& angles, double noise, int v)
{
    double sum = 0, cell = 0, altitude = std::numeric_limits<double>::infinity();
    for (const int t : context.topology.vertex_faces(v)) {
        const int k = mesh.F(t, 0) == v ? 0 : (mesh.F(t, 1) == v ? 1 : 2);
        const Vec3 p = mesh.V.row(v);
        const Vec3 e1 = mesh.V.row(mesh.F(t, (k + 1) % 3)).transpose() - p;
        const Vec3 e2 = mesh.V.row(mesh.F(t, (k + 2) % 3)).transpose() - p;
        sum += std::atan2(e1.cross(e2).norm(), e1.dot(e2));
        cell += corner_area(e1, e2, areas[t]);
        const double longest = std::sqrt(std::max({e1.squaredNorm(), e2.squaredNorm(), (e1 - e2).squaredNorm()}));
        altitude = std::min(altitude, longest > 0 ? 2 * areas[t] / longest : 0);
    }
    Curvature result;
    if (cell <= 0 || altitude <= 0) {
        return result;
    }
    double perimeter = 0, bend = 0, absolute_bend = 0, lengths = 0, sharpest = 0;
    for (const int e : context.topology.vertex_edges(v)) {
        const MeshEdge& edge = context.topology.edge(e);
        const double length = (mesh.V.row(edge.b) - mesh.V.row(edge.a)).norm();
        perimeter += std::abs(angles[e]);
        bend += length * angles[e];
        absolute_bend += length * std::abs(angles[e]);
        lengths += length;
        sharpest = std::max(sharpest, std::abs(angles[e]));
    }
    const double turn = noise / altitude;
    result.area = cell;
    result.gauss = (2 * std::numbers::pi - sum) / cell;
    result.gauss_zero = (gauss_band * perimeter * perimeter + turn * (perimeter + turn) + angle_rounding) / cell;
    result.mean = bend / (4 * cell);
    result.mean_zero = (mean_band * absolute_bend + (turn + angle_rounding) * lengths) / (4 * cell);
    result.on_crease = sharpest > sharp;
    return result;
}

/// Averages the curvatures over each triangle and back, weighted by the corners' shares of the cells, which keeps their
/// sum. A single angle defect depends on how the triangles happen to lie around the vertex (with four edges it does
/// not see the mixed second derivative at all); what neighbours share does not.
std::vector<Curvature> averaged(const Context& context, const Mesh& mesh, const std::vector<double>& areas,
                                const std::vector<Curvature>& raw)
{
    std::vector<int> index(mesh.V.rows(), -1);
    for (size_t i = 0; i < raw.size(); ++i) {
        index[context.vertices[i]] = raw[i].measured() && !raw[i].on_crease ? static_cast<int>(i) : -1;
    }
    const auto share = [&](int t, int k) {
        const Vec3 p = mesh.V.row(mesh.F(t, k));
        return corner_area(mesh.V.row(mesh.F(t, (k + 1) % 3)).transpose() - p,
                           mesh.V.row(mesh.F(t, (k + 2) % 3)).transpose() - p, areas[t]);
    };
    std::vector<Curvature> result = raw;
    parallel_for(static_cast<int>(raw.size()), [&](int i) {
        const int v = context.vertices[i];
        if (index[v] < 0) {
            return;
        }
        Curvature& out = result[i];
        out.gauss = out.mean = out.gauss_zero = out.mean_zero = 0;
        for (const int t : context.topology.vertex_faces(v)) {
            double total = 0, own = 0;
            for (int k = 0; k < 3; ++k) {
                total += index[mesh.F(t, k)] >= 0 ? share(t, k) : 0;
                own += mesh.F(t, k) == v ? share(t, k) : 0;
            }
            for (int k = 0; k < 3 && total > 0; ++k) {
                if (index[mesh.F(t, k)] >= 0) {
                    out.add(own / out.area * share(t, k) / total, raw[index[mesh.F(t, k)]]);
                }
            }
        }
    });
    return result;
}

/// Curvature at each of the region's vertices, in the order of context.vertices.
std::vector<Curvature> curvatures(const Context& context, const Mesh& mesh, const Positions& normals,
                                  const std::vector<double>& areas, double noise)
{
    std::vector<char> wanted(mesh.V.rows(), 0);
    for (const int v : context.vertices) {
        wanted[v] = 1;
    }
    std::vector<double> angles(context.topology.edge_count(), 0);
    parallel_for(context.topology.edge_count(), [&](int e) {
        const MeshEdge& edge = context.topology.edge(e);
        if (wanted[edge.a] || wanted[edge.b]) {
            angles[e] = dihedral(mesh, context.topology, normals, e);
        }
    });
    std::vector<Curvature> result(context.vertices.size());
    parallel_for(static_cast<int>(result.size()), [&](int i) {
        const int v = context.vertices[i];
        if (measurable(context, v)) {
            result[i] = curvature_at(context, mesh, areas, angles, noise, v);
        }
    });
    return averaged(context, mesh, areas, result);
}

struct BothCurvatures {
    std::vector<Curvature> before, after;
};

BothCurvatures both(const Context& context)
{
    // What the input's digits leave open at rest is still open after the move. A normal depends on several coordinates,
    // each off by up to the precision either way.
    const double noise = 4 * coordinate_precision(context.rest.V);
    return {curvatures(context, context.rest, context.rest_normals, context.rest_areas, noise),
            curvatures(context, context.moved, context.moved_normals, context.moved_areas, noise)};
}

/// Per vertex whether it lies on the tension side, more than `crown_rings` rings from its border (line, prolongation,
/// rim).
std::vector<char> inside_tension(const Context& context)
{
    std::vector<char> in(context.rest.V.rows(), 0);
    for (const int v : context.vertices) {
        const auto faces = context.topology.vertex_faces(v);
        in[v] = !context.on_line[v] && !context.topology.border_vertex(v) &&
                std::ranges::all_of(faces, [&](int t) { return context.side[t] == SideOf::tension; });
    }
    for (int ring = 0; ring < crown_rings; ++ring) {
        const std::vector<char> before = in;
        for (const MeshEdge& edge : context.topology.edges()) {
            in[edge.a] = in[edge.a] && before[edge.b];
            in[edge.b] = in[edge.b] && before[edge.a];
        }
    }
    return in;
}

void measure_crown(const Context& context, const std::vector<Curvature>& before, const std::vector<Curvature>& after,
                   QualityReport& report)
{
    const std::vector<char> inside = inside_tension(context);
    double area = 0, moved_area = 0, mean = 0, moved_mean = 0, size = 0, noise = 0, difference = 0;
    for (size_t i = 0; i < before.size(); ++i) {
        if (!inside[context.vertices[i]] || !before[i].measured() || !after[i].measured()) {
            continue;
        }
        area += before[i].area;
        moved_area += after[i].area;
        mean += before[i].area * before[i].mean;
        moved_mean += after[i].area * after[i].mean;
        size += before[i].area * std::abs(before[i].mean);
        noise += before[i].area * before[i].mean_zero;
        difference += before[i].area * std::abs(after[i].mean - before[i].mean);
    }
    // A side that is flat but for its dead band has no crown to lose.
    if (size > noise && moved_area > 0) {
        report.crown = {(moved_mean / moved_area - mean / area) / (size / area), difference / size};
    }
}

/// Area of vertex cells, and the part of it whose curvature changed sign [mm²].
struct ChangedArea {
    double area = 0, gauss = 0, mean = 0;
    void add(const Curvature& before, const Curvature& after)
    {
        area += before.area;
        gauss += before.sure_gauss() * after.sure_gauss() < 0 ? before.area : 0;
        mean += before.sure_mean() * after.sure_mean() < 0 ? before.area : 0;
    }
    double share(double part) const { return area > 0 ? part / area : 0; }
};

} // namespace

void measure_curvature(const Context& context, QualityReport& report)
{
    const auto [before, after] = both(context);
    measure_crown(context, before, after, report);
    ChangedArea all, compressed;
    for (size_t i = 0; i < before.size(); ++i) {
        if (!before[i].measured() || !after[i].measured()) {
            continue;
        }
        all.add(before[i], after[i]);
        const auto around = context.topology.vertex_faces(context.vertices[i]);
        if (std::ranges::all_of(around, [&](int t) { return context.side[t] == SideOf::compressed; })) {
            compressed.add(before[i], after[i]);
        }
    }
    report.gauss_sign_change = all.share(all.gauss);
    report.mean_sign_change = all.share(all.mean);
    report.gauss_sign_change_compressed = compressed.share(compressed.gauss);
}

void curvature_maps(const Context& context, QualityMaps& maps)
{
    const auto [before, after] = both(context);
    for (auto* map : {&maps.gauss_before, &maps.gauss_after, &maps.mean_before, &maps.mean_after}) {
        map->assign(context.rest.V.rows(), std::numeric_limits<double>::quiet_NaN());
    }
    for (size_t i = 0; i < before.size(); ++i) {
        const int v = context.vertices[i];
        maps.gauss_before[v] = before[i].sure_gauss();
        maps.gauss_after[v] = after[i].sure_gauss();
        maps.mean_before[v] = before[i].sure_mean();
        maps.mean_after[v] = after[i].sure_mean();
    }
}

} // namespace tapeline::quality
