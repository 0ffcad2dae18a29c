// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a move that says how a side's plate meets the other one: along the line where the crease is kept, and
// along the prolongation, where the surface is to go on as it did.
#include "kernel/crease_ring.h"
#include "kernel/move_steps.h"
#include "kernel/run_out.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
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

/// A normal, put upright on the direction, turned about it [rad].
Vec3 turned_about(const Vec3& along, double angle, const Vec3& normal)
{
    return Eigen::AngleAxisd(angle, along) * (normal - along * along.dot(normal)).normalized();
}

/// What turns a normal of the other side into one of this side at that crease [rad].
double turn_across(double degrees, int side) { return degrees * std::numbers::pi / 180 * (side == 0 ? 1 : -1); }

/// The direction of edge i of the line after the move.
Vec3 direction_after(const ExtendedLine& line, size_t i)
{
    return (line.targets[(i + 1) % line.targets.size()] - line.targets[i]).normalized();
}

/// The triangles left and right of edge i.
std::array<int, 2> faces_beside(const ExtendedLine& line, const Topology& topology, size_t i)
{
    const int a = line.vertices[i], b = line.vertices[(i + 1) % line.vertices.size()];
    return {topology.face_left_of(a, b), topology.face_left_of(b, a)};
}

/// Who has to follow whom where the surface goes on.
struct Sides {
    int own = 0, tension = 0;
    double u_max_mm = 0;
    std::array<std::vector<Eigen::Quaterniond>, 2> turns; ///< as `line_turns`
};

/// Per edge of the prolonged line a side's normal where the surface goes on across it as at rest.
std::vector<Vec3> even_normals(const ExtendedLine& line, const std::vector<double>& angles, const Sides& sides)
{
    const Mesh& rest = line.model.mesh;
    const Topology topology(rest.F, static_cast<int>(rest.V.rows()));
    std::vector<Vec3> normals(angles.size(), Vec3::Zero());
    for (size_t i = 0; i < angles.size(); ++i) {
        const size_t next = (i + 1) % line.vertices.size();
        const Vec3 a = rest.V.row(line.vertices[i]), b = rest.V.row(line.vertices[next]);
        const auto beside = faces_beside(line, topology, i);
        // The side that made room lies on the old surface; the other one goes on from it as it did at rest.
        const Vec3 u = 0.5 * (line.targets[i] + line.targets[next] - a - b);
        const double into = way_into(rest, beside[sides.tension], b - a, sides.tension, u);
        const double share = smooth_step(into, 0, runs_in_clearly * sides.u_max_mm);
        for (const int source : {0, 1}) {
            const double turn = source == sides.own ? 0 : turn_across(angles[i], sides.own);
            const Vec3 turned = sides.turns[source][i] * triangle_normal(rest, beside[source]);
            normals[i] +=
                (source == sides.tension ? share : 1 - share) * turned_about(direction_after(line, i), turn, turned);
        }
        normals[i].normalize();
    }
    return normals;
}

/// Per edge of the used line a side's normal at the old crease angle to the solved other side; zero beyond.
std::vector<Vec3> crease_normals(const ExtendedLine& line, const std::vector<double>& angles, Mesh solved, int side)
{
    for (size_t i = 0; i < line.targets.size(); ++i) {
        solved.V.row(line.vertices[i]) = line.targets[i];
    }
    const Topology topology(solved.F, static_cast<int>(solved.V.rows()));
    std::vector<Vec3> normals(angles.size(), Vec3::Zero());
    for (int i = line.first; i < line.last; ++i) {
        const Vec3 other = triangle_normal(solved, faces_beside(line, topology, i)[1 - side]);
        normals[i] = turned_about(direction_after(line, i), turn_across(angles[i], side), other);
    }
    return normals;
}

/// By how much a side at V is turned from those normals just inside of where the change runs out, at both ends [rad].
std::array<double, 2> end_turns(const ExtendedLine& line, const SideMesh& side, bool left, const Positions& V,
                                const std::vector<RunOut>& run_out, const std::vector<Vec3>& even)
{
    const Mesh inner = side.own_mesh(V);
    const Topology topology(inner.F, static_cast<int>(inner.V.rows()));
    std::array<double, 2> turns{0, 0};
    for (const int after : {0, 1}) {
        int i = after ? line.last - 1 : line.first;
        for (int k = 1; k < (line.last - line.first) / 2 && run_out[i].left >= 0; ++k) {
            i += after ? -1 : 1;
        }
        const int a = side.line[i], b = side.line[(i + 1) % side.line.size()];
        const int t = left ? topology.face_left_of(a, b) : topology.face_left_of(b, a);
        const Vec3 normal = triangle_normal(inner, t);
        turns[after] = std::atan2(even[i].cross(normal).dot(direction_after(line, i)), even[i].dot(normal));
    }
    return turns;
}

