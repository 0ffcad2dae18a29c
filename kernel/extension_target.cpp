// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/extension_target.h"

#include "kernel/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace tapeline {

namespace {

const Vec3 free_target = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// Area-weighted unit normals at the arm's vertices, of those region triangles around each that hang together with the
/// arm without another feature line between them: at a corner of the model the arm runs on in one face.
std::vector<Vec3> normals_along(const ExtendedLine& extended, const Topology& topology, const std::vector<int>& arm)
{
    const Mesh& mesh = extended.model.mesh;
    const auto wall = [&](const MeshEdge& e) {
        return e.face_count != 2 || std::ranges::binary_search(extended.features, VertexPair{e.a, e.b});
    };
    std::vector<Vec3> normals;
    for (size_t i = 0; i < arm.size(); ++i) {
        const int v = arm[i];
        std::vector<int> around, front;
        for (const int t : topology.vertex_faces(v)) {
            if (std::ranges::binary_search(extended.region.faces, t)) {
                around.push_back(t);
            }
        }
        for (const size_t k : {i - 1, i + 1}) {
            const int e = k < arm.size() ? topology.find_edge(v, arm[k]) : -1;
            if (e >= 0) {
                front.insert(front.end(), {topology.edge(e).left, topology.edge(e).right});
            }
        }
        std::vector<int> reached;
        while (!front.empty()) {
            const int t = front.back();
            front.pop_back();
            if (std::ranges::count(around, t) == 0 || std::ranges::count(reached, t) > 0) {
                continue;
            }
            reached.push_back(t);
            for (const int e : topology.face_edges(t)) {
                const MeshEdge& edge = topology.edge(e);
                if ((edge.a == v || edge.b == v) && !wall(edge)) {
                    front.push_back(topology.face_across(t, e));
                }
            }
        }
        // In a fixed order, so that the sum does not depend on the way.
        std::ranges::sort(reached);
        Vec3 normal = Vec3::Zero();
        for (const int t : reached) {
            normal += triangle_area(mesh, t) * triangle_normal(mesh, t);
        }
        normals.push_back(normal.normalized());
    }
    return normals;
}

/// Derivative along the line, outwards, of the displacement at its end [mm/mm]: `end` is the last vertex, `step` walks
/// inwards. Second order where three vertices are there.
Vec3 end_slope(const Positions& V, const Correspondence& c, int end, int step)
{
    const auto& line = c.line.vertices;
    const auto u = [&](int k) { return c.displacements[end + k * step]; };
    const auto h = [&](int k) { return (V.row(line[end + k * step]) - V.row(line[end + (k + 1) * step])).norm(); };
    const double h0 = h(0);
    Vec3 first = (u(0) - u(1)) / h0;
    if (line.size() < 3) {
        return first;
    }
    const double h1 = h(1);
    const Vec3 second = (u(1) - u(2)) / h1;
    return first + (first - second) * (h0 / (h0 + h1));
}

/// One extension: its vertices from the line's end (included) outwards, and where the displacement comes from.
struct Arm {
    std::vector<int> vertices;
    Vec3 displacement;
    double slope; ///< of the displacement's size, relative to that size [1/mm]
    Vec3 target;  ///< of the line's end
    TaperEnd end = TaperEnd::clamped;
};

Arm arm_of(const ExtendedLine& extended, const Correspondence& c, bool after, const std::vector<int>& entries)
{
    Arm arm;
    for (const int k : entries) {
        arm.vertices.push_back(extended.vertices[k]);
    }
    arm.displacement = after ? c.displacements.back() : c.displacements.front();
    arm.target = after ? c.targets.back() : c.targets.front();
    const int used = static_cast<int>(c.line.vertices.size());
    const Vec3 slope = end_slope(extended.model.mesh.V, c, after ? used - 1 : 0, after ? -1 : 1);
    const double squared = arm.displacement.squaredNorm();
    arm.slope = squared > 0 ? slope.dot(arm.displacement) / squared : 0;
    return arm;
}

/// What is left of a vector given at an arm's start, at each vertex of the arm: turned with the surface normal from
/// vertex to vertex, times the taper. The last entry is zero exactly.
std::vector<Vec3> tapered(const Mesh& mesh, const std::vector<Vec3>& normals, const Arm& arm, Vec3 vector)
{
    std::vector<double> s{0};
    for (size_t i = 1; i < arm.vertices.size(); ++i) {
        s.push_back(s.back() + (mesh.V.row(arm.vertices[i]) - mesh.V.row(arm.vertices[i - 1])).norm());
    }
    std::vector<Vec3> left{vector};
    for (size_t i = 1; i < arm.vertices.size(); ++i) {
        vector = Eigen::Quaterniond::FromTwoVectors(normals[i - 1], normals[i]) * vector;
        left.push_back(vector * taper(s[i], s.back(), arm.slope, arm.end));
    }
    left.back().setZero();
    return left;
}

/// The place on the surface for a point beside it.
using PointOnSurface = std::function<Vec3(const Vec3&)>;

/// Targets of an arm's vertices. On the surface: the tapered displacement's end is laid on the triangles; what the
/// line's own end stands off them fades likewise, so that the extension joins the line without a step.
std::vector<Vec3> arm_targets(const ExtendedLine& extended, const Topology& topology, const Arm& arm,
                              const PointOnSurface& lay)
{
    const Mesh& mesh = extended.model.mesh;
    const std::vector<Vec3> normals = normals_along(extended, topology, arm.vertices);
    const std::vector<Vec3> displacements = tapered(mesh, normals, arm, arm.displacement);
    const Vec3 off = lay ? Vec3(arm.target - lay(arm.target)) : Vec3::Zero();
    const std::vector<Vec3> offsets = tapered(mesh, normals, arm, off);
    double edge = 0;
    for (size_t i = 1; i < arm.vertices.size(); ++i) {
        edge = std::max(edge, (mesh.V.row(arm.vertices[i]) - mesh.V.row(arm.vertices[i - 1])).norm());
    }
    std::vector<Vec3> targets;
    for (size_t i = 0; i < arm.vertices.size(); ++i) {
        const Vec3 at = mesh.V.row(arm.vertices[i]);
        const bool still = displacements[i].isZero(0);
        const Vec3 moved = at + displacements[i];
        if (still || !lay) {
            targets.push_back(moved);
            continue;
        }
        // What a vertex on a chord stood off the exact surface it keeps as far as it stays: a lift of its own would kink.
        const double stays = 1 - smooth_step(displacements[i].norm(), 0, edge);
        targets.push_back(lay(moved) + offsets[i] + stays * (at - lay(at)));
    }
    return targets;
}

/// The part of the end displacement along the arm must not fold it: s + u_t h(s) has to grow towards the rim.
Result<void> check_room(const Mesh& mesh, const Arm& arm)
{
    double length = 0;
    for (size_t i = 1; i < arm.vertices.size(); ++i) {
        length += (mesh.V.row(arm.vertices[i]) - mesh.V.row(arm.vertices[i - 1])).norm();
    }
    const Vec3 at = mesh.V.row(arm.vertices[0]);
    const Vec3 outwards = (Vec3(mesh.V.row(arm.vertices[1])) - at).normalized();
    const double along = arm.displacement.dot(outwards);
    constexpr int samples = 64;
    double last = along;
    for (int i = 1; i <= samples; ++i) {
        const double s = length * i / samples;
        const double moved = s + along * taper(s, length, arm.slope, arm.end);
        if (moved <= last) {
            return fail(
                ErrorKind::rejected,
                fmt::format("the line's end at ({:.6g}, {:.6g}, {:.6g}) mm moves {:.4g} mm along its extension, "
                            "which has only {:.4g} mm to the region's rim; enlarge the region",
                            at.x(), at.y(), at.z(), along, length));
        }
        last = moved;
    }
    return {};
}

} // namespace

