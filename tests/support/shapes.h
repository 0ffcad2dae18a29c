// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/curve.h"
#include "kernel/mesh.h"

#include <functional>
#include <vector>

namespace tapeline::testing {

enum class Diagonals {
    alternating, ///< regular, mirror-symmetric about x = 0 and y = 0 for even cell counts
    random ///< irregular: vertices off the crease jittered inside their cell, diagonals by a fixed random sequence
};

/// A height field z(x, y) over [x0, x1] × [y0, y1] with nx × ny cells; vertex (i, j) has index j * (nx + 1) + i.
/// With random diagonals, rows listed in `keep_rows` (and the outer border) are not jittered.
Mesh grid(int nx, int ny, double x0, double x1, double y0, double y1, const std::function<double(double, double)>& z,
          Diagonals diagonals = Diagonals::alternating, const std::vector<int>& keep_rows = {});

/// The crease-slide panel: 800 × 600 mm, z = -x²/12000 - y²/6000 - tan(6°)|y|, a 12° crease along y = 0, which is
/// the row ny / 2 of vertices. ny must be even.
Mesh crease_panel(int nx, int ny, Diagonals diagonals = Diagonals::alternating);
double crease_panel_height(double x, double y);
/// Vertices of the crease, in the order of growing x.
std::vector<int> crease_panel_line(int nx, int ny);

/// A roof of two flat sides: z = -0.3 |y| on [-2000, 2000] × [-1000, 1000] mm.
Mesh flat_roof(int nx, int ny, Diagonals diagonals = Diagonals::alternating);

/// A target line given in closed form on [first, last]; feet by sampling and Newton steps to rounding.
class ParametricCurve final : public TargetCurve {
public:
    ParametricCurve(std::function<Vec3(double)> point, std::function<Vec3(double)> derivative, double first,
                    double last, bool closed = false);
    double first_parameter() const override { return first_; }
    double last_parameter() const override { return last_; }
    bool closed() const override { return closed_; }
    Vec3 point(double parameter) const override { return point_(parameter); }
    Vec3 tangent(double parameter) const override { return derivative_(parameter).normalized(); }
    Vec3 derivative(double parameter) const { return derivative_(parameter); }
    double arc_length(double parameter) const override;
    double parameter_at(double arc_length) const override;
    CurveFoot foot(const Vec3& p) const override;
    std::vector<CurveFoot> all_feet(const Vec3& p) const override;

private:
    std::function<Vec3(double)> point_, derivative_;
    double first_, last_;
    bool closed_;
};

/// The crease-slide target: y = s cos²(πx/400), |x| ≤ 200, on the panel's surface.
ParametricCurve crease_slide_target(double s);

/// Wraps a mesh without CAD data.
Model model_of(Mesh mesh);

} // namespace tapeline::testing
