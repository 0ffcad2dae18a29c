// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/face_unfold.h"

#include "io/uv_triangles.h"

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>

namespace tapeline {

struct FaceNormals::Impl {
    Handle(Geom_Surface) surface;
};

FaceNormals::FaceNormals(const TopoDS_Face& face)
{
    TopLoc_Location location; // asked for, so that the surface comes in the triangulation's own frame
    impl_ = std::make_unique<Impl>(Impl{BRep_Tool::Surface(face, location)});
}

FaceNormals::~FaceNormals() = default;

std::optional<Vec3> FaceNormals::at(double u, double v) const
{
    if (impl_->surface.IsNull()) {
        return std::nullopt;
    }
    gp_Pnt point;
    gp_Vec du, dv;
    impl_->surface->D1(u, v, point, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    const double size = normal.Magnitude();
    if (!(size > 1e-9 * du.Magnitude() * dv.Magnitude()) || !(size > 0)) {
        return std::nullopt;
    }
    return Vec3(normal.X(), normal.Y(), normal.Z()) / size;
}

double facing(const Vec3& a, const Vec3& b, const Vec3& c, const std::optional<Vec3>& exact_normal)
{
    constexpr double flat = 1e-9;
    const Vec3 normal = (b - a).cross(c - a);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double twice = normal.norm();
    return exact_normal && twice > flat * longest ? normal.dot(*exact_normal) / twice : 1;
}

namespace {

/// The triangulation of a face, with its nodes on CAD edges marked and the edges between those kept.
UvTriangles triangles_of(const TopoDS_Face& face, const Handle(Poly_Triangulation) & triangulation,
                         const TopLoc_Location& location)
{
    UvTriangles out;
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_Pnt p = triangulation->Node(i);
        const gp_Pnt2d uv = triangulation->UVNode(i);
        out.points.emplace_back(p.X(), p.Y(), p.Z());
        out.uv.emplace_back(uv.X(), uv.Y());
    }
    for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
        int a = 0, b = 0, c = 0;
        triangulation->Triangle(t).Get(a, b, c);
        out.triangles.push_back({a - 1, b - 1, c - 1});
    }
    out.fixed.assign(out.points.size(), 0);
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        const auto& polygon = BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(edge.Current()), triangulation, location);
        for (int i = 1; !polygon.IsNull() && i <= polygon->NbNodes(); ++i) {
            out.fixed[polygon->Node(i) - 1] = 1;
            if (i > 1) {
                out.kept_edges.push_back(vertex_pair(polygon->Node(i - 1) - 1, polygon->Node(i) - 1));
            }
        }
    }
    std::ranges::sort(out.kept_edges);
    return out;
}

} // namespace

Unfolded unfold_face(const TopoDS_Face& placed)
{
    const TopoDS_Face face = TopoDS::Face(placed.Oriented(TopAbs_FORWARD));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull() || !triangulation->HasUVNodes()) {
        return {};
    }
    const FaceNormals normals(face);
    UvTriangles work = triangles_of(face, triangulation, location);
    work.facing = [&](int a, int b, int c) {
        const Eigen::Vector2d middle = (work.uv[a] + work.uv[b] + work.uv[c]) / 3;
        return facing(work.points[a], work.points[b], work.points[c], normals.at(middle.x(), middle.y()));
    };
    const Unfolded result = unfold(work);
    if (result.found > result.left) {
        triangulation->ResizeTriangles(static_cast<int>(work.triangles.size()), false);
        for (size_t t = 0; t < work.triangles.size(); ++t) {
            const auto& [a, b, c] = work.triangles[t];
            triangulation->SetTriangle(static_cast<int>(t) + 1, Poly_Triangle(a + 1, b + 1, c + 1));
        }
    }
    return result;
}

} // namespace tapeline
