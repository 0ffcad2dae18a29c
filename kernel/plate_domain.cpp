// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate_domain.h"

namespace tapeline {

namespace {

/// A triangle that keeps less than this share of its area is not a domain to solve on.
constexpr double least_area = 1e-3;

} // namespace

Positions stretched_domain(const Mesh& rest, const Positions& start, const std::vector<int>& vertices,
                           const Positions& places, const Material& material)
{
    Positions u = places;
    for (size_t i = 0; i < vertices.size(); ++i) {
        u.row(static_cast<Eigen::Index>(i)) -= start.row(vertices[i]);
    }
    if (u.isZero(0)) {
        return start;
    }
    const Eigen::SparseMatrix<double> K = stiffness_matrix(rest, triangle_elements(rest, material));
    const Mesh stretched{start + harmonic_extension(K, vertices, u), rest.F};
    bool open = stretched.V.allFinite();
    for (int t = 0; t < rest.F.rows() && open; ++t) {
        open = triangle_area(stretched, t) > least_area * triangle_area(rest, t);
    }
    return open ? stretched.V : start;
}

} // namespace tapeline
