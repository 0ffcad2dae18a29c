// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/quality_detail.h"
#include "kernel/sections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tapeline::quality {

namespace {

/// A place on the line: on the edge from entry k to entry k + 1.
struct Station {
    int edge = -1;
    double t = 0; ///< fraction of the edge
};

Vec3 point_on(const Context& context, const Positions& V, const Station& s)
{
    return (1 - s.t) * V.row(context.line_from(s.edge)) + s.t * V.row(context.line_to(s.edge));
}

/// Unit tangent at entry i of the line: of the circle through it and its neighbours.
Vec3 tangent_at(const Context& context, const Positions& V, int i)
{
    const int count = static_cast<int>(context.input.line.size());
    const auto at = [&](int k) { return Vec3(V.row(context.input.line[(k + count) % count])); };
    if (!context.input.closed && (i == 0 || i == count - 1)) {
        const int k = i == 0 ? 0 : count - 2;
        return (at(k + 1) - at(k)).normalized();
    }
    const Vec3 before = at(i) - at(i - 1), after = at(i + 1) - at(i);
    const double l1 = before.norm(), l2 = after.norm();
    if (l1 <= 0 || l2 <= 0) {
        return (before + after).normalized();
    }
    return (before * (l2 / l1) + after * (l1 / l2)).normalized();
}

Vec3 tangent_on(const Context& context, const Positions& V, const Station& s)
{
    const int next = (s.edge + 1) % static_cast<int>(context.input.line.size());
    const Vec3 along = V.row(context.line_to(s.edge)) - V.row(context.line_from(s.edge));
    const Vec3 blend = (1 - s.t) * tangent_at(context, V, s.edge) + s.t * tangent_at(context, V, next);
    return blend.norm() > 0.5 ? blend.normalized() : along.normalized();
}

std::vector<Station> stations(const Context& context)
{
    const Positions& V = context.moved.V;
    std::vector<double> arc{0};
    for (int k = 0; k < context.line_edges(); ++k) {
        arc.push_back(arc.back() + (V.row(context.line_to(k)) - V.row(context.line_from(k))).norm());
    }
    std::vector<Station> result;
    for (int i = 0; i < context.input.stations && arc.back() > 0; ++i) {
        const double s = (i + 0.5) / context.input.stations * arc.back();
        const auto next = std::upper_bound(arc.begin() + 1, arc.end() - 1, s) - arc.begin();
        result.push_back({static_cast<int>(next) - 1, (s - arc[next - 1]) / (arc[next] - arc[next - 1])});
    }
    return result;
}

struct Plane {
    Vec3 origin, normal;
    double height(const Vec3& p) const { return (p - origin).dot(normal); }
};

/// Where the plane separates the ends of a line's edge, nearest to `near`; edge -1 when it does not meet the line.
Station crossing(const Context& context, const Positions& V, const Plane& plane, const Vec3& near)
{
    Station best;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < context.line_edges(); ++k) {
        const double a = plane.height(V.row(context.line_from(k))), b = plane.height(V.row(context.line_to(k)));
        if ((a >= 0) == (b >= 0)) {
            continue;
        }
        const Station here{k, a / (a - b)};
        const double distance = (point_on(context, V, here) - near).norm();
        if (distance < nearest) {
            nearest = distance;
            best = here;
        }
    }
    return best;
}

/// One half of a section: points and, for each, the sagitta of the edge that it lies on.
struct Half {
    std::vector<Vec3> points;
    std::vector<double> sagitta;
};

/// Normal of the marked triangles around v, weighted by angle.
Vec3 side_normal(const Context& context, const Mesh& mesh, const Positions& normals, int v,
                 const std::vector<char>& marked)
{
    Vec3 sum = Vec3::Zero();
    for (const int t : context.topology.vertex_faces(v)) {
        if (marked[t]) {
            const int k = mesh.F(t, 0) == v ? 0 : (mesh.F(t, 1) == v ? 1 : 2);
            const Vec3 p = mesh.V.row(v);
            const Vec3 e1 = mesh.V.row(mesh.F(t, (k + 1) % 3)).transpose() - p;
            const Vec3 e2 = mesh.V.row(mesh.F(t, (k + 2) % 3)).transpose() - p;
            sum += std::atan2(e1.cross(e2).norm(), e1.dot(e2)) * normals.row(t).transpose();
        }
    }
    return sum.normalized();
}

