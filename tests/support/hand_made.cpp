// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/hand_made.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace tapeline::testing {

Region hand_made_region(const Mesh& mesh, const std::vector<int>& faces)
{
    Region region;
    region.faces = faces;
    const std::set<int> inside(faces.begin(), faces.end());
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::set<int> vertices, rim;
    for (const int t : faces) {
        for (int k = 0; k < 3; ++k) {
            vertices.insert(mesh.F(t, k));
        }
    }
    for (const MeshEdge& e : topology.edges()) {
        if ((e.left >= 0 && inside.contains(e.left)) != (e.right >= 0 && inside.contains(e.right))) {
            rim.insert({e.a, e.b});
        }
    }
    region.vertices.assign(vertices.begin(), vertices.end());
    region.fixed_rim.assign(rim.begin(), rim.end());
    return region;
}

Region whole_mesh_region(const Mesh& mesh)
{
    std::vector<int> faces(mesh.F.rows());
    std::iota(faces.begin(), faces.end(), 0);
    return hand_made_region(mesh, faces);
}

std::vector<int> faces_where(const Mesh& mesh, const std::function<bool(const Vec3&)>& inside)
{
    std::vector<int> faces;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        if (inside(mesh.V.row(mesh.F(t, 0))) && inside(mesh.V.row(mesh.F(t, 1))) && inside(mesh.V.row(mesh.F(t, 2)))) {
            faces.push_back(t);
        }
    }
    return faces;
}

Correspondence hand_made_move(const Mesh& mesh, const std::vector<int>& line,
                              const std::function<Vec3(const Vec3&)>& displacement)
{
    Correspondence c;
    c.line.vertices = line;
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec3 p = mesh.V.row(line[i]);
        c.displacements.push_back(displacement(p));
        c.targets.push_back(p + c.displacements.back());
        c.parameters.push_back(static_cast<double>(i));
        const Vec3 next = mesh.V.row(line[std::min(i + 1, line.size() - 1)]);
        const Vec3 last = mesh.V.row(line[i == 0 ? 0 : i - 1]);
        c.tangents.push_back((next - last).normalized());
    }
    return c;
}

SurfaceCount count_surface(const Mesh& mesh)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    SurfaceCount count;
    std::set<int> used;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        used.insert({mesh.F(t, 0), mesh.F(t, 1), mesh.F(t, 2)});
    }
    count.euler = static_cast<int>(used.size()) - topology.edge_count() + topology.face_count();
    for (const MeshEdge& e : topology.edges()) {
        count.border_edges += e.border() ? 1 : 0;
        count.bad_edges += e.face_count > 2 || (e.face_count == 2 && (e.left < 0 || e.right < 0)) ? 1 : 0;
    }
    return count;
}

double total_area(const Mesh& mesh)
{
    double area = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        area += triangle_area(mesh, t);
    }
    return area;
}

} // namespace tapeline::testing
