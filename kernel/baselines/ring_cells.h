// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <vector>

namespace tapeline {

/// The n-ring cells of a mesh: the cell of vertex v is the triangles with a corner at most n - 1 edges from v. Sums
/// over all cells cost about n per cell instead of n²: vertices and triangles are numbered along breadth-first layers,
/// in which a cell is a few runs of consecutive numbers, and a run's sum is a difference of two running sums.
class RingCells {
public:
    /// `rings` = n ≥ 1, or 0: every cell is the whole mesh.
    RingCells(const Mesh& mesh, int rings);

    /// In how many cells triangle t is.
    int cells_of(int t) const { return cell_count_[t]; }

    /// Per vertex the sum of `of_triangles` over its cell.
    std::vector<Eigen::Matrix3d> sum_triangles(const std::vector<Eigen::Matrix3d>& of_triangles) const;
    /// Per triangle the sum of `of_vertices` over the vertices whose cells it is in.
    std::vector<Eigen::Matrix3d> sum_vertices(const std::vector<Eigen::Matrix3d>& of_vertices) const;

private:
    /// For each item the runs [first, last) of the other kind's numbers.
    struct Runs {
        std::vector<std::size_t> start;
        std::vector<std::pair<int, int>> list;
    };
    static std::vector<Eigen::Matrix3d> sum(const Runs& runs, const std::vector<int>& order,
                                            const std::vector<Eigen::Matrix3d>& values);

    std::vector<int> vertex_order_, face_order_; ///< number -> vertex, number -> triangle
    Runs faces_of_vertex_, vertices_of_face_;
    std::vector<int> cell_count_;
};

} // namespace tapeline
