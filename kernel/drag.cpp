// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/drag.h"

#include "kernel/extension_target.h"
#include "kernel/parallel.h"

#include <algorithm>
#include <cmath>

namespace tapeline {

namespace {

/// The orthotropic stiffness of a side with what holds it.
Result<Elimination> harmonic_system(const SideMesh& side, const std::vector<int>& held, const Material& material)
{
    Elimination system;
    if (!system.factorize(stiffness_matrix(side.mesh, triangle_elements(side.mesh, material)), held)) {
        return fail(ErrorKind::not_converged,
                    "the region's stiffness matrix cannot be factorised because its triangles "
                    "are too thin: remesh the region (--max-edge)");
    }
    return system;
}

} // namespace

Drag::Drag(DragStart start, Topology topology, ClosestPoint surface)
    : start_(std::move(start)), topology_(std::move(topology)), surface_(std::move(surface))
{
}

Result<Drag> Drag::create(DragStart start)
{
    const Mesh& mesh = start.extended.model.mesh;
    Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    ClosestPoint surface(mesh, start.extended.region.faces);
    Drag drag(std::move(start), std::move(topology), std::move(surface));
    std::vector<SideMesh> sides;
    if (drag.start_.splits) {
        auto both = split_along(drag.start_.extended, drag.start_.clamp_rings);
        if (!both) {
            return tl::unexpected(both.error());
        }
        std::ranges::move(*both, std::back_inserter(sides));
    } else {
        sides.push_back(whole_region(drag.start_.extended, drag.start_.clamp_rings));
    }
    for (SideMesh& side : sides) {
        if (auto added = drag.add_part(std::move(side)); !added) {
            return tl::unexpected(added.error());
        }
    }
    return drag;
}

Result<void> Drag::add_part(SideMesh side)
{
    PlateSupport support;
    support.constrained = side.fixed;
    support.constrained.insert(support.constrained.end(), side.line.begin(), side.line.end());
    support.targets.resize(static_cast<Eigen::Index>(support.constrained.size()), 3);
    for (size_t i = 0; i < support.constrained.size(); ++i) {
        support.targets.row(static_cast<Eigen::Index>(i)) = side.mesh.V.row(support.constrained[i]);
    }
    support.free_slope = side.line;
    for (const int v : side.fixed) {
        if (std::ranges::binary_search(start_.tilting, side.to_global[v])) {
            support.free_slope.push_back(v);
        }
    }
    auto plate = PlateSystem::create(side.mesh, support, start_.plate);
    if (!plate) {
        return tl::unexpected(plate.error());
    }
    plate->fit(plate->start());
    auto slide = harmonic_system(side, support.constrained, start_.slide);
    if (!slide) {
        return tl::unexpected(slide.error());
    }
    auto rails = rails_of(side, support.constrained);
    if (!rails) {
        return tl::unexpected(rails.error());
    }
    const std::vector<int> inner(side.own_faces().begin(), side.own_faces().end());
    ClosestPoint ground(start_.extended.model.mesh, inner);
    faces_[parts_.size()] = inner;
    parts_.push_back({std::move(side), std::move(support.constrained), std::move(*plate), std::move(*slide),
                      std::move(ground), std::move(*rails)});
    return {};
}

Result<std::shared_ptr<const Drag::Rails>> Drag::rails_of(const SideMesh& side, const std::vector<int>& held) const
{
    auto rails = std::make_shared<Rails>();
    rails->inner = side.own_mesh();
    std::vector<char> given(side.mesh.V.rows(), 0);
    for (const int v : held) {
        given[v] = 1;
    }
    rails->lines = FeatureRails(rails->inner, side.features, given);
    for (int v = 0; v < static_cast<int>(given.size()); ++v) {
        if (rails->lines.slides(v) || rails->lines.corner(v)) {
            rails->vertices.push_back(v);
        }
    }
    if (rails->vertices.empty()) {
        return nullptr;
    }
    std::vector<int> all = held;
    all.insert(all.end(), rails->vertices.begin(), rails->vertices.end());
    return harmonic_system(side, all, start_.slide).map([&](Elimination system) -> std::shared_ptr<const Rails> {
        rails->slide = std::move(system);
        return rails;
    });
}

std::vector<Vec3> Drag::line_goals(const Correspondence& correspondence, bool on_surface) const
{
    const ExtendedLine& line = start_.extended;
    const Positions& rest = line.model.mesh.V;
    const size_t n = line.vertices.size();
    std::vector<Vec3> goals(n);
    std::vector<int> given(n, -1);
    std::vector<int> entry_of(rest.rows(), -1);
    for (size_t i = 0; i < correspondence.line.vertices.size(); ++i) {
        entry_of[correspondence.line.vertices[i]] = static_cast<int>(i);
    }
    int first = -1, last = -1;
    for (size_t i = 0; i < n; ++i) {
        given[i] = entry_of[line.vertices[i]];
        goals[i] = start_.V.row(line.vertices[i]);
        if (given[i] >= 0) {
            goals[i] = correspondence.targets[given[i]];
            first = first < 0 ? static_cast<int>(i) : first;
            last = static_cast<int>(i);
        }
    }
    if (first < 0 || line.closed) {
        return goals;
    }
    // Beyond an end the change of its displacement fades out to the rim.
    const auto fade = [&](int end, int step) {
        const int stop = step > 0 ? static_cast<int>(n) : -1;
        std::vector<double> arc = {0};
        for (int i = end; i + step != stop; i += step) {
            arc.push_back(arc.back() + (rest.row(line.vertices[i + step]) - rest.row(line.vertices[i])).norm());
        }
        const Vec3 change = goals[end] - Vec3(start_.V.row(line.vertices[end]));
        for (size_t k = 1; k < arc.size(); ++k) {
            const Vec3 share = taper(arc[k], arc.back(), -1 / arc.back()) * change;
            Vec3& goal = goals[end + static_cast<int>(k) * step];
            if (!share.isZero(0)) {
                goal += share;
                goal = on_surface ? surface_.closest(goal).point : goal;
            }
        }
    };
    fade(first, -1);
    fade(last, 1);
    return goals;
}

bool Drag::at_rim(const Correspondence& correspondence) const
{
    const Mesh& mesh = start_.extended.model.mesh;
    const std::vector<int>& rim = start_.extended.region.fixed_rim;
    const size_t ends = correspondence.line.closed ? 0 : 1;
    for (size_t i = ends; i + ends < correspondence.targets.size(); ++i) {
        const MeshFoot foot = surface_.closest(correspondence.targets[i]);
        bool on_rim = foot.face >= 0;
        for (int k = 0; k < 3 && on_rim; ++k) {
            on_rim = foot.barycentric[k] < 1e-9 || std::ranges::binary_search(rim, mesh.F(foot.face, k));
        }
        if (on_rim) {
            return true;
        }
    }
    return false;
}

void Drag::slide_part(const Part& part, const Eigen::MatrixXd& change, Positions& V) const
{
    const std::vector<int>* free = &part.slide.free_rows();
    Eigen::MatrixXd moved = part.slide.response(change);
    if (part.rails) {
        const Rails& rails = *part.rails;
        Eigen::MatrixXd all(change.rows() + static_cast<Eigen::Index>(rails.vertices.size()), 3);
        all.topRows(change.rows()) = change;
        Eigen::Index row = change.rows();
        for (const int v : rails.vertices) {
            const Vec3 from = start_.V.row(part.side.to_global[v]);
            Vec3 place = from;
            if (rails.lines.slides(v)) {
                const auto own = std::ranges::lower_bound(*free, v) - free->begin();
                const Vec3 wanted = from + Vec3(moved.row(own)) - Vec3(rails.inner.V.row(v));
                place = rails.lines.along(v, rails.lines.tangent(v).dot(wanted));
            }
            all.row(row++) = (place - from).transpose();
            V.row(part.side.to_global[v]) = place;
        }
        moved = rails.slide.response(all);
        free = &rails.slide.free_rows();
    }
    parallel_for(static_cast<int>(free->size()), [&](int i) {
        const int v = part.side.to_global[(*free)[i]];
        if (!moved.row(i).isZero(0)) {
            V.row(v) = part.ground.closest(start_.V.row(v) + moved.row(i)).point;
        }
    });
}

void Drag::move_part(const Part& part, const std::vector<Vec3>& goals, bool slides, Positions& V) const
{
    const SideMesh& side = part.side;
    const auto count = static_cast<Eigen::Index>(part.held.size());
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(count, 3);
    for (size_t i = 0; i < goals.size(); ++i) {
        const Eigen::Index row = count - static_cast<Eigen::Index>(goals.size()) + static_cast<Eigen::Index>(i);
        change.row(row) = goals[i].transpose() - start_.V.row(side.to_global[side.line[i]]);
        V.row(side.to_global[side.line[i]]) = goals[i];
    }
    if (change.isZero(0)) {
        return;
    }
    if (slides) {
        slide_part(part, change, V);
        return;
    }
    Positions held = side.mesh.V;
    for (Eigen::Index i = 0; i < count; ++i) {
        held.row(part.held[i]) += change.row(i);
    }
    const Positions bent = part.plate.minimise(held);
    for (const int v : part.slide.free_rows()) {
        V.row(side.to_global[v]) += bent.row(v) - side.mesh.V.row(v);
    }
}

Result<DragStep> Drag::step(const FeatureLine& line, const TargetCurve& target, const CorrespondenceOptions& options,
                            std::optional<Placement> verdict, std::optional<LineSide> compressed) const
{
    return correspond(start_.extended.model, line, target, options).map([&](Correspondence correspondence) {
        DragStep step;
        step.placement = decide_placement(start_.extended.model.mesh, topology_, surface_, correspondence);
        step.placement.verdict = verdict.value_or(step.placement.verdict);
        step.placement.compressed = compressed.value_or(step.placement.compressed);
        const bool on_surface = step.placement.verdict == Placement::on_surface;
        const std::vector<Vec3> goals = line_goals(correspondence, on_surface);
        step.V = start_.V;
        for (size_t s = 0; s < parts_.size(); ++s) {
            const bool slides = start_.splits && on_surface && s == static_cast<size_t>(step.placement.compressed);
            move_part(parts_[s], goals, slides, step.V);
        }
        step.leaves_region = on_surface && at_rim(correspondence);
        step.correspondence = std::move(correspondence);
        return step;
    });
}

} // namespace tapeline
