// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polygon.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

namespace tapeline {

namespace {

using Corners = std::array<int, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
enum class Place { unknown, inside, outside };
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces =
    CGAL::Triangulation_face_base_with_info_2<Place, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                               CGAL::No_constraint_intersection_tag>;

std::vector<int> without_repeats(std::span<const int> polygon)
{
    std::vector<int> corners;
    for (const int v : polygon) {
        if (corners.empty() || corners.back() != v) {
            corners.push_back(v);
        }
    }
    while (corners.size() > 1 && corners.back() == corners.front()) {
        corners.pop_back();
    }
    return corners;
}

/// Newell's normal: its length is twice the area of the polygon's projection along it.
Vec3 newell_normal(std::span<const Vec3> points, std::span<const int> polygon)
{
    Vec3 sum = Vec3::Zero();
    const Vec3& origin = points[polygon[0]];
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        sum += (points[polygon[k]] - origin).cross(points[polygon[k + 1]] - origin);
    }
    return sum;
}

std::vector<Corners> fan(const std::vector<int>& polygon)
{
    std::vector<Corners> triangles;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
    }
    return triangles;
}

std::optional<std::vector<Corners>> split_quad(std::span<const Vec3> points, const std::vector<int>& q, const Vec3& n)
{
    const auto faces_up = [&](int a, int b, int c) {
        const Vec3 u = points[q[b]] - points[q[a]], w = points[q[c]] - points[q[a]];
        return u.cross(w).dot(n) > 1e-9 * n.squaredNorm();
    };
    const bool first = faces_up(0, 1, 2) && faces_up(0, 2, 3);
    const bool second = faces_up(1, 2, 3) && faces_up(1, 3, 0);
    if (!first && !second) {
        return std::nullopt;
    }
    const double length_first = (points[q[0]] - points[q[2]]).norm(),
                 length_second = (points[q[1]] - points[q[3]]).norm();
    if (first && (!second || length_first <= length_second * (1 + 1e-6))) {
        return std::vector<Corners>{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}};
    }
    return std::vector<Corners>{{q[1], q[2], q[3]}, {q[1], q[3], q[0]}};
}

/// One polygon's constrained triangulation in its plane.
class PlanePolygon {
public:
    PlanePolygon(std::span<const Vec3> points, const std::vector<int>& polygon, const Vec3& normal)
        : points_(points), polygon_(polygon)
    {
        const Vec3 n = normal.normalized();
        int smallest = 0;
        n.cwiseAbs().minCoeff(&smallest);
        u_ = n.cross(Vec3::Unit(smallest)).normalized();
        v_ = n.cross(u_);
    }

    /// False where corners with different numbers coincide, or sides cross or run through another corner.
    bool build()
    {
        std::map<int, Delaunay::Vertex_handle> handles;
        Delaunay::Face_handle near;
        for (const int corner : polygon_) {
            if (handles.contains(corner)) {
                continue;
            }
            const std::size_t known = triangulation_.number_of_vertices();
            const Vec3 d = points_[corner] - points_[polygon_[0]];
            const auto handle = triangulation_.insert({d.dot(u_), d.dot(v_)}, near);
            if (triangulation_.number_of_vertices() == known) {
                return false;
            }
            near = handle->face();
            handle->info() = corner;
            handles[corner] = handle;
        }
        for (std::size_t k = 0; k < polygon_.size(); ++k) {
            const int a = polygon_[k], b = polygon_[(k + 1) % polygon_.size()];
            if (uses_[std::minmax(a, b)]++ == 0) { // a second time would be taken for an intersection
                triangulation_.insert_constraint(handles[a], handles[b]);
            }
        }
        return std::ranges::all_of(uses_, [&](const auto& side) {
            return triangulation_.is_edge(handles[side.first.first], handles[side.first.second]);
        });
    }

    /// The triangles inside, and twice their area.
    std::pair<std::vector<Corners>, double> triangles()
    {
        mark();
        std::vector<Corners> result;
        double area = 0;
        for (const auto face : triangulation_.finite_face_handles()) {
            if (face->info() == Place::inside) {
                result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
                area += 2 * triangulation_.triangle(face).area();
            }
        }
        return {result, area};
    }

private:
    /// From the outside in; a side used twice (the bridge to a hole) has the same on both hands.
    void mark()
    {
        for (const auto face : triangulation_.all_face_handles()) {
            face->info() = Place::unknown;
        }
        std::vector<Delaunay::Face_handle> stack{triangulation_.infinite_face()};
        stack.back()->info() = Place::outside;
        while (!stack.empty()) {
            const auto face = stack.back();
            stack.pop_back();
            for (int k = 0; k < 3; ++k) {
                const auto next = face->neighbor(k);
                if (next->info() != Place::unknown) {
                    continue;
                }
                bool crosses = false;
                if (face->is_constrained(k)) {
                    const int a = face->vertex(Delaunay::ccw(k))->info(), b = face->vertex(Delaunay::cw(k))->info();
                    crosses = uses_[std::minmax(a, b)] % 2 == 1;
                }
                next->info() = (face->info() == Place::inside) != crosses ? Place::inside : Place::outside;
                stack.push_back(next);
            }
        }
    }

    std::span<const Vec3> points_;
    const std::vector<int>& polygon_;
    Vec3 u_, v_;
    Delaunay triangulation_;
    std::map<std::pair<int, int>, int> uses_; ///< how often a side occurs in the polygon
};

} // namespace

std::optional<std::vector<Corners>> triangulate_polygon(std::span<const Vec3> points, std::span<const int> polygon)
{
    const std::vector<int> corners = without_repeats(polygon);
    if (corners.size() < 3) {
        return std::vector<Corners>{};
    }
    if (corners.size() == 3) {
        return fan(corners);
    }
    double extent = 0;
    for (const int v : corners) {
        extent = std::max(extent, (points[v] - points[corners[0]]).norm());
    }
    const Vec3 normal = newell_normal(points, corners);
    if (!(normal.norm() > 1e-12 * extent * extent)) {
        return fan(corners);
    }
    if (corners.size() == 4) {
        return split_quad(points, corners, normal);
    }
    try {
        PlanePolygon plane(points, corners, normal);
        if (!plane.build()) {
            return std::nullopt;
        }
        auto [triangles, area] = plane.triangles();
        // An outline that runs round twice, or whose loops turn against each other, encloses another area than it says.
        if (std::abs(area - normal.norm()) > 1e-6 * normal.norm()) {
            return std::nullopt;
        }
        return triangles;
    } catch (const std::exception&) { // CGAL: sides cross
        return std::nullopt;
    }
}

} // namespace tapeline
