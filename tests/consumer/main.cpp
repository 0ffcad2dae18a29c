// SPDX-License-Identifier: GPL-3.0-or-later
// What another program would do with the library: a roof from arrays, its ridge moved aside, the result looked at.
#include "bspline/fit.h"
#include "bspline/slide.h"
#include "kernel/feature_lines.h"
#include "kernel/move.h"

#include <cmath>
#include <cstdio>

using namespace tapeline;

namespace {

/// A roof z = -0.3 |y| over 40 x 20 mm with its ridge along y = 0.
Model roof()
{
    constexpr int nx = 40, ny = 20;
    Model model;
    model.mesh.V.resize((nx + 1) * (ny + 1), 3);
    model.mesh.F.resize(2 * nx * ny, 3);
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            const double x = i - nx / 2.0, y = j - ny / 2.0;
            model.mesh.V.row(j * (nx + 1) + i) << x, y, -0.3 * std::abs(y);
        }
    }
    for (int j = 0, t = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 1, d = c + 1;
            model.mesh.F.row(t++) << a, b, d;
            model.mesh.F.row(t++) << a, d, c;
        }
    }
    return model;
}

int failed(const Error& error)
{
    std::fprintf(stderr, "%s\n", error.message.c_str());
    return exit_code(error.kind);
}

} // namespace

int main()
{
    const Model model = roof();
    const auto line = select_line(model, find_feature_lines(model), "0@25%..75%");
    if (!line) {
        return failed(line.error());
    }
    std::vector<Vec3> points;
    for (const int v : line->vertices) {
        points.emplace_back(model.mesh.V.row(v));
    }
    const SlideLaw law{{{0, 0}, {0.5, 2}, {1, 0}}};
    const auto target = fit_polyline(points, false).and_then([&](const TargetLine& fit) {
        return slide_on_surface(fit, model.mesh, law);
    });
    if (!target) {
        return failed(target.error());
    }
    const auto region = make_region(model, *line, {}, {.distance_mm = 8});
    if (!region) {
        return failed(region.error());
    }
    const auto moved = move_feature_line(model, *line, *target, *region);
    if (!moved) {
        return failed(moved.error());
    }
    double farthest = 0;
    for (const int v : moved->correspondence.line.vertices) {
        farthest = std::max(farthest, (moved->V.row(v) - moved->rest.mesh.V.row(v)).norm());
    }
    std::printf("the ridge moved by up to %.3f mm\n", farthest);
    return std::abs(farthest - 2) < 0.01 ? 0 : 1;
}
