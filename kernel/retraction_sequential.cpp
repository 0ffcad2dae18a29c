// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/parallel.h"
#include "kernel/retraction_steps.h"
#include "kernel/sliding.h"

#include <algorithm>
#include <limits>

namespace tapeline {

namespace {

/// The side's vertices on their way: each is a point of the original surface.
class Sliding {
public:
    Sliding(const RetractionTask& task, double radius);

    /// Vertex v goes to its final place and takes its surroundings along.
    void slide_to_place(int v);
    /// The vertices whose turn comes, in order.
    const std::vector<int>& sequence() const { return sequence_; }
    Positions take() { return std::move(V_); }

private:
    double radius_of(int v) const;
    void follow(int v, const Vec3& u);
    Vec3 normal_at(const MeshPoint& point) const;

    const RetractionTask& task_;
    double radius_;
    Positions V_;
    std::vector<MeshPoint> place_;
    std::vector<int> sequence_, fixed_;
    std::vector<char> moves_; ///< neither fixed nor already in its final place
};

Sliding::Sliding(const RetractionTask& task, double radius)
    : task_(task), radius_(radius), V_(task.inner().V), place_(V_.rows()), moves_(V_.rows(), 0)
{
    const Topology& topology = task.topology();
    for (int v = 0; v < V_.rows(); ++v) {
        if (topology.vertex_faces(v).empty()) {
            continue;
        }
        const int t = topology.vertex_faces(v).front();
        const int corner = task.inner().F(t, 0) == v ? 0 : task.inner().F(t, 1) == v ? 1 : 2;
        place_[v] = {t, Vec3::Unit(corner)};
        const bool stays = task.start().row(v) == V_.row(v);
        if (!task.free(v) && task.line_entry(v) < 0) {
            (stays ? fixed_ : sequence_).push_back(v);
        }
        moves_[v] = task.free(v) || task.line_entry(v) >= 0 || !stays;
    }
    // The line first; borders that slide after it.
    sequence_.insert(sequence_.begin(), task.line().begin(), task.line().end());
}

double Sliding::radius_of(int v) const
{
    if (radius_ > 0) {
        return radius_;
    }
    double least = fixed_.empty() ? bounding_diagonal(V_) : std::numeric_limits<double>::infinity();
    for (const int f : fixed_) {
        least = std::min(least, (V_.row(f) - task_.inner().V.row(v)).norm());
    }
    return least;
}

Vec3 Sliding::normal_at(const MeshPoint& point) const
{
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        sum += point.barycentric[k] * task_.normals().row(task_.inner().F(point.face, k)).transpose();
    }
    return sum.norm() > 0 ? Vec3(sum.normalized()) : triangle_normal(task_.inner(), point.face);
}

void Sliding::follow(int v, const Vec3& u)
{
    const MeshPoint end = slide(task_.inner(), task_.topology(), place_[v], normal_at(place_[v]), u);
    if (end.face >= 0) {
        place_[v] = end;
        V_.row(v) = position_of(task_.inner(), end);
    }
}

void Sliding::slide_to_place(int v)
{
    const Vec3 from = V_.row(v), to = task_.start().row(v);
    const double radius = radius_of(v);
    moves_[v] = 0;
    V_.row(v) = to;
    if (from == to || !(radius > 0)) {
        return;
    }
    parallel_for(static_cast<int>(V_.rows()), [&](int w) {
        const double r = (V_.row(w).transpose() - from).norm() / radius;
        if (moves_[w] && r < 1) {
            follow(w, (1 - r * r) * (1 - r * r) * (to - from));
        }
    });
}

} // namespace

Positions retract_sequentially(const RetractionTask& task, double radius)
{
    Sliding sliding(task, radius);
    for (const int v : sliding.sequence()) {
        sliding.slide_to_place(v);
    }
    return sliding.take();
}

} // namespace tapeline
