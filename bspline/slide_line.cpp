// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline/slide.h"
#include "bspline/slide_law.h"
#include "bspline/surface_line.h"
#include "bspline/surface_walk.h"
#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tapeline {

namespace {

/// What becomes of one sample of the line.
struct Slid {
    Vec3 from = Vec3::Zero(), tangent = Vec3::Zero(), to = Vec3::Zero();
    double off_surface = 0; ///< of the sample [mm]
    double wanted = 0;      ///< signed slide [mm]
    double missing = 0;     ///< part of it that the border cut off [mm]
    bool along_border = false;
    bool directed = true; ///< false: the line stands upright on the surface
};

struct SlideTask {
    const TargetLine& line;
    const Mesh& mesh;
    Topology topology;
    ClosestPoint surface;
    spline::SlideCurve law;

    /// An end that lies on the model's border stays on it, where the border runs about the way of the slide.
    Slid slide(double fraction, bool end) const
    {
        Slid result;
        const double t = line.parameter_at(fraction * line.length());
        result.from = line.point(t);
        result.tangent = line.tangent(t);
        result.wanted = law.at(fraction);
        const MeshFoot foot = surface.closest(result.from);
        result.off_surface = foot.distance;
        result.to = foot.point;
        if (foot.face < 0) {
            return result;
        }
        for (const bool left : {result.wanted >= 0, result.wanted < 0}) {
            const auto start = spline::start_beside(mesh, topology, foot, result.tangent, left);
            if (!start) {
                result.directed = result.wanted == 0;
                return result;
            }
            // The line may pass a polygonal crease at a small distance; measured from its foot there, the slid line
            // would repeat the polygon's corners.
            const double beside = (result.from - foot.point).dot(start->direction);
            const double distance = (left ? result.wanted : -result.wanted) + beside;
            if (distance > 0) {
                go(result, *start, distance, end);
                return result;
            }
        }
        return result;
    }

    void go(Slid& result, const spline::WalkStart& start, double distance, bool end) const
    {
        const auto bordering = end ? spline::walk_border(mesh, topology, start, distance) : std::nullopt;
        const spline::WalkEnd arrived = bordering ? *bordering : spline::walk(mesh, topology, start, distance);
        result.to = arrived.point;
        result.missing = arrived.missing;
        result.along_border = arrived.along_border;
    }
};

Result<void> check(const Slid& slid, double length)
{
    const Vec3& p = slid.from;
    const auto rejected = [&](const std::string& what) {
        return fail(ErrorKind::rejected,
                    fmt::format("the line cannot slide at ({:.6g}, {:.6g}, {:.6g}): {}", p.x(), p.y(), p.z(), what));
    };
    if (!(slid.off_surface <= 0.1 * length)) {
        return rejected(
            fmt::format("it is {:.6g} mm off the model there; lay it on the surface first", slid.off_surface));
    }
    if (!slid.directed) {
        return rejected("it stands upright on the surface there, so there is no left or right");
    }
    // What a sample lies beside the model's border is no slide.
    if (slid.missing > 1e-6 * std::abs(slid.wanted) + slid.off_surface) {
        return rejected(fmt::format("the model's border is {:.6g} mm away, {:.6g} mm are asked for; slide less there",
                                    std::abs(slid.wanted) - slid.missing, std::abs(slid.wanted)));
    }
    return {};
}

/// Beside an end that slides along the border, samples whose paths the border bent end up on top of each other; the end
/// itself stands for them.
void drop_crowded_ends(std::vector<Slid>& slid)
{
    const auto inside = [](const Slid& s) { return !s.along_border; };
    const auto first = std::find_if(slid.begin() + 1, slid.end() - 1, inside);
    slid.erase(slid.begin() + 1, first);
    const auto last = std::find_if(slid.rbegin() + 1, slid.rend() - 1, inside);
    slid.erase(last.base(), slid.end() - 1);
}

/// Neighbouring points that changed order: the slide reaches beyond the line's centre of curvature.
Result<void> check_order(const Slid& a, const Slid& b)
{
    if ((b.to - a.to).dot(a.tangent + b.tangent) > 0) {
        return {};
    }
    return fail(
        ErrorKind::rejected,
        fmt::format("the slid line folds over itself at ({:.6g}, {:.6g}, {:.6g}): a slide of {:.6g} mm is more than "
                    "the line's radius of curvature there, or reaches a sharp edge; slide less",
                    b.to.x(), b.to.y(), b.to.z(), b.wanted));
}

} // namespace

Result<TargetLine> slide_on_surface(const TargetLine& line, const Mesh& mesh, const SlideLaw& law, double tolerance_mm,
                                    const ExactGround* exact, int control_points, double* off_mm)
try {
    if (const auto checked = spline::check_tolerance(tolerance_mm); !checked) {
        return tl::unexpected(checked.error());
    }
    if (mesh.F.rows() == 0) {
        return fail(ErrorKind::rejected, "the line cannot slide on a model without triangles");
    }
    auto curve = spline::SlideCurve::make(law, line.closed());
    if (!curve) {
        return tl::unexpected(curve.error());
    }
    const SlideTask task{line, mesh, Topology(mesh.F, static_cast<int>(mesh.V.rows())), ClosestPoint(mesh), *curve};
    const spline::LineGround ground(task.surface, exact);
    const auto place = [&](const std::vector<double>& fractions) -> Result<std::vector<Vec3>> {
        const int n = static_cast<int>(fractions.size());
        std::vector<Slid> slid(n);
        const bool open = !line.closed();
        parallel_for(
            n, [&](int i) { slid[i] = task.slide(fractions[i], open && (i == 0 || i == n - 1)); }, 16);
        for (const Slid& sample : slid) {
            if (const auto checked = check(sample, line.length()); !checked) {
                return tl::unexpected(checked.error());
            }
        }
        if (open) {
            drop_crowded_ends(slid);
        }
        std::vector<Vec3> points;
        for (size_t i = 0; i < slid.size(); ++i) {
            if (i > 0 || !open) {
                if (const auto checked = check_order(slid[(i + slid.size() - 1) % slid.size()], slid[i]); !checked) {
                    return tl::unexpected(checked.error());
                }
            }
            points.push_back(ground.place(slid[i].to));
        }
        return points;
    };
    return spline::fit_on_surface(place, line.closed(), spline::sample_count(line, mesh), ground,
                                  {tolerance_mm, control_points}, off_mm);
} catch (const std::exception& exception) {
    return fail(ErrorKind::rejected, fmt::format("the line cannot slide on the model: {}", exception.what()));
}

} // namespace tapeline
