// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/exact_surface.h"

#include "io/exact_edge.h"
#include "io/uv_domain.h"
#include "kernel/closest_point.h"
#include "kernel/mesh.h"

#include <BRep_Tool.hxx>
#include <Eigen/Dense>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tapeline {

namespace {

using Vec2 = Eigen::Vector2d;

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

struct Face {
    Handle(Geom_Surface) surface;
    Mesh mesh; ///< the face's own tessellation, placed
    std::vector<Vec2> uv;
    std::unique_ptr<ClosestPoint> tree;
    UvDomain domain;
    std::vector<int> edges;
    Vec2 low, high; ///< where the surface is defined or, in a periodic direction, one period around the face
    Vec2 period = Vec2::Zero();
    double size = 0; ///< bounding diagonal [mm]
    double sign = 1; ///< of the outward normal against dS/du × dS/dv
};

/// One end of an edge's uv polygon.
struct PolygonEnd {
    int vertex;
    Vec2 uv;
};

/// Segments that join the ends of polygons at the same CAD vertex, nearest ends first, so that the polygons close
/// without the small gaps that parameter curves leave at vertices.
void close_polygons(std::vector<PolygonEnd> ends, std::vector<UvDomain::Segment>& segments)
{
    std::ranges::stable_sort(ends, {}, &PolygonEnd::vertex);
    for (size_t first = 0; first < ends.size();) {
        size_t last = first;
        std::vector<std::tuple<double, size_t, size_t>> pairs;
        for (; last < ends.size() && ends[last].vertex == ends[first].vertex; ++last) {
            for (size_t k = first; k < last; ++k) {
                pairs.emplace_back((ends[last].uv - ends[k].uv).norm(), k, last);
            }
        }
        std::ranges::sort(pairs);
        std::vector<char> taken(last - first, 0);
        for (const auto& [distance, a, b] : pairs) {
            if (!taken[a - first] && !taken[b - first]) {
                taken[a - first] = taken[b - first] = 1;
                segments.push_back({ends[a].uv, ends[b].uv});
            }
        }
        first = last;
    }
}

/// The uv polygons of the face's border, finer than the tessellation's.
std::vector<UvDomain::Segment> border_polygons(const TopoDS_Face& face,
                                               const Handle(Poly_Triangulation) & triangulation,
                                               const TopLoc_Location& location)
{
    std::vector<UvDomain::Segment> segments;
    std::vector<PolygonEnd> ends;
    TopTools_IndexedMapOfShape vertices;
    for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
        double first = 0, last = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
        if (curve.IsNull() || edge.Orientation() == TopAbs_INTERNAL) {
            continue;
        }
        const auto& polygon = BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
        constexpr int finer = 16;
        const int count = finer * std::clamp(polygon.IsNull() ? 16 : polygon->NbNodes() - 1, 1, 1000);
        const auto point = [&](double t) { return Vec2(curve->Value(t).X(), curve->Value(t).Y()); };
        Vec2 before = point(first);
        ends.push_back({vertices.Add(TopExp::FirstVertex(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)))), before});
        for (int i = 1; i <= count; ++i) {
            const Vec2 after = point(i == count ? last : first + (last - first) * i / count);
            segments.push_back({before, after});
            before = after;
        }
        ends.push_back({vertices.Add(TopExp::LastVertex(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)))), before});
    }
    close_polygons(std::move(ends), segments);
    return segments;
}

void set_bounds(Face& face)
{
    Vec2 low = face.uv.front(), high = low;
    for (const Vec2& uv : face.uv) {
        low = low.cwiseMin(uv);
        high = high.cwiseMax(uv);
    }
    face.surface->Bounds(face.low.x(), face.high.x(), face.low.y(), face.high.y());
    face.period = Vec2(face.surface->IsUPeriodic() ? face.surface->UPeriod() : 0,
                       face.surface->IsVPeriodic() ? face.surface->VPeriod() : 0);
    for (int k = 0; k < 2; ++k) {
        if (face.period[k] > 0) {
            const double spare = std::max(0.0, face.period[k] - (high[k] - low[k])) / 2;
            face.low[k] = low[k] - spare;
            face.high[k] = face.low[k] + std::max(face.period[k], high[k] - low[k]);
        }
    }
}

