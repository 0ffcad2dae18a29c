// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/strips.h"

#include "bspline/fit.h"
#include "bspline/slide_law.h"
#include "kernel/strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapeline {

namespace {

using nlohmann::ordered_json;

std::vector<double> fractions(const std::vector<Vec3>& points, bool closed)
{
    std::vector<double> arc{0};
    for (size_t i = 1; i < points.size(); ++i) {
        arc.push_back(arc.back() + (points[i] - points[i - 1]).norm());
    }
    const double length = arc.back() + (closed ? (points.front() - points.back()).norm() : 0);
    for (double& s : arc) {
        s /= length;
    }
    return arc;
}

/// The law's distances to one side only.
SlideLaw one_sided(const SlideLaw& law, bool left)
{
    SlideLaw part = law;
    for (auto& [fraction, distance] : part.values) {
        distance = left ? std::max(0.0, distance) : std::min(0.0, distance);
    }
    return part;
}

/// Frames of a curve on a surface: direction, normal, across.
class Frames {
public:
    explicit Frames(const Mesh& side) : side_(side), normals_(vertex_normals(side)), tree_(side) {}

    Eigen::Matrix3d at(const TargetLine& line, double parameter) const
    {
        const MeshFoot foot = tree_.closest(line.point(parameter));
        Vec3 normal = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            normal += foot.barycentric[k] * Vec3(normals_.row(side_.F(foot.face, k)));
        }
        Eigen::Matrix3d frame;
        frame.col(0) = line.tangent(parameter);
        frame.col(1) = (normal - frame.col(0) * frame.col(0).dot(normal)).normalized();
        frame.col(2) = frame.col(0).cross(frame.col(1));
        return frame;
    }

private:
    const Mesh& side_;
    Positions normals_;
    ClosestPoint tree_;
};

struct Task {
    const Model& model;
    const FeatureLine& line;
    const SlideLaw& law;
    const TargetSettings& settings;
    const ExactGround* exact;

    /// Where the line's points go that stand on a strip of that side.
    Result<std::vector<Vec3>> standing_on(const Mesh& side, const std::vector<double>& widths, bool left) const
    {
        const std::vector<Vec3> edge = points_across(side, line.vertices, line.closed, widths);
        FitOptions fit;
        fit.tolerance_mm = settings.tolerance;
        const auto at_rest = fit_polyline(edge, line.closed, fit);
        if (!at_rest) {
            return tl::unexpected(at_rest.error());
        }
        return slide_on_surface(*at_rest, model.mesh, one_sided(law, left), settings.tolerance, exact)
            .map([&](const TargetLine& moved) {
                const Frames frames(side);
                const std::vector<double> share = fractions(edge, line.closed);
                std::vector<Vec3> points;
                for (size_t i = 0; i < edge.size(); ++i) {
                    const double before = at_rest->parameter_at(share[i] * at_rest->length());
                    const double after = moved.parameter_at(share[i] * moved.length());
                    const Eigen::Matrix3d turn = frames.at(moved, after) * frames.at(*at_rest, before).transpose();
                    const Vec3 arm = Vec3(model.mesh.V.row(line.vertices[i])) - edge[i];
                    // What the fit misses the edge by is no part of the way.
                    points.push_back(edge[i] + moved.point(after) - at_rest->point(before) + turn * arm);
                }
                return points;
            });
    }
};

/// Of the bend, at its narrowest and widest place [mm].
std::pair<double, double> width_range(const Strip& bend)
{
    if (bend.widths.empty()) {
        return {bend.width_mm, bend.width_mm};
    }
    const auto [least, most] = std::ranges::minmax(bend.widths);
    return {least, most};
}

std::string width_text(const Strip& bend)
{
    const auto [least, most] = width_range(bend);
    return least == most ? fmt::format("{:.3g}", least) : fmt::format("{:.3g} to {:.3g}", least, most);
}

