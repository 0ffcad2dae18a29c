// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/ring_cells.h"

#include "kernel/parallel.h"
#include "kernel/topology.h"

#include <algorithm>
#include <limits>
#include <tbb/enumerable_thread_specific.h>

namespace tapeline {

namespace {

/// Vertices in breadth-first order, each connected part from its lowest vertex.
std::vector<int> breadth_first(const Topology& topology)
{
    const int n = topology.vertex_count();
    std::vector<int> order;
    std::vector<char> seen(n, 0);
    for (int seed = 0; seed < n; ++seed) {
        if (seen[seed]) {
            continue;
        }
        seen[seed] = 1;
        order.push_back(seed);
        for (size_t next = order.size() - 1; next < order.size(); ++next) {
            for (const int e : topology.vertex_edges(order[next])) {
                const int other = topology.other_end(e, order[next]);
                if (!seen[other]) {
                    seen[other] = 1;
                    order.push_back(other);
                }
            }
        }
    }
    return order;
}

std::vector<int> inverse(const std::vector<int>& order)
{
    std::vector<int> number(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        number[order[i]] = static_cast<int>(i);
    }
    return number;
}

/// Sorted distinct numbers as runs of consecutive ones.
std::vector<std::pair<int, int>> runs_of(std::vector<int>& numbers)
{
    std::ranges::sort(numbers);
    std::vector<std::pair<int, int>> runs;
    for (const int number : numbers) {
        if (!runs.empty() && number < runs.back().second) {
            continue;
        }
        if (!runs.empty() && number == runs.back().second) {
            ++runs.back().second;
        } else {
            runs.emplace_back(number, number + 1);
        }
    }
    return runs;
}

/// Marks that need not be wiped between walks.
struct Walker {
    std::vector<int> stamp;
    int walk = 0;
    std::vector<int> found;

    /// All vertices at most `steps` edges from one of `seeds`.
    template <class Seeds>
    const std::vector<int>& around(const Topology& topology, const Seeds& seeds, int steps)
    {
        stamp.resize(topology.vertex_count(), 0);
        ++walk;
        found.clear();
        for (const int v : seeds) {
            if (stamp[v] != walk) {
                stamp[v] = walk;
                found.push_back(v);
            }
        }
        for (size_t layer = 0, end = found.size(); steps > 0 && layer < end; --steps, end = found.size()) {
            for (; layer < end; ++layer) {
                const int v = found[layer];
                for (const int e : topology.vertex_edges(v)) {
                    const int other = topology.other_end(e, v);
                    if (stamp[other] != walk) {
                        stamp[other] = walk;
                        found.push_back(other);
                    }
                }
            }
        }
        return found;
    }
};

} // namespace

RingCells::RingCells(const Mesh& mesh, int rings)
{
    const int n = static_cast<int>(mesh.V.rows()), m = static_cast<int>(mesh.F.rows());
    const Topology topology(mesh.F, n);
    vertex_order_ = breadth_first(topology);
    const std::vector<int> vertex_number = inverse(vertex_order_);
    face_order_.resize(m);
    for (int t = 0; t < m; ++t) {
        face_order_[t] = t;
    }
    const auto lowest = [&](int t) {
        std::array<int, 3> corners = {vertex_number[mesh.F(t, 0)], vertex_number[mesh.F(t, 1)],
                                      vertex_number[mesh.F(t, 2)]};
        std::ranges::sort(corners);
        return corners;
    };
    std::ranges::stable_sort(face_order_, {}, lowest);
    const std::vector<int> face_number = inverse(face_order_);

    if (rings == 0) {
        faces_of_vertex_ = {{0, 1}, {{0, m}}};
        vertices_of_face_ = {{0, 1}, {{0, n}}};
        cell_count_.assign(m, n);
        return;
    }
    std::vector<std::vector<std::pair<int, int>>> of_vertex(n), of_face(m);
    tbb::enumerable_thread_specific<Walker> walkers;
    parallel_for(n, [&](int v) {
        std::vector<int> numbers;
        for (const int near : walkers.local().around(topology, std::array{v}, rings - 1)) {
            for (const int t : topology.vertex_faces(near)) {
                numbers.push_back(face_number[t]);
            }
        }
        of_vertex[v] = runs_of(numbers);
    });
    parallel_for(m, [&](int t) {
        std::vector<int> numbers;
        for (const int near : walkers.local().around(topology, mesh.F.row(t), rings - 1)) {
            numbers.push_back(vertex_number[near]);
        }
        of_face[t] = runs_of(numbers);
    });
    const auto joined = [](const auto& lists) {
        Runs runs{{0}, {}};
        for (const auto& list : lists) {
            runs.list.insert(runs.list.end(), list.begin(), list.end());
            runs.start.push_back(runs.list.size());
        }
        return runs;
    };
    faces_of_vertex_ = joined(of_vertex);
    vertices_of_face_ = joined(of_face);
    for (const auto& runs : of_face) {
        int count = 0;
        for (const auto& [first, last] : runs) {
            count += last - first;
        }
        cell_count_.push_back(count);
    }
}

std::vector<Eigen::Matrix3d> RingCells::sum(const Runs& runs, const std::vector<int>& order,
                                            const std::vector<Eigen::Matrix3d>& values)
{
    std::vector<Eigen::Matrix3d> running(order.size() + 1);
    running[0].setZero();
    for (size_t i = 0; i < order.size(); ++i) {
        running[i + 1] = running[i] + values[order[i]];
    }
    std::vector<Eigen::Matrix3d> sums(runs.start.size() - 1);
    parallel_for(static_cast<int>(sums.size()), [&](int i) {
        sums[i].setZero();
        for (size_t r = runs.start[i]; r < runs.start[i + 1]; ++r) {
            sums[i] += running[runs.list[r].second] - running[runs.list[r].first];
        }
    });
    return sums;
}

std::vector<Eigen::Matrix3d> RingCells::sum_triangles(const std::vector<Eigen::Matrix3d>& of_triangles) const
{
    auto sums = sum(faces_of_vertex_, face_order_, of_triangles);
    sums.resize(vertex_order_.size(), sums.front());
    return sums;
}

std::vector<Eigen::Matrix3d> RingCells::sum_vertices(const std::vector<Eigen::Matrix3d>& of_vertices) const
{
    auto sums = sum(vertices_of_face_, vertex_order_, of_vertices);
    sums.resize(face_order_.size(), sums.front());
    return sums;
}

} // namespace tapeline
