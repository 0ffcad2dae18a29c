// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that says how a side's plate meets the other one: along the line where the crease is kept, and
// along the prolongation, where the surface is to go on as it did.
#include "kernel/crease_ring.h"
#include "kernel/move_steps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace tapeline {

namespace {

/// The tension side counts as the one that makes room where the prolongation moves into it by more than this share of the
/// line's largest displacement, and gradually up to there.
constexpr double runs_in_clearly = 0.1;

/// How far a displacement of an edge runs into its triangle to the left (side 0) or right [mm].
double way_into(const Mesh& mesh, int face, const Vec3& direction, int side, const Vec3& displacement)
{
    return (side == 0 ? 1 : -1) * displacement.dot(triangle_normal(mesh, face).cross(direction.normalized()));
}

/// The triangles around a side's vertex that hang together with `face` without one of the side's feature lines between.
std::vector<int> smooth_sector(const SideMesh& side, const Topology& topology, int vertex, int face)
{
    std::vector<int> sector{face};
    for (size_t i = 0; i < sector.size(); ++i) {
        for (const int e : topology.face_edges(sector[i])) {
            const MeshEdge& edge = topology.edge(e);
            const bool through = (edge.a == vertex || edge.b == vertex) && !edge.border();
            if (!through || std::ranges::count(side.features, vertex_pair(edge.a, edge.b)) > 0) {
                continue;
            }
            const int next = topology.face_across(sector[i], e);
            if (std::ranges::count(sector, next) == 0) {
                sector.push_back(next);
            }
        }
    }
    return sector;
}

/// Per edge of the line how a side's surface has turned beside it, from the rest shape to V: around the corner opposite to
/// the edge. The triangle itself would not do: a cut makes thin ones, which tilt when its vertices, on their chords before,
/// are laid on the surface.
std::vector<Eigen::Quaterniond> line_turns(const SideMesh& side, const Positions& V, bool left)
{
    const Mesh before = side.own_mesh(), now{V, before.F};
    const Topology topology(before.F, static_cast<int>(V.rows()));
    std::vector<Eigen::Quaterniond> turns(side.line.size(), Eigen::Quaterniond::Identity());
    for (size_t i = 0; i < side.line.size(); ++i) {
        const int a = side.line[i], b = side.line[(i + 1) % side.line.size()];
        const int t = left ? topology.face_left_of(a, b) : topology.face_left_of(b, a);
        if (t < 0) {
            continue;
        }
        const int apex = before.F.row(t).sum() - a - b;
        Vec3 from = Vec3::Zero(), to = Vec3::Zero();
        for (const int face : smooth_sector(side, topology, apex, t)) {
            from += triangle_area(before, face) * triangle_normal(before, face);
            to += triangle_area(now, face) * triangle_normal(now, face);
        }
        turns[i] = Eigen::Quaterniond::FromTwoVectors(from, to);
    }
    return turns;
}

/// Per edge of the prolonged line how far its middle lies beyond the used part, along the line at rest [mm]; negative
/// within it. On a loop the prolongation is reached from both ends.
std::vector<double> way_beyond(const ExtendedLine& line)
{
    const int n = static_cast<int>(line.vertices.size()), edges = line.closed ? n : n - 1;
    std::vector<double> way(edges, -1);
    const auto walk = [&](int from, int step) {
        double s = 0;
        for (int k = 0, e = from; k < edges && (line.closed || (e >= 0 && e < edges)); ++k, e += step) {
            const int i = (e % n + n) % n;
            if (i >= line.first && i < line.last) {
                break;
            }
            const double length =
                (line.model.mesh.V.row(line.vertices[(i + 1) % n]) - line.model.mesh.V.row(line.vertices[i])).norm();
            way[i] = way[i] < 0 ? s + length / 2 : std::min(way[i], s + length / 2);
            s += length;
        }
    };
    walk(line.last, 1);
    walk(line.first - 1, -1);
    return way;
}

} // namespace

bool MoveState::guides_ends() const
{
    const auto used = static_cast<size_t>(extended_.last - extended_.first) + 1;
    return cut_ && extended_.vertices.size() > used && !tension_decides_ends();
}

std::vector<char> MoveState::guided_edges(const std::vector<double>& angles) const
{
    const std::vector<double> way = way_beyond(extended_);
    std::vector<char> guided(angles.size(), 0);
    for (size_t i = 0; i < angles.size() && guides_ends(); ++i) {
        if (way[i] < 0) {
            continue;
        }
        // A crease that the line's end takes along changes its angle as the line's does; the change runs out over as far
        // as the end moved sideways. Where nothing was sharp, nothing may become so.
        const bool before = static_cast<int>(i) < extended_.first;
        const int end = before ? extended_.first : extended_.last;
        const int next = before ? extended_.first + 1 : extended_.last - 1;
        const Vec3 at = extended_.model.mesh.V.row(extended_.vertices[end]);
        const Vec3 along = (at - Vec3(extended_.model.mesh.V.row(extended_.vertices[next]))).normalized();
        const double across = (extended_.targets[end] - at).cross(along).norm();
        const double sharp =
            keeps_crease() ? 0 : std::min(1.0, std::abs(angles[i]) / std::max(1e-3, options_.rim_crease_angle));
        guided[i] = way[i] >= sharp * across ? 1 : 0;
    }
    return guided;
}