double taper(double s, double length, double slope, TaperEnd end)
{
    if (s >= length) {
        return 0;
    }
    const double x = s / length, m = std::clamp(slope * length, -3.0, 0.0);
    if (end == TaperEnd::natural) {
        // h(0) = 1, h'(0) = m, h(1) = h"(1) = 0.
        return (1 - x) * (1 + (1 + m) * x * (1 - 0.5 * x));
    }
    // (1 - x)² (1 + (2 + m) x) is the Hermite cubic with h(0) = 1, h'(0) = m, h(1) = h'(1) = 0.
    return (1 - x) * (1 - x) * (1 + (2 + m) * x);
}

ExtensionTargets::ExtensionTargets(const ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                                   const ExtensionOptions& options)
    : extended_(extended), on_surface_(options.on_surface), surface_(rest.mesh, faces),
      topology_(extended.model.mesh.F, static_cast<int>(extended.model.mesh.V.rows()))
{
    if (options.exact_surface && rest.surface) {
        exact_.emplace(rest, faces);
    }
}

std::vector<int> ExtensionTargets::entries(bool after) const
{
    const int size = static_cast<int>(extended_.vertices.size()), used = extended_.last - extended_.first + 1;
    const int beyond = size - used;
    // On a loop both arms share the part that is not used, each up to its middle.
    const int open_count = after ? size - 1 - extended_.last : extended_.first;
    const int count = extended_.closed ? (after ? (beyond + 1) / 2 : beyond + 1 - (beyond + 1) / 2) : open_count;
    std::vector<int> entries;
    for (int i = 0; i <= count && beyond > 0; ++i) {
        entries.push_back((after ? extended_.last + i : extended_.first - i + size) % size);
    }
    return entries;
}

