// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/region_choice.h"

#include "kernel/parallel.h"
#include "plugin/runner/vertex_list.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace tapeline {

namespace {

/// Distance of p to a triangle with corners a, b, c (Ericson, Real-Time Collision Detection, 5.1.5).
double triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const auto to_segment = [&](const Vec3& from, const Vec3& to) {
        const Vec3 d = to - from;
        const double length2 = d.squaredNorm();
        const double t = length2 > 0 ? std::clamp((p - from).dot(d) / length2, 0.0, 1.0) : 0.0;
        return (p - from - t * d).norm();
    };
    const Vec3 normal = (b - a).cross(c - a);
    const double area2 = normal.squaredNorm();
    const bool inside = area2 > 0 && normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                        normal.dot((a - c).cross(p - c)) >= 0;
    if (inside) {
        return std::abs(normal.dot(p - a)) / std::sqrt(area2);
    }
    return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

/// Connected part (across edges) of the marked triangles that holds the line's triangles.
std::vector<int> part_with_line(const Mesh& mesh, const FeatureLine& line, const std::vector<char>& marked)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<char> reached(marked.size(), 0);
    std::vector<int> faces;
    const auto reach = [&](int t) {
        if (t >= 0 && !reached[t] && marked[t]) {
            reached[t] = 1;
            faces.push_back(t);
        }
    };
    for (const int v : line.vertices) {
        std::ranges::for_each(topology.vertex_faces(v), reach);
    }
    for (std::size_t k = 0; k < faces.size(); ++k) {
        for (const int e : topology.face_edges(faces[k])) {
            reach(topology.face_across(faces[k], e));
        }
    }
    std::ranges::sort(faces);
    return faces;
}

} // namespace

Result<RegionOptions> region_options(const Model& model, const std::vector<FeatureLine>& lines,
                                     const RegionSettings& settings)
{
    const int ways = (settings.roi_faces.empty() ? 0 : 1) + (settings.roi_lines.empty() ? 0 : 1) +
                     (settings.roi_box.empty() ? 0 : 1) + (settings.roi_distance > 0 ? 1 : 0);
    if (ways > 1) {
        return fail(ErrorKind::usage, "the region is given in more than one way; keep one of --roi-distance, "
                                      "--roi-faces, --roi-lines and --roi-box");
    }
    const auto unknown = std::ranges::find_if(settings.fixed_vertices, [&](int v) { return v >= model.mesh.V.rows(); });
    if (unknown != settings.fixed_vertices.end()) {
        return fail(ErrorKind::rejected, fmt::format("vertex {} of --fixed-vertices does not exist; the model has {}",
                                                     *unknown, model.mesh.V.rows()));
    }
    RegionOptions options;
    options.distance_mm = settings.roi_distance;
    options.cad_faces = settings.roi_faces;
    options.free_borders = settings.free_borders;
    options.fixed_vertices = settings.fixed_vertices;
    options.fixed_cad_faces = settings.fixed_faces;
    if (!settings.roi_box.empty()) {
        const auto& b = settings.roi_box;
        options.box = Eigen::AlignedBox3d(Vec3(b[0], b[1], b[2]), Vec3(b[3], b[4], b[5]));
        if (options.box->isEmpty()) {
            return fail(ErrorKind::usage, "the region's box (--roi-box) is empty; give xmin, ymin, zmin, then xmax, "
                                          "ymax, zmax");
        }
    }
    for (const LineSelector& selector : settings.roi_lines) {
        const Result<FeatureLine> line = choose_line(model, lines, selector);
        if (!line) {
            return tl::unexpected(line.error());
        }
        options.bounding_lines.push_back(line->vertices);
        if (line->closed) {
            options.bounding_lines.back().push_back(line->vertices.front());
        }
    }
    return options;
}

double automatic_roi_distance(const FeatureLine& line, const std::vector<Vec3>& displacements)
{
    double longest = 0;
    for (const Vec3& u : displacements) {
        longest = std::max(longest, u.norm());
    }
    // A loop spans its length / π.
    return std::max(0.35 * line.length_mm / (line.closed ? std::numbers::pi : 1), 3 * longest);
}

std::vector<int> faces_near(const Mesh& mesh, const FeatureLine& line, const std::vector<Vec3>& points, double distance)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    box.extend(box.min() - Vec3::Constant(distance));
    box.extend(box.max() + Vec3::Constant(distance));
    std::vector<char> marked(mesh.F.rows(), 0);
    parallel_for(static_cast<int>(mesh.F.rows()), [&](int t) {
        const Vec3 a = mesh.V.row(mesh.F(t, 0)), b = mesh.V.row(mesh.F(t, 1)), c = mesh.V.row(mesh.F(t, 2));
        Eigen::AlignedBox3d own(a);
        own.extend(b).extend(c);
        marked[t] = own.intersects(box) && std::ranges::any_of(points, [&](const Vec3& p) {
                        return own.squaredExteriorDistance(p) <= distance * distance &&
                               triangle_distance(p, a, b, c) <= distance;
                    });
    });
    return part_with_line(mesh, line, marked);
}

} // namespace tapeline