std::vector<Vec3> MoveState::held_normals(int side) const
{
    const Mesh& rest = extended_.model.mesh;
    FeatureLine line;
    line.vertices = extended_.vertices;
    line.closed = extended_.closed;
    const std::vector<double> angles = signed_crease_angles(rest, rest.V, line);
    const bool along_line = keeps_crease() && side == tension();
    const std::vector<char> guided = guided_edges(angles);
    // On the line: what the solved other side is like. Beyond its ends: what the side is like that made room there, which
    // lies on the old surface; the other one goes on from it as it did at rest.
    Mesh solved = rest;
    sew(sides_[1 - side].side, sides_[1 - side].V, solved.V);
    for (size_t i = 0; i < extended_.targets.size() && along_line; ++i) {
        solved.V.row(extended_.vertices[i]) = extended_.targets[i];
    }
    std::array<std::vector<Eigen::Quaterniond>, 2> turns;
    for (int s = 0; s < 2; ++s) {
        turns[s] = line_turns(sides_[s].side, sides_[s].rest, s == 0);
    }
    const Topology topology(rest.F, static_cast<int>(rest.V.rows()));
    std::vector<Vec3> normals(angles.size(), Vec3::Zero());
    for (size_t i = 0; i < angles.size(); ++i) {
        const bool used = static_cast<int>(i) >= extended_.first && static_cast<int>(i) < extended_.last;
        if (used ? !along_line : guided[i] == 0) {
            continue;
        }
        const size_t next = (i + 1) % extended_.vertices.size();
        const int a = extended_.vertices[i], b = extended_.vertices[next];
        const std::array<int, 2> beside{topology.face_left_of(a, b), topology.face_left_of(b, a)};
        const Vec3 along = (extended_.targets[next] - extended_.targets[i]).normalized();
        const auto after = [&](const Vec3& normal, int source) -> Vec3 {
            const double turn = source == side ? 0 : angles[i] * std::numbers::pi / 180 * (side == 0 ? 1 : -1);
            return Eigen::AngleAxisd(turn, along) * (normal - along * along.dot(normal)).normalized();
        };
        if (used) {
            normals[i] = after(triangle_normal(solved, beside[1 - side]), 1 - side);
            continue;
        }
        const Vec3 u = extended_.targets[i] + extended_.targets[next] - Vec3(rest.V.row(a)) - Vec3(rest.V.row(b));
        const double into = 0.5 * way_into(rest, beside[tension()], rest.V.row(b) - rest.V.row(a), tension(), u);
        const double share = smooth_step(into, 0, runs_in_clearly * result_.placement.u_max_mm);
        for (const int source : {compression(), tension()}) {
            const Vec3 turned = turns[source][i] * triangle_normal(rest, beside[source]);
            normals[i] += (source == tension() ? share : 1 - share) * after(turned, source);
        }
        normals[i].normalize();
    }
    return normals;
}

Result<void> MoveState::hold_ring(int side, PlateSupport& support, const PlateOptions& options) const
{
    if (!guides_ends() && !(keeps_crease() && side == tension())) {
        return {};
    }
    const std::vector<Vec3> normals = held_normals(side);
    if (std::ranges::all_of(normals, [](const Vec3& normal) { return normal.isZero(0); })) {
        return {};
    }
    // In their plane the ring's vertices go where the side's domain has them, to which the plate pulls them there. Along
    // the line itself a little more or less can make an inflection (the panel moved by 75 mm): there the plate is asked.
    const Mesh rest{sides_[side].rest, sides_[side].side.mesh.F};
    const bool along_line = keeps_crease() && side == tension();
    const auto carried = along_line ? bend_plate(rest, support, options).map(&DeformationResult::V)
                                    : PlateSystem::domain(rest, support, options.material);
    if (!carried) {
        return tl::unexpected(carried.error());
    }
    const CreaseRing ring =
        crease_ring(sides_[side].side, *carried, extended_.closed, extended_.targets, normals, side == 0);
    const std::optional<CarriedStrip>& strip = sides_[side].strip;
    for (size_t i = 0; i < ring.vertices.size(); ++i) {
        // A strip that rests on the old surface, or is held, is at its place.
        if (strip && (strip->settled || side == compression()) && strip->has(ring.vertices[i])) {
            continue;
        }
        support.constrained.push_back(ring.vertices[i]);
        support.targets.conservativeResize(support.targets.rows() + 1, 3);
        support.targets.bottomRows(1) = ring.targets[i].transpose();
    }
    return {};
}

} // namespace tapeline
