// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tapeline::testing {

Mesh grid(int nx, int ny, double x0, double x1, double y0, double y1, const std::function<double(double, double)>& z,
          Diagonals diagonals, const std::vector<int>& keep_rows)
{
    const bool random = diagonals == Diagonals::random;
    std::mt19937 sequence(12345);
    const auto uniform = [&] { return sequence() / 4294967296.0; };
    Mesh mesh;
    mesh.V.resize((nx + 1) * (ny + 1), 3);
    for (int j = 0; j <= ny; ++j) {
        const bool keep = j == 0 || j == ny || std::ranges::count(keep_rows, j) > 0;
        for (int i = 0; i <= nx; ++i) {
            double x = x0 + (x1 - x0) * i / nx;
            double y = y0 + (y1 - y0) * j / ny;
            if (random && !keep && i > 0 && i < nx) {
                x += (uniform() - 0.5) * 0.5 * (x1 - x0) / nx;
                y += (uniform() - 0.5) * 0.5 * (y1 - y0) / ny;
            }
            mesh.V.row(j * (nx + 1) + i) << x, y, z(x, y);
        }
    }
    mesh.F.resize(2 * nx * ny, 3);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 2, d = a + nx + 1;
            const int t = 2 * (j * nx + i);
            if (random ? uniform() < 0.5 : (i + j) % 2 == 0) {
                mesh.F.row(t) << a, b, c;
                mesh.F.row(t + 1) << a, c, d;
            } else {
                mesh.F.row(t) << a, b, d;
                mesh.F.row(t + 1) << b, c, d;
            }
        }
    }
    return mesh;
}

double crease_panel_height(double x, double y)
{
    return -x * x / 12000 - y * y / 6000 - std::tan(6 * std::numbers::pi / 180) * std::abs(y);
}

Mesh crease_panel(int nx, int ny, Diagonals diagonals)
{
    return grid(nx, ny, -400, 400, -300, 300, crease_panel_height, diagonals, {ny / 2});
}

std::vector<int> crease_panel_line(int nx, int ny)
{
    std::vector<int> line(nx + 1);
    for (int i = 0; i <= nx; ++i) {
        line[i] = ny / 2 * (nx + 1) + i;
    }
    return line;
}

Mesh flat_roof(int nx, int ny, Diagonals diagonals)
{
    return grid(nx, ny, -2000, 2000, -1000, 1000, [](double, double y) { return -0.3 * std::abs(y); }, diagonals,
                {ny / 2});
}

ParametricCurve::ParametricCurve(std::function<Vec3(double)> point, std::function<Vec3(double)> derivative,
                                 double first, double last, bool closed)
    : point_(std::move(point)), derivative_(std::move(derivative)), first_(first), last_(last), closed_(closed)
{
}

double ParametricCurve::arc_length(double parameter) const
{
    // Composite Gauss-Legendre with three points on 256 pieces.
    constexpr int pieces = 256;
    const double h = (parameter - first_) / pieces;
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {
        const double middle = first_ + (i + 0.5) * h;
        const double offset = 0.5 * h * std::sqrt(0.6);
        sum += 8 * derivative_(middle).norm() + 5 * derivative_(middle - offset).norm() +
               5 * derivative_(middle + offset).norm();
    }
    return sum * h / 18;
}

double ParametricCurve::parameter_at(double wanted) const
{
    double low = first_, high = last_;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (arc_length(middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::vector<CurveFoot> ParametricCurve::all_feet(const Vec3& p) const
{
    constexpr int samples = 2000;
    const auto slope = [&](double t) { return (p - point_(t)).dot(derivative_(t)); };
    std::vector<CurveFoot> feet;
    for (int i = 0; i < samples; ++i) {
        double low = first_ + (last_ - first_) * i / samples, high = first_ + (last_ - first_) * (i + 1) / samples;
        const double at_low = slope(low), at_high = slope(high);
        const bool last_end = i + 1 == samples && at_high == 0;
        if ((at_low > 0) == (at_high > 0) && at_low != 0 && !last_end) {
            continue;
        }
        double t = at_low == 0 ? low : high;
        if (at_low != 0 && !last_end) {
            for (int k = 0; k < 100; ++k) {
                t = 0.5 * (low + high);
                ((slope(t) > 0) == (at_low > 0) ? low : high) = t;
            }
        }
        feet.push_back({t, point_(t), tangent(t), (p - point_(t)).norm(), false});
    }
    std::ranges::sort(feet, {}, &CurveFoot::distance);
    return feet;
}

CurveFoot ParametricCurve::foot(const Vec3& p) const
{
    CurveFoot best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const CurveFoot& candidate : all_feet(p)) {
        if (candidate.distance < best.distance) {
            best = candidate;
        }
    }
    if (!closed_) {
        for (const double end : {first_, last_}) {
            const double distance = (p - point_(end)).norm();
            if (distance < best.distance) {
                best = {end, point_(end), tangent(end), distance, true};
            }
        }
    }
    return best;
}

ParametricCurve crease_slide_target(double s)
{
    const double w = std::numbers::pi / 400;
    const double slope = std::tan(6 * std::numbers::pi / 180);
    const auto point = [=](double x) {
        const double y = s * std::cos(w * x) * std::cos(w * x);
        return Vec3(x, y, crease_panel_height(x, y));
    };
    const auto derivative = [=](double x) {
        const double y = s * std::cos(w * x) * std::cos(w * x);
        const double dy = -s * w * std::sin(2 * w * x);
        const double sign = s >= 0 ? 1 : -1;
        return Vec3(1, dy, -x / 6000 - y * dy / 3000 - slope * sign * dy);
    };
    return {point, derivative, -200, 200};
}

Model model_of(Mesh mesh)
{
    Model model;
    model.mesh = std::move(mesh);
    return model;
}

} // namespace tapeline::testing
