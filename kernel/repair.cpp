// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/repair.h"

#include "kernel/repair_steps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace tapeline {

namespace {

/// Takes the marked triangles out of mesh.F and source_face; returns how many.
int remove_faces(RepairedMesh& work, const std::vector<char>& marked)
{
    Triangles& F = work.mesh.F;
    int kept = 0;
    for (int t = 0; t < F.rows(); ++t) {
        if (!marked[t]) {
            F.row(kept) = F.row(t);
            work.source_face[kept++] = work.source_face[t];
        }
    }
    const int removed = static_cast<int>(F.rows()) - kept;
    F.conservativeResize(kept, 3);
    work.source_face.resize(kept);
    return removed;
}

void count_what_stays(RepairedMesh& work, const EdgeSides& sides)
{
    const Mesh& mesh = work.mesh;
    RepairReport& report = work.report;
    const MeshEdge* left = nullptr;
    for (const MeshEdge& edge : sides.topology().edges()) {
        report.border_edges += edge.border();
        if (edge.face_count > 2) {
            left = left ? left : &edge;
            ++report.non_manifold_edges_left;
        }
    }
    if (left) {
        report.warnings.push_back(fmt::format("{} edges join more than two triangles, the first is {}; a region that "
                                              "touches one is refused",
                                              report.non_manifold_edges_left, edge_place(mesh, left->a, left->b)));
    }
    std::vector<char> used(mesh.V.rows(), 0);
    int first = -1;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            used[mesh.F(t, k)] = 1;
        }
        if (has_zero_area(mesh, t)) {
            first = first < 0 ? t : first;
            ++report.zero_area_faces;
        }
    }
    report.isolated_vertices = static_cast<int>(std::ranges::count(used, 0));
    if (first >= 0) {
        const Vec3 p = mesh.V.row(mesh.F(first, 0));
        report.warnings.push_back(fmt::format("{} triangles have no area and are kept, the first is triangle {} at "
                                              "({:.6g}, {:.6g}, {:.6g}) mm; a region that touches one needs remeshing",
                                              report.zero_area_faces, first, p.x(), p.y(), p.z()));
    }
}

} // namespace

EdgeSides::EdgeSides(const Triangles& F, int vertex_count) : topology_(F, vertex_count)
{
    start_.assign(topology_.edge_count() + 1, 0);
    for (int e = 0; e < topology_.edge_count(); ++e) {
        start_[e + 1] = start_[e] + topology_.edge(e).face_count;
    }
    sides_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int t = 0; t < F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            sides_[next[topology_.face_edges(t)[k]]++] = {t, k, F(t, k) < F(t, (k + 1) % 3)};
        }
    }
}

void EdgeSides::flip(int face)
{
    // Corners 1 and 2 swap, so the edges of corners 0 and 2 swap places.
    for (const int edge : topology_.face_edges(face)) {
        for (int i = start_[edge]; i < start_[edge + 1]; ++i) {
            if (sides_[i].face == face) {
                sides_[i].forward = !sides_[i].forward;
                sides_[i].corner = sides_[i].corner == 1 ? 1 : 2 - sides_[i].corner;
            }
        }
    }
}

bool remove_repeated_corners(RepairedMesh& work)
{
    const Triangles& F = work.mesh.F;
    std::vector<char> marked(F.rows(), 0);
    for (int t = 0; t < F.rows(); ++t) {
        marked[t] = F(t, 0) == F(t, 1) || F(t, 1) == F(t, 2) || F(t, 2) == F(t, 0);
    }
    const int removed = remove_faces(work, marked);
    work.report.degenerate_faces += removed;
    return removed > 0;
}