Face make_face(const CadFaces& faces, const TopoDS_Face& placed)
{
    Face face;
    const TopoDS_Face forward = TopoDS::Face(placed.Oriented(TopAbs_FORWARD));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(forward, location);
    face.surface = BRep_Tool::Surface(forward);
    for (TopExp_Explorer explorer(forward, TopAbs_EDGE); explorer.More(); explorer.Next()) {
        face.edges.push_back(faces.edge_number(TopoDS::Edge(explorer.Current())));
    }
    if (triangulation.IsNull() || !triangulation->HasUVNodes() || face.surface.IsNull()) {
        return face;
    }
    face.mesh.V.resize(triangulation->NbNodes(), 3);
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        face.mesh.V.row(i - 1) = vec(triangulation->Node(i).Transformed(location.Transformation()).XYZ()).transpose();
        face.uv.emplace_back(triangulation->UVNode(i).X(), triangulation->UVNode(i).Y());
    }
    face.mesh.F.resize(triangulation->NbTriangles(), 3);
    for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
        int a = 0, b = 0, c = 0;
        triangulation->Triangle(t).Get(a, b, c);
        face.mesh.F.row(t - 1) << a - 1, b - 1, c - 1;
    }
    face.size = bounding_diagonal(face.mesh.V);
    face.tree = std::make_unique<ClosestPoint>(face.mesh);
    face.domain = UvDomain(border_polygons(forward, triangulation, location));
    set_bounds(face);
    return face;
}

/// Shifts a parameter by whole periods into the face's range, clamps it where the surface ends.
Vec2 in_range(const Face& face, Vec2 uv)
{
    for (int k = 0; k < 2; ++k) {
        if (face.period[k] > 0) {
            uv[k] -= face.period[k] * std::floor((uv[k] - face.low[k]) / face.period[k]);
        } else {
            uv[k] = std::clamp(uv[k], face.low[k], face.high[k]);
        }
    }
    return uv;
}

struct Foot {
    Vec2 uv;
    Vec3 point;
    bool converged = false;
};

/// Damped Newton steps on |S(u, v) - p|², from a start that is near already.
Foot newton(const Face& face, const Vec3& p, const Vec2& start)
{
    gp_Pnt s;
    gp_Vec du, dv, duu, dvv, duv;
    const auto gap_at = [&](const Vec2& x) -> Vec3 { return vec(face.surface->Value(x.x(), x.y()).XYZ()) - p; };
    Foot foot{start, gap_at(start) + p, false};
    double damping = 0;
    for (int i = 0; i < 50; ++i) {
        face.surface->D2(foot.uv.x(), foot.uv.y(), s, du, dv, duu, dvv, duv);
        const Vec3 gap = vec(s.XYZ()) - p;
        const Vec3 su = vec(du.XYZ()), sv = vec(dv.XYZ());
        const Vec2 slope(su.dot(gap), sv.dot(gap));
        Eigen::Matrix2d gauss;
        gauss << su.dot(su), su.dot(sv), su.dot(sv), sv.dot(sv);
        Eigen::Matrix2d H = gauss;
        H(0, 0) += gap.dot(vec(duu.XYZ()));
        H(1, 1) += gap.dot(vec(dvv.XYZ()));
        H(0, 1) += gap.dot(vec(duv.XYZ()));
        H(1, 0) = H(0, 1);
        if (!(H.determinant() > 1e-3 * gauss.determinant() && H(0, 0) > 0)) {
            H = gauss;
        }
        // A degenerate point (a pole) has no derivative in one direction: keep that parameter.
        const double smallest = 1e-14 * gauss.trace() + std::numeric_limits<double>::min();
        for (int k = 0; k < 2; ++k) {
            H(k, k) += damping * gauss(k, k) + smallest;
        }
        Vec2 next = foot.uv - Vec2(H.inverse() * slope);
        for (int k = 0; k < 2; ++k) {
            next[k] = face.period[k] > 0 ? next[k] : std::clamp(next[k], face.low[k], face.high[k]);
        }
        const Vec2 step = next - foot.uv;
        const double moved = (su * step.x() + sv * step.y()).norm();
        const Vec3 next_gap = gap_at(next);
        if (moved <= 1e-13 * (face.size + p.norm())) {
            foot.converged = true;
            return foot;
        }
        // Squared distances stop telling steps apart at the square root of rounding; the last steps are taken on trust.
        if (next_gap.squaredNorm() <= gap.squaredNorm() * (1 + 1e-13) + 1e-26 * face.size * face.size) {
            foot = {next, next_gap + p, false};
            damping = damping > 1e-6 ? damping / 10 : 0;
        } else {
            damping = damping > 0 ? damping * 10 : 1e-3;
            if (damping > 1e12) {
                break;
            }
        }
    }
    return foot;
}

} // namespace

struct ExactSurface::Impl {
    std::vector<Face> faces;
    std::vector<ExactEdge> edges;

    std::optional<SurfaceFoot> foot_on(const Face& face, const Vec3& p) const;
    SurfaceFoot with_normal(const Face& face, const Vec2& uv, const Vec3& point, int triangle) const;
};