Result<std::vector<Vec3>> ExtensionTargets::beyond(const Correspondence& c, bool after) const
{
    const std::vector<int> places = entries(after);
    if (places.size() < 2) {
        return std::vector<Vec3>{};
    }
    Arm arm = arm_of(extended_, c, after, places);
    arm.end = topology_.border_vertex(arm.vertices.back()) ? TaperEnd::natural : TaperEnd::clamped;
    const auto lay = [&](const Vec3& p) -> Vec3 {
        const auto foot = exact_ ? exact_->closest(p) : std::nullopt;
        return foot ? *foot : surface_.closest(p).point;
    };
    return check_room(extended_.model.mesh, arm).map([&] {
        return arm_targets(extended_, topology_, arm, on_surface_ ? lay : PointOnSurface());
    });
}

namespace {

void set_used_targets(ExtendedLine& extended, const Correspondence& c)
{
    extended.targets.assign(extended.vertices.size(), free_target);
    std::ranges::copy(c.targets, extended.targets.begin() + extended.first);
}

void hold_rim(ExtendedLine& extended)
{
    for (int k = 0; k < static_cast<int>(extended.vertices.size()); ++k) {
        const bool in_used = k >= extended.first && k <= extended.last;
        if (!in_used && std::ranges::binary_search(extended.region.fixed_rim, extended.vertices[k])) {
            extended.targets[k] = extended.model.mesh.V.row(extended.vertices[k]);
        }
    }
}

} // namespace

Result<void> set_targets(ExtendedLine& extended, const Model& rest, const std::vector<int>& faces,
                         const Correspondence& c, const ExtensionOptions& options)
{
    if (options.target == ExtensionTarget::tapered && extended.vertices.size() > c.line.vertices.size()) {
        return set_targets(extended, ExtensionTargets(extended, rest, faces, options), c);
    }
    set_used_targets(extended, c);
    hold_rim(extended);
    return {};
}

Result<void> set_targets(ExtendedLine& extended, const ExtensionTargets& prolongation, const Correspondence& c)
{
    set_used_targets(extended, c);
    for (const bool after : {false, true}) {
        const auto targets = prolongation.beyond(c, after);
        if (!targets) {
            return tl::unexpected(targets.error());
        }
        const std::vector<int> entries = prolongation.entries(after);
        for (size_t i = 1; i < targets->size(); ++i) {
            extended.targets[entries[i]] = (*targets)[i];
        }
    }
    hold_rim(extended);
    return {};
}

} // namespace tapeline
