// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/surface_line.h"

#include "bspline/fit.h"
#include "bspline/slide.h"
#include "bspline/target_line_impl.h"
#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace spline {

namespace {

std::vector<double> even_fractions(int n, bool closed)
{
    std::vector<double> fractions;
    for (int i = 0; i < n + (closed ? 0 : 1); ++i) {
        fractions.push_back(static_cast<double>(i) / n);
    }
    return fractions;
}

/// Largest distance of the line to the surface [mm].
double deviation(const TargetLine& line, const LineGround& surface, int samples)
{
    std::vector<double> distances(samples + 1);
    const double first = line.first_parameter(), range = line.last_parameter() - first;
    parallel_for(samples + 1, [&](int i) {
        const Vec3 p = line.point(first + range * i / samples);
        distances[i] = (surface.closest(p) - p).norm();
    });
    return *std::ranges::max_element(distances);
}

/// One tolerance: up to three attempts, and a fourth where more points still help (where the line crosses a sharp edge,
/// what it cuts off there is proportional to their distance). The error says how close the last one came.
Result<TargetLine> fit_within(const PlacePoints& place, bool closed, int samples, const LineGround& surface,
                              double tolerance_mm, int max_control_points)
{
    double off = 0;
    bool helps = true;
    for (int attempt = 0; attempt < 3 || (attempt == 3 && helps); ++attempt) {
        const int n = samples << attempt;
        const auto points = place(even_fractions(n, closed));
        if (!points) {
            return tl::unexpected(points.error());
        }
        FitOptions options;
        options.tolerance_mm = tolerance_mm * std::pow(0.5, attempt + 1);
        options.max_control_points = max_control_points;
        auto line = fit_polyline(*points, closed, options);
        if (!line) {
            return line;
        }
        const double before = off;
        off = deviation(*line, surface, 4 * n);
        helps = off < 0.75 * before;
        if (off <= tolerance_mm) {
            return line;
        }
    }
    return fail(
        ErrorKind::rejected,
        fmt::format("the line strays {:.6g} mm from the model between its points, more than {:.6g} mm, as where it "
                    "crosses a sharp edge: raise the tolerance, or use a finer mesh",
                    off, tolerance_mm));
}

/// A number of control points, whatever it gives.
Result<TargetLine> fit_with(const PlacePoints& place, bool closed, int samples, const LineGround& surface,
                            const SurfaceFit& wanted, double* off_mm)
{
    FitOptions options;
    options.control_points = wanted.control_points;
    options.tolerance_mm = wanted.tolerance_mm;
    FitReport report;
    return place(even_fractions(samples, closed))
        .and_then([&](const std::vector<Vec3>& points) { return fit_polyline(points, closed, options, &report); })
        .and_then([&](TargetLine line) -> Result<TargetLine> {
            const double off = std::max(report.max_error_mm, deviation(line, surface, 4 * samples));
            if (wanted.tolerance_mm > 0 && off > wanted.tolerance_mm) {
                return fail(ErrorKind::rejected,
                            fmt::format("{} control points keep the line within {:.6g} mm of the surface only, not "
                                        "{:.6g} mm: allow more of them or a larger tolerance",
                                        wanted.control_points, off, wanted.tolerance_mm));
            }
            if (off_mm != nullptr) {
                *off_mm = off;
            }
            return line;
        });
}

double polyline_length(const std::vector<Vec3>& points)
{
    double length = 0;
    for (size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

} // namespace

Result<void> check_tolerance(double tolerance_mm)
{
    if (!(tolerance_mm >= 0) || !std::isfinite(tolerance_mm)) {
        return fail(ErrorKind::usage, fmt::format("the tolerance {} mm must not be negative", tolerance_mm));
    }
    return {};
}

Result<TargetLine> fit_on_surface(const PlacePoints& place, bool closed, int samples, const LineGround& surface,
                                  const SurfaceFit& wanted, double* off_mm)
{
    const double tolerance_mm = wanted.tolerance_mm;
    if (wanted.control_points > 0) {
        return fit_with(place, closed, samples, surface, wanted, off_mm);
    }
    if (tolerance_mm > 0) {
        return fit_within(place, closed, samples, surface, tolerance_mm, 0);
    }
    const auto points = place(even_fractions(samples, closed));
    if (!points) {
        return tl::unexpected(points.error());
    }
    const double length = polyline_length(*points);
    constexpr int handles = 40;
    for (const double share : {1e-5, 2e-5, 5e-5}) {
        if (auto line = fit_within(place, closed, samples, surface, share * length, handles)) {
            return line;
        }
    }
    return fit_within(place, closed, samples, surface, 1e-4 * length, 0);
}

int sample_count(const TargetLine& line, const Mesh& mesh)
{
    double edges = 0;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        for (int k = 0; k < 3; ++k) {
            edges += (mesh.V.row(mesh.F(t, k)) - mesh.V.row(mesh.F(t, (k + 1) % 3))).norm();
        }
    }
    const double mean_edge = edges / (3.0 * static_cast<double>(mesh.F.rows()));
    const double wanted =
        std::max(16.0 * static_cast<double>(line.impl().spans.spans().size()), 2 * line.length() / mean_edge);
    return static_cast<int>(std::clamp(wanted, 100.0, 1000.0));
}

} // namespace spline

Result<TargetLine> lay_on_surface(const TargetLine& line, const Mesh& mesh, double tolerance_mm,
                                  const ExactGround* exact, int control_points, double* off_mm)
try {
    if (const auto checked = spline::check_tolerance(tolerance_mm); !checked) {
        return tl::unexpected(checked.error());
    }
    if (mesh.F.rows() == 0) {
        return fail(ErrorKind::rejected, "the line cannot be laid on a model without triangles");
    }
    const ClosestPoint triangles(mesh);
    const spline::LineGround surface(triangles, exact);
    const double length = line.length();
    const auto place = [&](const std::vector<double>& fractions) -> Result<std::vector<Vec3>> {
        std::vector<Vec3> points(fractions.size());
        std::vector<MeshFoot> feet(fractions.size());
        parallel_for(static_cast<int>(fractions.size()), [&](int i) {
            points[i] = line.point(line.parameter_at(fractions[i] * length));
            feet[i] = triangles.closest(points[i]);
        });
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3 p = points[i];
            if (feet[i].face < 0 || !(feet[i].distance <= length)) {
                return fail(ErrorKind::rejected,
                            fmt::format("the line is {:.6g} mm off the model at ({:.6g}, {:.6g}, {:.6g}), farther than "
                                        "its own length of {:.6g} mm: check units and position",
                                        feet[i].distance, p.x(), p.y(), p.z(), length));
            }
            points[i] = surface.place(feet[i].point);
            if (i > 0 && (points[i] - points[i - 1]).norm() > 0.1 * length) {
                return fail(ErrorKind::rejected,
                            fmt::format("the line drops to two places far apart beside ({:.6g}, {:.6g}, {:.6g}): bring "
                                        "it nearer to the surface it belongs to",
                                        p.x(), p.y(), p.z()));
            }
        }
        return points;
    };
    return spline::fit_on_surface(place, line.closed(), spline::sample_count(line, mesh), surface,
                                  {tolerance_mm, control_points}, off_mm);
} catch (const std::exception& exception) {
    return fail(ErrorKind::rejected, fmt::format("the line cannot be laid on the model: {}", exception.what()));
}

} // namespace tapeline