/// One shape, rest or moved, with one side of the line.
struct SideShape {
    const Context& context;
    const Mesh& mesh;
    const Positions& normals;
    const std::vector<char>& marked;

    /// (n_b - n_a) · (b - a) / 8: how far the middle of a curved edge with these end normals lies from its chord.
    double sagitta(int e) const
    {
        constexpr double crease = 0.87; // cosine of 30°: a crease is no curvature
        const int a = context.topology.edge(e).a, b = context.topology.edge(e).b;
        const Vec3 na = side_normal(context, mesh, normals, a, marked);
        const Vec3 nb = side_normal(context, mesh, normals, b, marked);
        return na.dot(nb) < crease ? 0 : std::abs((nb - na).dot(Vec3(mesh.V.row(b) - mesh.V.row(a)))) / 8;
    }
};

/// The section from the line outwards: starts in triangle `face` on its edge `edge`, which the plane cuts, and goes on
/// from triangle to triangle while they are marked. A vertex in the plane counts as above it, so that every triangle
/// that is met has exactly one way out.
Half trace(const SideShape& shape, const Plane& plane, const Vec3& start, int face, int edge)
{
    const Topology& topology = shape.context.topology;
    const Positions& V = shape.mesh.V;
    Half half{{start}, {shape.sagitta(edge)}};
    for (size_t steps = 0; face >= 0 && shape.marked[face] && steps <= shape.marked.size(); ++steps) {
        int out = -1;
        for (const int e : topology.face_edges(face)) {
            const MeshEdge& candidate = topology.edge(e);
            if (e != edge && (plane.height(V.row(candidate.a)) >= 0) != (plane.height(V.row(candidate.b)) >= 0)) {
                out = e;
            }
        }
        if (out < 0) {
            break;
        }
        const MeshEdge& next = topology.edge(out);
        const double a = plane.height(V.row(next.a)), b = plane.height(V.row(next.b));
        const double t = a / (a - b);
        half.points.emplace_back((1 - t) * V.row(next.a) + t * V.row(next.b));
        half.sagitta.push_back(shape.sagitta(out));
        if (next.face_count != 2) {
            break;
        }
        face = topology.face_across(face, out);
        edge = out;
    }
    return half;
}

/// Marks of the triangles on the compressed and on the tension side. A set that holds both sides of the line is taken
/// apart: its right part then counts to the other set.
std::array<std::vector<char>, 2> marked_sides(const Context& context)
{
    const size_t count = context.side.size();
    std::array<std::vector<char>, 2> marks{std::vector<char>(count, 0), std::vector<char>(count, 0)};
    for (size_t t = 0; t < count; ++t) {
        marks[0][t] = context.side[t] == SideOf::compressed;
        marks[1][t] = context.side[t] == SideOf::tension;
    }
    for (int s = 0; s < 2; ++s) {
        const std::vector<int>& faces = s == 0 ? context.input.compressed_faces : context.input.tension_faces;
        int left = 0, right = 0;
        for (int k = 0; k < context.line_edges(); ++k) {
            const int l = context.topology.face_left_of(context.line_from(k), context.line_to(k));
            const int r = context.topology.face_left_of(context.line_to(k), context.line_from(k));
            left += l >= 0 && marks[s][l];
            right += r >= 0 && marks[s][r];
        }
        if (left == 0 || right == 0) {
            continue;
        }
        for (const int t : sides_of_line(context.rest, faces, context.input.line, context.input.closed).second) {
            marks[s][t] = 0;
            marks[1 - s][t] = 1;
        }
        break;
    }
    return marks;
}

/// Outward normal at the line's edge, laid into the plane.
Vec3 outward_at(const Context& context, const Plane& plane, const Station& at)
{
    const int a = context.line_from(at.edge), b = context.line_to(at.edge);
    Vec3 sum = Vec3::Zero();
    for (const int face : {context.topology.face_left_of(a, b), context.topology.face_left_of(b, a)}) {
        if (face >= 0) {
            sum += context.moved_normals.row(face).transpose();
        }
    }
    sum -= sum.dot(plane.normal) * plane.normal;
    return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3(plane.normal.unitOrthogonal());
}

