// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/line_chaining.h"

#include "kernel/feature_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace tapeline {

namespace {

/// Rounds angles so that the order of candidates does not hang on the last bits.
long long rounded(double angle) { return std::llround(angle * 1e6); }

class Chainer {
public:
    Chainer(const Mesh& mesh, const Topology& topology, std::vector<CreaseLevel> level,
            const std::vector<int>& cad_edge, const ChainOptions& options)
        : mesh_(mesh), topology_(topology), level_(std::move(level)), cad_edge_(cad_edge), options_(options),
          partner_(level_.size(), {-1, -1}), used_(level_.size(), false)
    {
    }

    std::vector<EdgeChain> run()
    {
        prune_spurs();
        for (int v = 0; v < topology_.vertex_count(); ++v) {
            pair_at(v);
        }
        std::vector<EdgeChain> chains;
        for (const bool closed : {false, true}) {
            for (int e = 0; e < topology_.edge_count(); ++e) {
                if (!crease(e) || used_[e]) {
                    continue;
                }
                const MeshEdge& edge = topology_.edge(e);
                if (closed || partner_[e][0] < 0) {
                    cut_at_repeats(trace(e, edge.a), chains);
                } else if (partner_[e][1] < 0) {
                    cut_at_repeats(trace(e, edge.b), chains);
                }
            }
        }
        std::erase_if(chains, [&](const EdgeChain& chain) {
            return std::ranges::none_of(chain.edges, [&](int e) { return level_[e] == CreaseLevel::strong; });
        });
        return chains;
    }

private:
    bool crease(int e) const { return level_[e] != CreaseLevel::none; }
    int end_of(int e, int v) const { return topology_.edge(e).a == v ? 0 : 1; }
    Vec3 direction(int e, int from) const
    {
        return (mesh_.V.row(topology_.other_end(e, from)) - mesh_.V.row(from)).normalized();
    }

    std::vector<int> creases_at(int v) const
    {
        std::vector<int> list;
        for (const int e : topology_.vertex_edges(v)) {
            if (crease(e)) {
                list.push_back(e);
            }
        }
        return list;
    }

    /// Drops weak dead ends: noise beside a strong line would otherwise lead it astray at the junction.
    void prune_spurs()
    {
        for (int v = 0; v < topology_.vertex_count(); ++v) {
            const auto start = creases_at(v);
            if (start.size() != 1) {
                continue;
            }
            std::vector<int> spur;
            int e = start.front(), at = v;
            bool junction = false;
            while (level_[e] == CreaseLevel::weak && cad_edge_[e] < 0 &&
                   static_cast<int>(spur.size()) + 1 < options_.min_spur) {
                spur.push_back(e);
                at = topology_.other_end(e, at);
                const auto next = creases_at(at);
                junction = next.size() > 2;
                if (next.size() != 2) {
                    break;
                }
                e = next[0] == e ? next[1] : next[0];
            }
            for (const int s : spur) {
                if (junction) {
                    level_[s] = CreaseLevel::none;
                }
            }
        }
    }

    void pair_at(int v)
    {
        struct Pair {
            int e, f;
            std::tuple<int, long long, long long, int, int> order;
        };
        const auto list = creases_at(v);
        std::vector<Pair> pairs;
        for (size_t i = 0; i < list.size(); ++i) {
            for (size_t j = i + 1; j < list.size(); ++j) {
                const int e = list[i], f = list[j];
                const Vec3 in = -direction(e, v), out = direction(f, v);
                const double turn = std::atan2(in.cross(out).norm(), in.dot(out)) * 180 / std::numbers::pi;
                if (!(turn <= options_.max_turn)) {
                    continue;
                }
                const bool same = cad_edge_[e] >= 0 && cad_edge_[e] == cad_edge_[f];
                const double unlike = std::abs(crease_angle(mesh_, topology_, e) - crease_angle(mesh_, topology_, f));
                const int p = topology_.other_end(e, v), q = topology_.other_end(f, v);
                pairs.push_back({e, f, {same ? 0 : 1, rounded(turn), rounded(unlike), std::min(p, q), std::max(p, q)}});
            }
        }
        std::ranges::sort(pairs, {}, &Pair::order);
        for (const Pair& pair : pairs) {
            int& of_e = partner_[pair.e][end_of(pair.e, v)];
            int& of_f = partner_[pair.f][end_of(pair.f, v)];
            if (of_e < 0 && of_f < 0) {
                of_e = pair.f;
                of_f = pair.e;
            }
        }
    }

    /// Follows partners from edge e, entered at vertex v; the last vertex repeats the first when the chain closes.
    EdgeChain trace(int e, int v)
    {
        EdgeChain chain;
        chain.vertices.push_back(v);
        while (e >= 0 && !used_[e]) {
            used_[e] = true;
            v = topology_.other_end(e, v);
            chain.edges.push_back(e);
            chain.vertices.push_back(v);
            e = partner_[e][end_of(e, v)];
        }
        return chain;
    }

    /// Splits a chain whose vertices repeat into loops and the simple pieces between them.
    static void cut_at_repeats(const EdgeChain& walk, std::vector<EdgeChain>& chains)
    {
        EdgeChain open;
        std::map<int, size_t> seen;
        for (size_t k = 0; k < walk.vertices.size(); ++k) {
            const int v = walk.vertices[k];
            if (k > 0) {
                open.edges.push_back(walk.edges[k - 1]);
            }
            const auto found = seen.find(v);
            if (found == seen.end()) {
                seen[v] = open.vertices.size();
                open.vertices.push_back(v);
                continue;
            }
            const auto from = static_cast<long>(found->second);
            EdgeChain loop;
            loop.closed = true;
            loop.vertices.assign(open.vertices.begin() + from, open.vertices.end());
            loop.edges.assign(open.edges.begin() + from, open.edges.end());
            for (const int w : loop.vertices) {
                seen.erase(w);
            }
            chains.push_back(std::move(loop));
            // What came before the loop ends here, and what follows is a line of its own.
            open.vertices.resize(from + 1);
            open.edges.resize(from);
            if (!open.edges.empty()) {
                chains.push_back(open);
            }
            open = {};
            seen.clear();
            seen[v] = 0;
            open.vertices.push_back(v);
        }
        if (!open.edges.empty()) {
            chains.push_back(std::move(open));
        }
    }

    const Mesh& mesh_;
    const Topology& topology_;
    std::vector<CreaseLevel> level_;
    const std::vector<int>& cad_edge_;
    ChainOptions options_;
    std::vector<std::array<int, 2>> partner_; ///< per edge the edge that continues it at its vertex a and b
    std::vector<bool> used_;
};

} // namespace

std::vector<EdgeChain> chain_edges(const Mesh& mesh, const Topology& topology, std::vector<CreaseLevel> level,
                                   const std::vector<int>& cad_edge, const ChainOptions& options)
{
    return Chainer(mesh, topology, std::move(level), cad_edge, options).run();
}

} // namespace tapeline