void add_to(PlateSupport& support, const CreaseRing& ring)
{
    const Eigen::Index before = support.targets.rows();
    support.constrained.insert(support.constrained.end(), ring.vertices.begin(), ring.vertices.end());
    support.targets.conservativeResize(before + static_cast<Eigen::Index>(ring.targets.size()), 3);
    for (size_t i = 0; i < ring.targets.size(); ++i) {
        support.targets.row(before + static_cast<Eigen::Index>(i)) = ring.targets[i];
    }
}

} // namespace

bool MoveState::guides_ends() const
{
    const auto used = static_cast<size_t>(extended_.last - extended_.first) + 1;
    return cut_ && extended_.vertices.size() > used && !tension_decides_ends();
}

CreaseRing MoveState::ring(int side, const Positions& carried, const std::vector<Vec3>& normals) const
{
    const SideState& own = sides_[side];
    const CreaseRing all = crease_ring(own.side, carried, extended_.closed, extended_.targets, normals, side == 0);
    CreaseRing ring;
    for (size_t i = 0; i < all.vertices.size(); ++i) {
        // A strip that rests on the old surface, or is held, is at its place.
        const bool rests = own.strip && (own.strip->settled || side == compression());
        if (!rests || !own.strip->has(all.vertices[i])) {
            ring.vertices.push_back(all.vertices[i]);
            ring.targets.push_back(all.targets[i]);
        }
    }
    return ring;
}

Result<void> MoveState::hold_ring(int side, PlateSupport& support, const PlateOptions& options) const
{
    const bool along_line = keeps_crease() && side == tension();
    if (!guides_ends() && !along_line) {
        return {};
    }
    FeatureLine line;
    line.vertices = extended_.vertices;
    line.closed = extended_.closed;
    const std::vector<double> angles = signed_crease_angles(extended_.model.mesh, extended_.model.mesh.V, line);
    std::vector<RunOut> runs(angles.size());
    std::vector<Vec3> even, normals(angles.size(), Vec3::Zero());
    if (along_line) {
        Mesh solved = extended_.model.mesh;
        sew(sides_[1 - side].side, sides_[1 - side].V, solved.V);
        normals = crease_normals(extended_, angles, std::move(solved), side);
    }
    if (guides_ends()) {
        runs = run_out(extended_, angles, keeps_crease() ? 0 : options_.rim_crease_angle);
        even = even_normals(
            extended_, angles,
            {side,
             tension(),
             result_.placement.u_max_mm,
             {line_turns(sides_[0].side, sides_[0].rest, true), line_turns(sides_[1].side, sides_[1].rest, false)}});
    }
    for (size_t i = 0; i < runs.size(); ++i) {
        normals[i] = runs[i].left == 0 ? even[i] : normals[i];
    }
    // In their plane the ring's vertices go where the side's domain has them, to which the plate pulls them there. Along
    // the line itself a little more or less can make an inflection (the panel moved by 75 mm): there the plate is asked.
    const Mesh rest{sides_[side].rest, sides_[side].side.mesh.F};
    const auto bent = [&](const PlateSupport& held) {
        return bend_plate(rest, held, options).map([](const DeformationResult& result) { return result.V; });
    };
    auto carried = along_line ? bent(support) : PlateSystem::domain(rest, support, options.material);
    if (carried && std::ranges::any_of(runs, [](const RunOut& run) { return run.left > 0; })) {
        // What a free line's crease becomes shows in a plate that is held only where the change has run out.
        PlateSupport first = support;
        add_to(first, ring(side, *carried, normals));
        carried = bent(first);
        const auto turns = carried ? end_turns(extended_, sides_[side].side, side == 0, *carried, runs, even)
                                   : std::array<double, 2>{};
        for (size_t i = 0; i < runs.size(); ++i) {
            const double turn = runs[i].left * turns[runs[i].after ? 1 : 0];
            normals[i] = runs[i].left > 0 ? turned_about(direction_after(extended_, i), turn, even[i]) : normals[i];
        }
    }
    return carried.map([&](const Positions& V) { add_to(support, ring(side, V, normals)); });
}

} // namespace tapeline
