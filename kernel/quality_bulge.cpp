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

/// The region's rest surface: its CAD faces where the input has them, else its triangles.
class RestSurface {
public:
    explicit RestSurface(const Context& context) : context_(context)
    {
        const Model* cad = context.input.cad;
        const std::vector<int> faces = faces_and_ring(context);
        const bool all = faces.size() == context.side.size();
        const bool exact = cad && cad->surface && cad->cad_face.size() == context.side.size();
        if (exact) {
            exact_ = all && context.shape->exact ? &*context.shape->exact : &own_exact_.emplace(*cad, faces);
        } else {
            triangles_ =
                all && context.shape->surface ? &*context.shape->surface : &own_triangles_.emplace(context.rest, faces);
        }
    }

    bool exact() const { return exact_ != nullptr; }

    struct Distance {
        double mm = std::numeric_limits<double>::quiet_NaN();
        bool exact = false;
    };

    Distance signed_distance(const Vec3& p) const
    {
        const SheetFoot foot = exact_ ? exact_->foot(p) : SheetFoot{triangles_->closest(p), {}};
        if (foot.exact) {
            const double distance = (p - foot.exact->point).norm();
            return {foot.exact->normal.dot(p - foot.exact->point) < 0 ? -distance : distance, true};
        }
        if (foot.triangle.face < 0) {
            return {};
        }
        const double sense = pseudo_normal(context_, foot.triangle).dot(p - foot.triangle.point);
        return {sense < 0 ? -foot.triangle.distance : foot.triangle.distance, false};
    }

private:
    const Context& context_;
    std::optional<ExactSheet> own_exact_;
    std::optional<ClosestPoint> own_triangles_;
    const ExactSheet* exact_ = nullptr; ///< one of the two
    const ClosestPoint* triangles_ = nullptr;
};

} // namespace

BulgeMap bulge_map(const Context& context, const std::vector<int>& vertices)
{
    const RestSurface surface(context);
    BulgeMap map{std::vector<double>(context.rest.V.rows(), std::numeric_limits<double>::quiet_NaN()),
                 surface.exact() ? BulgeReference::exact : BulgeReference::triangles, 0};
    std::vector<char> fallback(vertices.size(), 0);
    parallel_for(
        static_cast<int>(vertices.size()),
        [&](int i) {
            const int v = vertices[i];
            const Vec3 p = context.moved.V.row(v);
            if (p == Vec3(context.rest.V.row(v))) {
                map.mm[v] = 0; // not moved: no need to search
                return;
            }
            const auto [distance, exact] = surface.signed_distance(p);
            map.mm[v] = distance;
            fallback[i] = exact ? 0 : 1;
        },
        64);
    if (surface.exact()) {
        map.fallbacks = static_cast<int>(std::ranges::count(fallback, 1));
    }
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
    const BulgeMap bulges = bulge_map(context, judged);
    const std::vector<double>& map = bulges.mm;
    report.bulge_reference = bulges.reference;
    report.bulge_fallbacks = bulges.fallbacks;
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
