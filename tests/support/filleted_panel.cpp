// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/filleted_panel.h"

#include "kernel/strip.h"
#include "tests/support/moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::testing {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int bend_rows = 6, side_rows = 16, columns = 72;

/// y of the rows of vertices: even on the far side, even through the bend, growing beyond it.
std::vector<double> rows(double bend)
{
    std::vector<double> y;
    for (int j = -side_rows; j <= 0; ++j) {
        y.push_back(220.0 * j / side_rows);
    }
    for (int j = 1; j <= bend_rows; ++j) {
        y.push_back(bend * j / bend_rows);
    }
    for (int j = 1; j <= 2 * side_rows; ++j) {
        const double t = j / (2.0 * side_rows);
        y.push_back(bend + (220 - bend) * (0.2 * t + 0.8 * t * t));
    }
    return y;
}

} // namespace

FilletedPanel::FilletedPanel(double bend_width, double other_width)
    : width(bend_width), last_width(other_width > 0 ? other_width : bend_width)
{
    const int ny = static_cast<int>(rows(width).size()) - 1;
    Mesh mesh = grid(columns, ny, -300, 300, 0, ny, [](double, double) { return 0.0; });
    for (int v = 0; v < mesh.V.rows(); ++v) {
        const double x = mesh.V(v, 0);
        mesh.V(v, 1) = rows(width_at(x))[static_cast<size_t>(v / (columns + 1))];
        mesh.V(v, 2) = height(x, mesh.V(v, 1));
    }
    model = model_of(std::move(mesh));
    for (int i = 0; i <= columns; ++i) {
        const int v = side_rows * (columns + 1) + i;
        line.push_back(v);
        if (std::abs(model.mesh.V(v, 0)) <= 150) {
            middle.push_back(v);
        }
    }
    region = whole_model(model);
}

double FilletedPanel::width_at(double x) const
{
    return std::lerp(width, last_width, std::clamp((x + 150) / 300, 0.0, 1.0));
}

double FilletedPanel::height(double x, double y) const
{
    const double w = width_at(x), t = std::clamp(y, 0.0, w);
    return std::tan(4 * degree) * std::min(y, 0.0) - std::tan(25 * degree) * (t - t * t / (2 * w));
}

Mesh FilletedPanel::side(const Positions& V, bool left) const
{
    const auto sides = meshes_beside(model.mesh, middle, false);
    // A cut along the line's prolongation appends vertices; none of the sides' own triangles need them here.
    return {V.topRows(model.mesh.V.rows()), (left ? sides.first : sides.second).F};
}

ParametricCurve level_slide(double s, double lift)
{
    constexpr double w = std::numbers::pi / 400;
    const auto height = [=](double x) { return lift * std::pow(std::cos(w * x), 2); };
    return ParametricCurve(
        [=](double x) { return Vec3(x, s * std::pow(std::cos(w * x), 2), height(x)); },
        [=](double x) { return Vec3(1, -s * w * std::sin(2 * w * x), -lift * w * std::sin(2 * w * x)); }, -200, 200);
}

} // namespace tapeline::testing
