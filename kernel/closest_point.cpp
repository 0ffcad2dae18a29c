// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/closest_point.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <Eigen/Geometry>
#include <numeric>
#include <vector>

namespace tapeline {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 from_cgal(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Barycentric weights of p in triangle (a, b, c), clamped to the triangle.
Vec3 barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 n = (b - a).cross(c - a);
    const double inverse = 1 / n.squaredNorm();
    Vec3 w((c - b).cross(p - b).dot(n) * inverse, (a - c).cross(p - c).dot(n) * inverse,
           (b - a).cross(p - a).dot(n) * inverse);
    w = w.cwiseMax(0);
    return w / w.sum();
}

} // namespace

struct ClosestPoint::Impl {
    std::vector<Triangle> triangles;
    std::vector<int> faces;
    Tree tree;
};

ClosestPoint::ClosestPoint(const Mesh& mesh, std::span<const int> faces) : impl_(std::make_unique<Impl>())
{
    impl_->triangles.reserve(faces.size());
    for (const int t : faces) {
        const Triangle triangle(to_cgal(mesh.V.row(mesh.F(t, 0))), to_cgal(mesh.V.row(mesh.F(t, 1))),
                                to_cgal(mesh.V.row(mesh.F(t, 2))));
        if (triangle.squared_area() > 0) {
            impl_->triangles.push_back(triangle);
            impl_->faces.push_back(t);
        }
    }
    impl_->tree.insert(impl_->triangles.cbegin(), impl_->triangles.cend());
    if (!impl_->triangles.empty()) {
        impl_->tree.build();
        impl_->tree.accelerate_distance_queries();
        // The search tree for hints is built lazily; one query now makes later ones safe from several threads.
        closest(from_cgal(impl_->triangles.front()[0]));
    }
}

ClosestPoint::ClosestPoint(const Mesh& mesh)
    : ClosestPoint(mesh, [&] {
          std::vector<int> all(mesh.F.rows());
          std::iota(all.begin(), all.end(), 0);
          return all;
      }())
{
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

MeshFoot ClosestPoint::closest(const Vec3& p) const
{
    MeshFoot foot;
    if (impl_->triangles.empty()) {
        return foot;
    }
    const auto [point, primitive] = impl_->tree.closest_point_and_primitive(to_cgal(p));
    const auto index = primitive - impl_->triangles.cbegin();
    const Triangle& triangle = impl_->triangles[index];
    foot.point = from_cgal(point);
    foot.face = impl_->faces[index];
    foot.barycentric = barycentric(foot.point, from_cgal(triangle[0]), from_cgal(triangle[1]), from_cgal(triangle[2]));
    foot.distance = (p - foot.point).norm();
    return foot;
}

} // namespace tapeline
