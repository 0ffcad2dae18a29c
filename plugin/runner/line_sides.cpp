// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/line_sides.h"

#include "kernel/closest_point.h"
#include "kernel/extension.h"
#include "kernel/quality.h"
#include "kernel/split.h"

#include <algorithm>
#include <iterator>

namespace tapeline {

namespace {

/// The line with what its feature line goes on with beyond both ends, which its prolongation follows first.
Correspondence with_rest(const Model& model, Correspondence line)
{
    const std::vector<int>& used = line.line.vertices;
    if (line.line.closed || !line.before.empty() || !line.after.empty()) {
        return line;
    }
    for (const FeatureLine& whole : find_feature_lines(model)) {
        std::vector<int> vertices = whole.vertices;
        for (const bool turned : {false, true}) {
            const auto at = std::search(vertices.begin(), vertices.end(), used.begin(), used.end());
            if (at != vertices.end() && !whole.closed) {
                line.before.assign(std::make_reverse_iterator(at), vertices.rend());
                line.after.assign(at + static_cast<std::ptrdiff_t>(used.size()), vertices.end());
                return line;
            }
            if (!turned) {
                std::ranges::reverse(vertices);
            }
        }
    }
    return line;
}

} // namespace

std::pair<std::vector<int>, std::vector<int>> sides_by_extension(const Model& model, const std::vector<int>& faces,
                                                                 const Correspondence& line)
{
    ExtensionOptions options;
    // Only the way counts here, not where it goes.
    options.target = ExtensionTarget::free;
    const auto extended = extend_line(model, region_of_faces(model, faces, false, {}), with_rest(model, line), options);
    const auto parts = extended ? split_along(*extended, 0) : tl::unexpected(extended.error());
    if (!parts) {
        return sides_of_line(model.mesh, faces, line.line.vertices, line.line.closed);
    }
    const Mesh& cut = extended->model.mesh;
    const auto before = static_cast<int>(model.mesh.F.rows());
    const ClosestPoint surface(model.mesh, faces);
    std::vector<double> left_more(before, 0);
    for (int s = 0; s < 2; ++s) {
        for (int i = 0; i < (*parts)[s].inner_faces; ++i) {
            const int t = (*parts)[s].global_faces[i];
            const Vec3 centre = (cut.V.row(cut.F(t, 0)) + cut.V.row(cut.F(t, 1)) + cut.V.row(cut.F(t, 2))) / 3;
            const bool whole = t < before && cut.F.row(t) == model.mesh.F.row(t);
            const int parent = whole ? t : surface.closest(centre).face;
            if (parent >= 0) {
                left_more[parent] += (s == 0 ? 1 : -1) * triangle_area(cut, t);
            }
        }
    }
    std::pair<std::vector<int>, std::vector<int>> sides;
    for (const int t : faces) {
        (left_more[t] > 0 ? sides.first : sides.second).push_back(t);
    }
    return sides;
}

} // namespace tapeline
