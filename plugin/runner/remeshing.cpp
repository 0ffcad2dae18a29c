// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/remeshing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapeline {

namespace {

constexpr double vertex_limit = 50000;

Vec3 row(const Mesh& mesh, int v) { return mesh.V.row(v).transpose(); }

/// Chains of vertices that must survive: the line, what goes on before and behind it, and the bounding lines.
class KeptChains {
public:
    KeptChains(const FeatureLine& line, const RegionOptions& options)
    {
        std::vector<int> whole = line.vertices;
        if (line.closed) {
            whole.push_back(line.vertices.front());
        }
        chains_.push_back(std::move(whole));
        before_ = add(line.vertices.front(), line.before);
        after_ = add(line.vertices.back(), line.after);
        bounding_ = chains_.size();
        for (const auto* lines : {&options.bounding_lines, &options.held_lines, &options.kept_lines}) {
            chains_.insert(chains_.end(), lines->begin(), lines->end());
        }
    }

    const std::vector<std::vector<int>>& chains() const { return chains_; }

    /// What `before`, `after` and the other lines became, from the chains in new numbers.
    std::vector<int> before(const std::vector<std::vector<int>>& kept) const { return rest_of(kept, before_); }
    std::vector<int> after(const std::vector<std::vector<int>>& kept) const { return rest_of(kept, after_); }
    void renumber_lines(const std::vector<std::vector<int>>& kept, RegionOptions& options) const
    {
        std::size_t next = bounding_;
        for (auto* lines : {&options.bounding_lines, &options.held_lines, &options.kept_lines}) {
            for (std::vector<int>& line : *lines) {
                line = kept[next++];
            }
        }
    }

private:
    /// Adds `first` with what follows it, if anything does; 0 = nothing was added.
    std::size_t add(int first, const std::vector<int>& rest)
    {
        if (rest.empty()) {
            return 0;
        }
        std::vector<int> chain = {first};
        chain.insert(chain.end(), rest.begin(), rest.end());
        chains_.push_back(std::move(chain));
        return chains_.size() - 1;
    }
    static std::vector<int> rest_of(const std::vector<std::vector<int>>& kept, std::size_t chain)
    {
        return chain == 0 ? std::vector<int>{} : std::vector<int>(kept[chain].begin() + 1, kept[chain].end());
    }

    std::vector<std::vector<int>> chains_;
    std::size_t before_ = 0, after_ = 0, bounding_ = 0;
};

int nearest_vertex(const RemeshResult& remeshed, const Vec3& p)
{
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int t : remeshed.region_faces) {
        for (const int v : remeshed.model.mesh.F.row(t)) {
            const double distance = (row(remeshed.model.mesh, v) - p).squaredNorm();
            if (distance < least) {
                least = distance;
                best = v;
            }
        }
    }
    return best;
}

std::vector<int> in_new_numbers(const Model& model, const std::vector<int>& vertices, const RemeshResult& remeshed)
{
    std::vector<int> kept(model.mesh.V.rows(), -1);
    for (std::size_t v = 0; v < remeshed.old_vertex.size(); ++v) {
        if (remeshed.old_vertex[v] >= 0) {
            kept[remeshed.old_vertex[v]] = static_cast<int>(v);
        }
    }
    std::vector<int> found;
    for (const int v : vertices) {
        found.push_back(kept[v] >= 0 ? kept[v] : nearest_vertex(remeshed, row(model.mesh, v)));
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace

double automatic_max_edge(const Mesh& mesh, const std::vector<int>& faces, const FeatureLine& line)
{
    double area = 0;
    for (const int t : faces) {
        area += triangle_area(mesh, t);
    }
    // An even triangle of edge h has the area √3/4 h², and there are two triangles to a vertex.
    return std::max(line.length_mm / 60, std::sqrt(area / (vertex_limit * std::sqrt(3.0) / 2)));
}

Result<Remeshed> remesh_around(const Model& model, const std::vector<int>& faces, const FeatureLine& line,
                               const RegionOptions& options, double max_edge, double crease_angle)
{
    RemeshOptions remesh;
    remesh.max_edge_mm = max_edge;
    remesh.crease_angle = crease_angle;
    const KeptChains chains(line, options);
    remesh.keep_lines = chains.chains();
    Result<RemeshResult> result = remesh_region(model, faces, remesh);
    if (!result) {
        return tl::unexpected(result.error());
    }
    const auto& kept = result->kept_lines;
    Result<FeatureLine> again = line_through(result->model, kept[0]);
    if (!again) {
        return tl::unexpected(again.error());
    }
    Remeshed made{{},
                  std::move(*again),
                  options,
                  result->min_angle_before,
                  result->min_angle_after,
                  result->projected,
                  std::move(result->warnings)};
    made.line.id = line.id;
    made.line.before = chains.before(kept);
    made.line.after = chains.after(kept);
    chains.renumber_lines(kept, made.options);
    made.options.fixed_vertices = in_new_numbers(model, options.fixed_vertices, *result);
    made.model = std::move(result->model);
    return made;
}

} // namespace tapeline
