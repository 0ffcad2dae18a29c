// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/retraction_steps.h"
#include "kernel/sliding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>

namespace tapeline {

namespace {

/// Neighbouring section curves count as crossing when each lies on both sides of the other's plane by more than this
/// share of the distance between their vertices; below, they are the same curve up to the noise of vertex normals.
constexpr double crossing_share = 1e-3;

/// One half of the section curve C_P: from P to a border of the side.
struct Branch {
    bool reached = false;  ///< false: the curve closes or there is none
    double length = 0;     ///< [mm]
    Vec3 u = Vec3::Zero(); ///< displacement of the border there: interpolated on the line, zero elsewhere
    std::vector<std::pair<int, Vec3>> points; ///< crossing points and the triangle that ends there
};

class Sections {
public:
    explicit Sections(const RetractionTask& task);

    bool any() const { return direction_.norm() > 0; }
    Vec3 displacement(int v) const;
    int crossings(int v) const;

private:
    Vec3 plane(int v) const;
    std::array<Branch, 2> section(int v, bool keep_points) const;
    Branch follow(int v, const Vec3& normal, int face, bool keep_points) const;
    std::pair<double, Vec3> at_border(int edge, double t, const Vec3& before, const Vec3& point) const;
    Vec3 by_graph(int v) const;
    std::vector<double> graph_distances(const std::vector<int>& sources, std::vector<int>& nearest) const;

