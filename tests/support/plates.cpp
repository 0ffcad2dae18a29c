// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/plates.h"

#include <algorithm>

namespace tapeline::testing {

PlateSupport holding(const Mesh& mesh, const std::function<bool(const Vec3&)>& held,
                     const std::function<Vec3(const Vec3&)>& where)
{
    PlateSupport support;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (held(mesh.V.row(v))) {
            support.constrained.push_back(v);
        }
    }
    support.targets.resize(static_cast<Eigen::Index>(support.constrained.size()), 3);
    for (size_t i = 0; i < support.constrained.size(); ++i) {
        support.targets.row(static_cast<Eigen::Index>(i)) = where(mesh.V.row(support.constrained[i]));
    }
    return support;
}

PlateStrip::PlateStrip(int n, bool clamped, const Vec3& u, Diagonals diagonals)
{
    const double h = 300.0 / n, end = clamped ? 300 + h : 300;
    const int rows = n + (clamped ? 2 : 1);
    std::vector<int> keep{1};
    if (clamped) {
        keep.push_back(rows - 1);
    }
    mesh = grid(
        n / 2, rows, 0, 150, -h, end, [](double, double) { return 0.0; }, diagonals, keep);
    support = holding(
        mesh, [](const Vec3& p) { return p.y() < 1e-9 || p.y() > 300 - 1e-9; },
        [&](const Vec3& p) { return p.y() > 150 ? Vec3(p + u) : p; });
    for (const int v : support.constrained) {
        if (!clamped && mesh.V(v, 1) > 150) {
            support.free_slope.push_back(v);
            support.line.push_back(v);
        }
    }
}

double PlateStrip::error(const Positions& V, const std::function<double(double)>& share, const Vec3& u) const
{
    double largest = 0;
    for (int v = 0; v < V.rows(); ++v) {
        const Vec3 p = mesh.V.row(v);
        if (p.y() >= 0 && p.y() <= 300) {
            largest = std::max(largest, (Vec3(V.row(v)) - p - share(p.y() / 300) * u).norm());
        }
    }
    return largest;
}

} // namespace tapeline::testing
