// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pull.h"

#include "tests/support/side.h"

#include <cmath>
#include <numbers>

namespace tapeline::testing {

Pull::Pull(Mesh panel, const std::vector<int>& line, const std::function<Vec3(const Vec3&)>& place)
    : mesh(std::move(panel))
{
    constrained = line_across(mesh, line).region.fixed_rim;
    const size_t rim = constrained.size();
    constrained.insert(constrained.end(), line.begin() + 1, line.end() - 1);
    targets = sent_to(mesh.V);
    for (size_t i = rim; i < constrained.size(); ++i) {
        targets.row(static_cast<Eigen::Index>(i)) = place(mesh.V.row(constrained[i]));
    }
}

Positions Pull::sent_to(const Positions& V) const
{
    Positions rows(static_cast<Eigen::Index>(constrained.size()), 3);
    for (size_t i = 0; i < constrained.size(); ++i) {
        rows.row(static_cast<Eigen::Index>(i)) = V.row(constrained[i]);
    }
    return rows;
}

Pull off_surface_pull(int nx, int ny, Diagonals diagonals)
{
    return {crease_panel(nx, ny, diagonals), crease_panel_line(nx, ny), [](const Vec3& p) -> Vec3 {
                return p + Vec3(0, 0, 60 * std::pow(std::cos(p.x() * std::numbers::pi / 800), 2));
            }};
}

Pull crease_slide_pull(int nx, int ny, double slide, Diagonals diagonals)
{
    const ParametricCurve target = crease_slide_target(slide);
    return {crease_panel(nx, ny, diagonals), crease_panel_line(nx, ny),
            [&](const Vec3& p) -> Vec3 { return std::abs(p.x()) < 200 ? target.point(p.x()) : p; }};
}

double largest_difference(const Positions& A, const Positions& B) { return (A - B).rowwise().norm().maxCoeff(); }

} // namespace tapeline::testing