bool remove_duplicates(RepairedMesh& work, const EdgeSides& sides)
{
    // Equal triangles share an edge and the vertex opposite to it, and those at one edge are few.
    const Triangles& F = work.mesh.F;
    std::vector<char> marked(F.rows(), 0);
    std::vector<std::pair<int, int>> opposite;
    for (int e = 0; e < sides.topology().edge_count(); ++e) {
        const auto around = sides.sides(e);
        if (around.size() < 2) {
            continue;
        }
        opposite.clear();
        for (const EdgeSide& side : around) {
            opposite.emplace_back(F(side.face, (side.corner + 2) % 3), side.face);
        }
        std::ranges::sort(opposite);
        for (std::size_t i = 1; i < opposite.size(); ++i) {
            if (opposite[i].first == opposite[i - 1].first) {
                marked[opposite[i].second] = 1;
            }
        }
    }
    const int removed = remove_faces(work, marked);
    work.report.duplicate_faces += removed;
    return removed > 0;
}

std::string edge_place(const Mesh& mesh, int a, int b)
{
    const Vec3 p = 0.5 * (mesh.V.row(a) + mesh.V.row(b));
    return fmt::format("edge {}-{} at ({:.6g}, {:.6g}, {:.6g}) mm", a, b, p.x(), p.y(), p.z());
}

bool has_zero_area(const Mesh& mesh, int t)
{
    const Vec3 a = mesh.V.row(mesh.F(t, 0)), b = mesh.V.row(mesh.F(t, 1)), c = mesh.V.row(mesh.F(t, 2));
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !((b - a).cross(c - a).norm() > 1e-10 * longest);
}

Mesh without_isolated_vertices(const Mesh& mesh)
{
    std::vector<int> number(mesh.V.rows(), -1);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            number[mesh.F(t, k)] = 0;
        }
    }
    Mesh result;
    result.V.resize(mesh.V.rows(), 3);
    int kept = 0;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (number[v] == 0) {
            result.V.row(kept) = mesh.V.row(v);
            number[v] = kept++;
        }
    }
    result.V.conservativeResize(kept, 3);
    result.F = mesh.F.unaryExpr([&](int v) { return number[v]; });
    return result;
}

RepairedMesh repair_mesh(Mesh mesh, const RepairOptions& options)
{
    RepairedMesh work;
    work.mesh = std::move(mesh);
    work.source_face.resize(work.mesh.F.rows());
    std::iota(work.source_face.begin(), work.source_face.end(), 0);

    const auto connect = [&] { return EdgeSides(work.mesh.F, static_cast<int>(work.mesh.V.rows())); };
    const auto clean = [&] {
        remove_repeated_corners(work);
        EdgeSides sides = connect();
        return remove_duplicates(work, sides) ? connect() : std::move(sides);
    };
    EdgeSides sides = clean();
    if (options.sew_borders && sew_borders(work, sides)) {
        sides = clean();
    }
    const std::vector<int> component = orient_components(work, sides);
    if (split_apart(work, sides, component)) {
        sides = connect();
    }
    count_what_stays(work, sides);
    return work;
}

Result<void> check_faces(const Mesh& mesh, const Topology& topology, std::span<const int> faces)
{
    for (const int t : faces) {
        if (has_zero_area(mesh, t)) {
            const Vec3 p = mesh.V.row(mesh.F(t, 0));
            return fail(ErrorKind::rejected,
                        fmt::format("triangle {} at ({:.6g}, {:.6g}, {:.6g}) mm lies in the region and has no area: "
                                    "remesh the region (--max-edge) or repair the model there",
                                    t, p.x(), p.y(), p.z()));
        }
        for (const int e : topology.face_edges(t)) {
            const MeshEdge& edge = topology.edge(e);
            if (edge.face_count > 2) {
                return fail(ErrorKind::rejected,
                            fmt::format("{} lies in the region and joins {} triangles: take a smaller region or "
                                        "separate the surfaces that meet there",
                                        edge_place(mesh, edge.a, edge.b), edge.face_count));
            }
            if (edge.face_count == 2 && (edge.left < 0 || edge.right < 0)) {
                return fail(ErrorKind::rejected,
                            fmt::format("the triangles on both sides of {} disagree about which side is outside: take "
                                        "a smaller region or cut the one-sided surface open",
                                        edge_place(mesh, edge.a, edge.b)));
            }
        }
    }
    return {};
}

} // namespace tapeline
