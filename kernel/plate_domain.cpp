// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate_domain.h"

#include "kernel/deformation.h"
#include "kernel/line_tangents.h"

#include <algorithm>
#include <cmath>

namespace tapeline {

namespace {

/// A triangle that keeps less than this share of its area is not a domain to solve on.
constexpr double least_area = 1e-3;

} // namespace

FittedMotion fitted_motion(const Positions& V, const std::vector<int>& vertices, const Positions& targets,
                           const std::vector<int>& entries)
{
    FittedMotion motion;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    for (const int i : entries) {
        from += V.row(vertices[i]);
        to += targets.row(i);
        motion.still = motion.still && targets.row(i) == V.row(vertices[i]);
    }
    if (motion.still) {
        return motion;
    }
    from /= static_cast<double>(entries.size());
    to /= static_cast<double>(entries.size());
    Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
    for (const int i : entries) {
        S += (targets.row(i).transpose() - to) * (V.row(vertices[i]) - from.transpose());
    }
    motion.R = polar_rotation(S);
    motion.shift = to - motion.R * from;
    return motion;
}

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

double plate_width(const Mesh& mesh, const std::vector<int>& line, bool closed)
{
    double area = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        area += triangle_area(mesh, t);
    }
    return area / std::max(line_length(mesh.V, line, closed), std::sqrt(area));
}

} // namespace tapeline