    const RetractionTask& task_;
    Vec3 direction_ = Vec3::Zero();
    Positions normals_;
    std::vector<int> nearest_line_;
    std::vector<double> to_line_, to_rim_;
};

Sections::Sections(const RetractionTask& task) : task_(task), normals_(vertex_normals(task.inner()))
{
    double length = 0;
    for (const Vec3& u : task.moves()) {
        direction_ += u;
        length += u.norm();
    }
    if (!(length > 0)) {
        direction_.setZero();
        return;
    }
    // Displacements that cancel have no mean direction: then the longest one gives it.
    if (direction_.norm() < 1e-3 * length) {
        direction_ = *std::ranges::max_element(task.moves(), {}, [](const Vec3& u) { return u.norm(); });
    }
    direction_.normalize();
    std::vector<int> rim, unused;
    for (int v = 0; v < task.inner().V.rows(); ++v) {
        if (!task.free(v) && task.line_entry(v) < 0) {
            rim.push_back(v);
        }
    }
    to_line_ = graph_distances(task.line(), nearest_line_);
    to_rim_ = graph_distances(rim, unused);
}

std::vector<double> Sections::graph_distances(const std::vector<int>& sources, std::vector<int>& nearest) const
{
    const Topology& topology = task_.topology();
    std::vector<double> distance(topology.vertex_count(), std::numeric_limits<double>::infinity());
    nearest.assign(topology.vertex_count(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const int v : sources) {
        distance[v] = 0;
        nearest[v] = v;
        queue.emplace(0, v);
    }
    while (!queue.empty()) {
        const auto [d, v] = queue.top();
        queue.pop();
        if (d > distance[v]) {
            continue;
        }
        for (const int e : topology.vertex_edges(v)) {
            const int w = topology.other_end(e, v);
            const double next = d + (task_.position(w) - task_.position(v)).norm();
            if (next < distance[w]) {
                distance[w] = next;
                nearest[w] = nearest[v];
                queue.emplace(next, w);
            }
        }
    }
    return distance;
}

/// Unit normal of the plane through P spanned by the averaged surface normal and the displacement direction; zero
/// where these two are parallel.
Vec3 Sections::plane(int v) const
{
    const Vec3 q = Vec3(normals_.row(v)).cross(direction_);
    const double size = q.norm();
    return size > 1e-6 ? Vec3(q / size) : Vec3::Zero();
}

/// Length and displacement that the section's end adds: `point` lies on border edge `edge` at share t from its a.
std::pair<double, Vec3> Sections::at_border(int edge, double t, const Vec3& before, const Vec3& point) const
{
    const MeshEdge& e = task_.topology().edge(edge);
    const int i = task_.line_entry(e.a), j = task_.line_entry(e.b);
    const int last = static_cast<int>(task_.line().size()) - 1;
    const bool on_line = i >= 0 && j >= 0 && (std::abs(i - j) == 1 || (task_.closed() && std::abs(i - j) == last));
    const Vec3 u = on_line ? Vec3((1 - t) * task_.moves()[i] + t * task_.moves()[j]) : Vec3::Zero();
    return {(point - before).norm(), u};
}

/// Follows the plane from v through triangle `face` until it leaves the side. A vertex in the plane counts as lying on
/// its positive side, so the section always passes through edges.
Branch Sections::follow(int v, const Vec3& normal, int face, bool keep_points) const
{
    const Topology& topology = task_.topology();
    const Vec3 p = task_.position(v);
    const auto height = [&](int w) { return normal.dot(task_.position(w) - p); };
    Branch branch;
    Vec3 before = p;
    int entered = -1;
    for (int steps = 0; steps <= topology.face_count() && face >= 0; ++steps) {
        int leave = -1;
        for (const int e : topology.face_edges(face)) {
            const MeshEdge& edge = topology.edge(e);
            const bool at_start = entered < 0 && (edge.a == v || edge.b == v);
            if (e != entered && !at_start && (height(edge.a) >= 0) != (height(edge.b) >= 0)) {
                leave = e;
            }
        }
        if (leave < 0 || (entered >= 0 && (topology.edge(leave).a == v || topology.edge(leave).b == v))) {
            return branch;
        }
        const MeshEdge& edge = topology.edge(leave);
        const double ha = height(edge.a), hb = height(edge.b);
        const double t = std::clamp(ha / (ha - hb), 0.0, 1.0);
        const Vec3 point = (1 - t) * task_.position(edge.a) + t * task_.position(edge.b);
        const auto [length, u] = at_border(leave, t, before, point);
        branch.length += length;
        if (keep_points) {
            branch.points.emplace_back(face, point);
        }
        if (edge.face_count != 2) {
            branch.reached = true;
            branch.u = u;
            return branch;
        }
        before = point;
        entered = leave;
        face = topology.face_across(face, leave);
    }
    return branch;
}

/// The section curve of v: [0] against the displacement direction (towards L0, as a rule), [1] along it.
std::array<Branch, 2> Sections::section(int v, bool keep_points) const
{
    const Vec3 normal = plane(v);
    const Vec3 p = task_.position(v);
    std::array<int, 2> face{-1, -1};
    std::array<double, 2> reach{0, 0};
    const Triangles& F = task_.inner().F;
    for (const int t : task_.topology().vertex_faces(v)) {
        const int k = F(t, 0) == v ? 0 : (F(t, 1) == v ? 1 : 2);
        const Vec3 a = task_.position(F(t, (k + 1) % 3)) - p, b = task_.position(F(t, (k + 2) % 3)) - p;
        const double ha = normal.dot(a), hb = normal.dot(b);
        if ((ha >= 0) == (hb >= 0)) {
            continue;
        }
        const Vec3 exit = a + (b - a) * (ha / (ha - hb));
        const double along = exit.normalized().dot(direction_);
        const int side = along > 0;
        if (std::abs(along) > reach[side]) {
            reach[side] = std::abs(along);
            face[side] = t;
        }
    }
    std::array<Branch, 2> branches;
    for (int s = 0; s < 2; ++s) {
        if (face[s] >= 0 && !normal.isZero(0)) {
            branches[s] = follow(v, normal, face[s], keep_points);
        }
    }
    return branches;
}

Vec3 Sections::by_graph(int v) const
{
    const int foot = nearest_line_[v];
    if (foot < 0) {
        return Vec3::Zero();
    }
    const double sum = to_line_[v] + to_rim_[v];
    const double lambda = std::isinf(to_rim_[v]) ? 1 : (sum > 0 ? to_rim_[v] / sum : 0);
    return lambda * task_.moves()[task_.line_entry(foot)];
}

Vec3 Sections::displacement(int v) const
{
    const auto [back, ahead] = section(v, false);
    const double sum = back.length + ahead.length;
    if (!back.reached || !ahead.reached || !(sum > 0)) {
        return by_graph(v);
    }
    return (ahead.length * back.u + back.length * ahead.u) / sum;
}

int Sections::crossings(int v) const
{
    const auto curve = section(v, true);
    int count = 0;
    for (const int e : task_.topology().vertex_edges(v)) {
        const int w = task_.topology().other_end(e, v);
        const Vec3 normal = plane(w);
        if (w < v || !task_.free(w) || normal.isZero(0)) {
            continue;
        }
        const Vec3 q = task_.position(w);
        const double limit = crossing_share * (task_.position(v) - q).norm();
        // The side of w's plane that v's curve begins on, and the first triangles where it is on the other side.
        const double here = normal.dot(task_.position(v) - q);
        std::vector<int> beyond;
        double low = here, high = here;
        for (const Branch& branch : curve) {
            double last = here;
            for (const auto& [face, point] : branch.points) {
                const double h = normal.dot(point - q);
                if ((h >= 0) != (last >= 0)) {
                    beyond.push_back(face);
                }
                last = h;
                low = std::min(low, h);
                high = std::max(high, h);
            }
        }
        if (low > -limit || high < limit) {
            continue;
        }
        // Another sheet of the surface may meet w's plane too: the curves cross only in a triangle of both.
        const auto other = section(w, true);
        const bool meet = std::ranges::any_of(other, [&](const Branch& branch) {
            return std::ranges::any_of(
                branch.points, [&](const auto& step) { return std::ranges::find(beyond, step.first) != beyond.end(); });
        });
        count += meet;
    }
    return count;
}

} // namespace

Positions retract_planes(const RetractionTask& task, int& crossings)
{
    Positions V = task.start();
    const Sections sections(task);
    crossings = 0;
    if (!sections.any()) {
        return V;
    }
    std::vector<int> crossed(V.rows(), 0);
    parallel_for(static_cast<int>(V.rows()), [&](int v) {
        if (!task.free(v)) {
            return;
        }
        crossed[v] = sections.crossings(v);
        const Vec3 u = sections.displacement(v);
        if (u.isZero(0)) {
            return;
        }
        const MeshPoint end = slide(task.inner(), task.topology(), v, u);
        if (end.face >= 0) {
            V.row(v) = position_of(task.inner(), end);
        }
    });
    crossings = std::accumulate(crossed.begin(), crossed.end(), 0);
    return V;
}

} // namespace tapeline