/// Both halves of the section of one shape; [0] compressed, [1] tension.
std::array<Half, 2> cut(const Context& context, bool after, const Plane& plane, const Station& at,
                        const std::array<std::vector<char>, 2>& marks)
{
    std::array<Half, 2> halves;
    const int edge = context.topology.find_edge(context.line_from(at.edge), context.line_to(at.edge));
    if (edge < 0) {
        return halves;
    }
    const Mesh& mesh = after ? context.moved : context.rest;
    const Positions& normals = after ? context.moved_normals : context.rest_normals;
    const Vec3 start = point_on(context, mesh.V, at);
    for (const int face : {context.topology.edge(edge).left, context.topology.edge(edge).right}) {
        for (int s = 0; s < 2; ++s) {
            if (face >= 0 && marks[s][face] && halves[s].points.empty()) {
                halves[s] = trace({context, mesh, normals, marks[s]}, plane, start, face, edge);
                break;
            }
        }
    }
    return halves;
}

Section section_at(const Context& context, const Station& station, const std::array<std::vector<char>, 2>& marks,
                   double reach)
{
    Section section;
    section.origin = point_on(context, context.moved.V, station);
    section.normal = section.rest_normal = tangent_on(context, context.moved.V, station);
    Plane plane{section.origin, section.normal};
    section.outward = outward_at(context, plane, station);
    const Station after = crossing(context, context.moved.V, plane, section.origin);
    if (after.edge >= 0) {
        auto halves = cut(context, true, plane, after, marks);
        section.compressed_after = std::move(halves[0].points);
        section.tension_after = std::move(halves[1].points);
        section.sagitta[1] = std::move(halves[0].sagitta);
        section.sagitta[3] = std::move(halves[1].sagitta);
    }
    const Vec3 was = point_on(context, context.rest.V, station);
    Station before = crossing(context, context.rest.V, plane, was);
    if (before.edge < 0 || (point_on(context, context.rest.V, before) - was).norm() > reach) {
        // The plane misses the used part of L0: the section of L0 at the same place of the line stands in.
        section.rest_normal = tangent_on(context, context.rest.V, station);
        plane = {was, section.rest_normal};
        before = crossing(context, context.rest.V, plane, was);
    }
    if (before.edge >= 0) {
        auto halves = cut(context, false, plane, before, marks);
        section.compressed_before = std::move(halves[0].points);
        section.tension_before = std::move(halves[1].points);
        section.sagitta[0] = std::move(halves[0].sagitta);
        section.sagitta[2] = std::move(halves[1].sagitta);
    }
    return section;
}

void add(SectionMeasure& measure, const SectionShape& before, const SectionShape& after)
{
    measure.inflections_before = std::max(measure.inflections_before, before.inflections);
    measure.inflections_after = std::max(measure.inflections_after, after.inflections);
    measure.turning_before = std::max(measure.turning_before, before.turning);
    measure.turning_after = std::max(measure.turning_after, after.turning);
    measure.turning_increase = std::max(measure.turning_increase, after.turning - before.turning);
}

} // namespace

std::vector<Section> cut_sections(const Context& context)
{
    const std::vector<Station> places = stations(context);
    const auto marks = marked_sides(context);
    double reach = 0; // how far along L0 the plane of a slid line may meet it
    for (const int v : context.input.line) {
        reach = std::max(reach, (context.moved.V.row(v) - context.rest.V.row(v)).norm());
    }
    for (int k = 0; k < context.line_edges(); ++k) {
        reach =
            std::max(reach, (context.rest.V.row(context.line_to(k)) - context.rest.V.row(context.line_from(k))).norm());
    }
    std::vector<Section> sections(places.size());
    parallel_for(
        static_cast<int>(places.size()), [&](int i) { sections[i] = section_at(context, places[i], marks, 3 * reach); },
        1);
    return sections;
}

void measure_sections(const Context& context, QualityReport& report)
{
    bool first = true;
    for (const Section& section : cut_sections(context)) {
        const SectionShapes shapes = section_shapes(section);
        if (first) {
            report.compressed_sections.turning_increase = -std::numeric_limits<double>::infinity();
            report.tension_sections.turning_increase = -std::numeric_limits<double>::infinity();
            first = false;
        }
        add(report.compressed_sections, shapes.compressed_before, shapes.compressed_after);
        add(report.tension_sections, shapes.tension_before, shapes.tension_after);
    }
}

} // namespace tapeline::quality
