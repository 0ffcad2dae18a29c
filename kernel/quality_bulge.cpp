// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/closest_point.h"
#include "kernel/parallel.h"
#include "kernel/quality_detail.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace tapeline::quality {

namespace {

/// The region's triangles and one ring around them: far enough for what the region can do, and no other sheet of a thin
/// part that happens to be near.
std::vector<int> faces_and_ring(const Context& context)
{
    std::vector<char> take(context.rest.F.rows(), 0);
    for (const int v : context.vertices) {
        for (const int t : context.topology.vertex_faces(v)) {
            take[t] = 1;
        }
    }
    std::vector<int> faces;
    for (int t = 0; t < context.rest.F.rows(); ++t) {
        if (take[t]) {
            faces.push_back(t);
        }
    }
    return faces;
}

/// Normal that tells inside from outside at a point of the rest mesh (Bærentzen & Aanæs 2005): of the triangle, of both
/// triangles at an edge, or of the ring weighted by angles at a corner.
Vec3 pseudo_normal(const Context& context, const MeshFoot& foot)
{
    constexpr double at_corner = 1e-9;
    const auto& F = context.rest.F;
    int zeros = 0, zero = -1, other = -1;
    for (int k = 0; k < 3; ++k) {
        if (foot.barycentric[k] <= at_corner) {
            ++zeros;
            zero = k;
        } else {
            other = k;
        }
    }
    if (zeros == 0) {
        return context.rest_normals.row(foot.face);
    }
    if (zeros == 1) {
        const int e = context.topology.face_edges(foot.face)[(zero + 1) % 3];
        const MeshEdge& edge = context.topology.edge(e);
        Vec3 sum = Vec3::Zero();
        for (const int t : {edge.left, edge.right}) {
            if (t >= 0) {
                sum += context.rest_normals.row(t).transpose();
            }
        }
        return sum;
    }
    const int v = F(foot.face, other);
    const Vec3 p = context.rest.V.row(v);
    Vec3 sum = Vec3::Zero();
    for (const int t : context.topology.vertex_faces(v)) {
        const int k = F(t, 0) == v ? 0 : (F(t, 1) == v ? 1 : 2);
        const Vec3 e1 = context.rest.V.row(F(t, (k + 1) % 3)).transpose() - p;
        const Vec3 e2 = context.rest.V.row(F(t, (k + 2) % 3)).transpose() - p;
        sum += std::atan2(e1.cross(e2).norm(), e1.dot(e2)) * context.rest_normals.row(t).transpose();
    }
    return sum;
}

} // namespace

std::vector<double> bulge_map(const Context& context, const std::vector<int>& vertices)
{
    std::vector<double> map(context.rest.V.rows(), std::numeric_limits<double>::quiet_NaN());
    const std::vector<int> faces = faces_and_ring(context);
    const bool kept = context.shape->surface && faces.size() == context.side.size();
    std::optional<ClosestPoint> made;
    if (!kept) {
        made.emplace(context.rest, faces);
    }
    const ClosestPoint& surface = kept ? *context.shape->surface : *made;
    parallel_for(
        static_cast<int>(vertices.size()),
        [&](int i) {
            const int v = vertices[i];
            const Vec3 p = context.moved.V.row(v);
            if (p == Vec3(context.rest.V.row(v))) {
                map[v] = 0; // not moved: no need to search
                return;
            }
            const MeshFoot foot = surface.closest(p);
            if (foot.face >= 0) {
                const double sense = pseudo_normal(context, foot).dot(p - foot.point);
                map[v] = sense < 0 ? -foot.distance : foot.distance;
            }
        },
        64);
    return map;
}

void measure_bulge(const Context& context, QualityReport& report)
{
    if (context.input.compressed_faces.empty()) {
        return;
    }
    std::vector<double> weight(context.rest.V.rows(), 0); // area of the side around each vertex
    for (const int t : context.input.compressed_faces) {
        for (int k = 0; k < 3; ++k) {
            weight[context.rest.F(t, k)] += context.rest_areas[t];
        }
    }
    for (const int v : context.input.carried) {
        weight[v] = 0;
    }
    // The line has a measure of its own: its target may leave the mesh by the chord error.
    std::vector<int> judged;
    std::ranges::copy_if(context.vertices, std::back_inserter(judged),
                         [&](int v) { return weight[v] > 0 && !context.on_line[v]; });
    const std::vector<double> map = bulge_map(context, judged);
    double squares = 0, total = 0;
    for (const int v : judged) {
        if (!std::isfinite(map[v])) {
            continue;
        }
        squares += weight[v] * map[v] * map[v];
        total += weight[v];
        if (std::abs(map[v]) > std::abs(report.bulge_max_mm)) {
            report.bulge_max_mm = map[v];
            report.bulge_at = context.moved.V.row(v);
        }
    }
    report.bulge_rms_mm = total > 0 ? std::sqrt(squares / total) : 0;
    report.bulge_fraction = report.slide_max_mm > 0 ? std::abs(report.bulge_max_mm) / report.slide_max_mm : 0;
}

} // namespace tapeline::quality