SurfaceFoot ExactSurface::Impl::with_normal(const Face& face, const Vec2& uv, const Vec3& point, int triangle) const
{
    gp_Pnt s;
    gp_Vec du, dv;
    face.surface->D1(uv.x(), uv.y(), s, du, dv);
    const Vec3 su = vec(du.XYZ()), sv = vec(dv.XYZ());
    Vec3 normal = su.cross(sv);
    if (normal.norm() > 1e-9 * (su.squaredNorm() + sv.squaredNorm())) {
        normal.normalize();
    } else {
        normal = triangle_normal(face.mesh, triangle);
    }
    return {point, face.sign * normal};
}

std::optional<SurfaceFoot> ExactSurface::Impl::foot_on(const Face& face, const Vec3& p) const
{
    const MeshFoot near = face.tree->closest(p);
    if (near.face < 0) {
        return std::nullopt;
    }
    Vec2 start = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
        start += near.barycentric[k] * face.uv[face.mesh.F(near.face, k)];
    }
    Foot foot = newton(face, p, start);
    if (!foot.converged) {
        const GeomAPI_ProjectPointOnSurf projection(gp_Pnt(p.x(), p.y(), p.z()), face.surface, face.low.x(),
                                                    face.high.x(), face.low.y(), face.high.y());
        if (projection.NbPoints() > 0 && projection.LowerDistance() < (foot.point - p).norm()) {
            double u = 0, v = 0;
            projection.LowerDistanceParameters(u, v);
            foot = {Vec2(u, v), vec(projection.NearestPoint().XYZ()), true};
        }
    }
    foot.uv = in_range(face, foot.uv);
    if (face.domain.contains(foot.uv)) {
        return with_normal(face, foot.uv, foot.point, near.face);
    }
    std::optional<Vec3> border;
    for (const int e : face.edges) {
        const std::optional<Vec3> candidate = e < 0 ? std::nullopt : edges[e].closest(p);
        if (candidate && (!border || (*candidate - p).squaredNorm() < (*border - p).squaredNorm())) {
            border = candidate;
        }
    }
    if (!border) {
        return with_normal(face, foot.uv, foot.point, near.face);
    }
    return with_normal(face, newton(face, *border, start).uv, *border, near.face);
}

ExactSurface::ExactSurface(const CadFaces& faces, const Model& model)
{
    auto impl = std::make_unique<Impl>();
    std::vector<std::vector<double>> parameters(faces.edges.size());
    for (const TopoDS_Face& face : faces.faces) {
        impl->faces.push_back(make_face(faces, face));
        TopLoc_Location location;
        const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
        for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More() && !triangulation.IsNull(); explorer.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
            const auto& polygon = BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
            std::vector<double>& own = parameters[faces.edge_number(edge)];
            if (own.empty() && !polygon.IsNull() && polygon->HasParameters()) {
                for (int i = 1; i <= polygon->NbNodes(); ++i) {
                    own.push_back(polygon->Parameter(i));
                }
                std::ranges::sort(own);
            }
        }
    }
    for (size_t e = 0; e < faces.edges.size(); ++e) {
        impl->edges.emplace_back(faces.edges[e], std::move(parameters[e]));
    }
    // The mesh decides which side is outside: its triangles may have been turned to agree with each other.
    std::vector<double> largest(impl->faces.size(), 0);
    for (int t = 0; t < model.mesh.F.rows(); ++t) {
        Face& face = impl->faces[model.cad_face[t]];
        const double area = triangle_area(model.mesh, t);
        if (!face.tree || area <= largest[model.cad_face[t]]) {
            continue;
        }
        largest[model.cad_face[t]] = area;
        Vec3 middle = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            middle += Vec3(model.mesh.V.row(model.mesh.F(t, k))) / 3;
        }
        const auto foot = impl->foot_on(face, middle);
        if (foot && foot->normal.dot(triangle_normal(model.mesh, t)) < 0) {
            face.sign = -face.sign;
        }
    }
    impl_ = std::move(impl);
}

ExactSurface::~ExactSurface() = default;

int ExactSurface::face_count() const { return static_cast<int>(impl_->faces.size()); }

std::optional<SurfaceFoot> ExactSurface::closest(int cad_face, const Vec3& p) const
{
    if (cad_face < 0 || cad_face >= face_count() || !impl_->faces[cad_face].tree || !p.allFinite()) {
        return std::nullopt;
    }
    try {
        return impl_->foot_on(impl_->faces[cad_face], p);
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
}

std::optional<Vec3> ExactSurface::closest_on_edge(int cad_edge, const Vec3& p) const
{
    if (cad_edge < 0 || cad_edge >= static_cast<int>(impl_->edges.size()) || !p.allFinite()) {
        return std::nullopt;
    }
    try {
        return impl_->edges[cad_edge].closest(p);
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
}

} // namespace tapeline