ordered_json strip_json(const StripReport& strip)
{
    if (!strip.bend.found()) {
        return nullptr;
    }
    const auto [least, most] = width_range(strip.bend);
    return {{"width_mm", strip.bend.width_mm},
            {"width_min_mm", least},
            {"width_max_mm", most},
            {"carried_mm", strip.bend.carried_mm},
            {"turning", strip.bend.turning},
            {"radius_mm", strip.bend.radius_mm},
            {"pivot_max", strip.pivot_max},
            {"lift_max_mm", strip.lift_max_mm},
            {"vertices", strip.vertices}};
}

} // namespace

std::optional<double> strip_width(const MoveSettings& settings)
{
    const auto method = method_named(settings.method);
    const MethodInfo& info = method_info(method.value_or(Method::plate_fl));
    if (settings.strip == "none" || !info.splits || info.as_published || info.retraction != RetractionMode::harmonic) {
        return 0;
    }
    return settings.strip_width > 0 ? std::optional(settings.strip_width) : std::nullopt;
}

Result<TargetLine> slide_on_strips(const Model& model, const FeatureLine& line, const TargetLine& slid,
                                   const SlideLaw& law, const TargetSettings& settings,
                                   const std::optional<double>& width, const ExactGround* exact)
{
    const auto curve = spline::SlideCurve::make(law, line.closed);
    if (!curve || width == 0) {
        return slid;
    }
    std::vector<Vec3> at_rest;
    for (const int v : line.vertices) {
        at_rest.emplace_back(model.mesh.V.row(v));
    }
    const std::vector<double> share = fractions(at_rest, line.closed);
    const auto sides = meshes_beside(model.mesh, line.vertices, line.closed);
    std::vector<Vec3> points;
    for (const double s : share) {
        points.push_back(slid.point(slid.parameter_at(s * slid.length())));
    }
    bool stands = false;
    for (const bool left : {true, false}) {
        const auto goes = [&](double s) { return left ? curve->at(s) > 0 : curve->at(s) < 0; };
        const Mesh& side = left ? sides.first : sides.second;
        if (std::ranges::none_of(share, goes)) {
            continue;
        }
        const Strip strip = width ? Strip{.carried_mm = *width} : find_strip(side, line.vertices, line.closed);
        if (!strip.found()) {
            continue;
        }
        const auto standing =
            Task{model, line, law, settings, exact}.standing_on(side, strip.carried(line.vertices.size()), left);
        if (!standing) {
            return tl::unexpected(standing.error());
        }
        for (size_t i = 0; i < points.size(); ++i) {
            points[i] = goes(share[i]) ? (*standing)[i] : (curve->at(share[i]) == 0 ? at_rest[i] : points[i]);
        }
        stands = true;
    }
    if (!stands) {
        return slid;
    }
    FitOptions fit;
    fit.control_points = settings.surface_points;
    fit.tolerance_mm = settings.surface_points > 0 ? 0 : settings.tolerance;
    return fit_polyline(points, line.closed, fit);
}

std::string strip_text(const MoveResult& move)
{
    std::string text;
    for (const int side : {0, 1}) {
        const StripReport& strip = move.strips[side];
        if (!strip.bend.found()) {
            continue;
        }
        const bool compressed = side == static_cast<int>(move.placement.compressed);
        const std::string what = strip.bend.width_mm > 0
                                     ? fmt::format("a bend {} mm wide ({:.3g} deg, radius {:.3g} mm)",
                                                   width_text(strip.bend), strip.bend.turning, strip.bend.radius_mm)
                                     : fmt::format("a strip {:.3g} mm wide", strip.bend.carried_mm);
        text += fmt::format("{}{} beside the line on the {} side", text.empty() ? "" : " and ", what,
                            compressed ? "compressed" : "tension");
    }
    return text.empty() ? text : text + " is carried along";
}

ordered_json strips_json(const MoveResult& move)
{
    const bool left = move.strips[0].bend.found(), right = move.strips[1].bend.found();
    return {{"class", left && right ? "both" : (left ? "left" : (right ? "right" : "none"))},
            {"message", strip_text(move)},
            {"left", strip_json(move.strips[0])},
            {"right", strip_json(move.strips[1])}};
}

} // namespace tapeline
