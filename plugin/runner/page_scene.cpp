// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/feature_lines.h"
#include "kernel/topology.h"
#include "plugin/runner/html.h"
#include "plugin/runner/json_text.h"
#include "plugin/runner/page_parts.h"
#include "plugin/runner/target_choice.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <type_traits>

namespace tapeline::page {

namespace {

using nlohmann::ordered_json;

/// Bytes of numbers, low byte first, as base64.
template <class Number>
std::string packed(const std::vector<Number>& numbers)
{
    std::string bytes;
    bytes.reserve(numbers.size() * sizeof(Number));
    for (const Number x : numbers) {
        std::uint32_t bits = 0;
        if constexpr (std::is_same_v<Number, float>) {
            bits = std::bit_cast<std::uint32_t>(x);
        } else {
            bits = static_cast<std::make_unsigned_t<Number>>(x);
        }
        for (std::size_t k = 0; k < sizeof(Number); ++k) {
            bytes += static_cast<char>(bits >> (8 * k) & 0xFFU);
        }
    }
    return base64(bytes);
}

/// The shown triangles of one result with vertices doubled along creases, so that averaging normals at vertices shades
/// creases sharp.
struct Sheet {
    std::vector<int> source;  ///< per sheet vertex the mesh vertex
    std::vector<int> corners; ///< three a triangle: sheet vertices
};

int root_of(std::vector<int>& parent, int k)
{
    while (parent[k] != k) {
        parent[k] = parent[parent[k]];
        k = parent[k];
    }
    return k;
}

Sheet make_sheet(const Mesh& mesh, const std::vector<int>& faces, const FeatureLine& line)
{
    constexpr double sharp = 10; // [deg]
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<char> on_line(topology.edge_count(), 0);
    const std::vector<int> chain = whole_line(line);
    for (std::size_t k = 1; k < chain.size(); ++k) {
        if (const int e = topology.find_edge(chain[k - 1], chain[k]); e >= 0) {
            on_line[e] = 1;
        }
    }
    // Corners that lie at one vertex are one where the edge between their triangles is smooth.
    std::vector<int> parent(3 * mesh.F.rows());
    std::iota(parent.begin(), parent.end(), 0);
    const auto corner = [&](int t, int v) { return 3 * t + (mesh.F(t, 0) == v ? 0 : (mesh.F(t, 1) == v ? 1 : 2)); };
    for (int e = 0; e < topology.edge_count(); ++e) {
        const MeshEdge& edge = topology.edge(e);
        if (edge.face_count != 2 || edge.left < 0 || edge.right < 0 || on_line[e] != 0 ||
            crease_angle(mesh, topology, e) >= sharp) {
            continue;
        }
        for (const int v : {edge.a, edge.b}) {
            parent[root_of(parent, corner(edge.right, v))] = root_of(parent, corner(edge.left, v));
        }
    }
    Sheet sheet;
    std::vector<int> index(parent.size(), -1);
    for (const int t : faces) {
        for (int k = 0; k < 3; ++k) {
            int& at = index[root_of(parent, 3 * t + k)];
            if (at < 0) {
                at = static_cast<int>(sheet.source.size());
                sheet.source.push_back(mesh.F(t, k));
            }
            sheet.corners.push_back(at);
        }
    }
    return sheet;
}

std::string packed_indices(const std::vector<int>& indices, bool narrow)
{
    return narrow ? packed(std::vector<std::uint16_t>(indices.begin(), indices.end()))
                  : packed(std::vector<std::uint32_t>(indices.begin(), indices.end()));
}

class Scene {
public:
    explicit Scene(const Page& page) : page_(page)
    {
        const MoveResult& move = *leading(page)->move;
        box_ = shown_box(move.rest.mesh, move.region);
        centre_ = box_.center();
        const auto list = [](const Vec3& v) { return ordered_json{v.x(), v.y(), v.z()}; };
        json_["size"] = box_.diagonal().norm();
        json_["half"] = list(0.5 * box_.sizes());
        const Camera& camera = page.stage->camera;
        json_["camera"] = {{"direction", list(camera.direction)}, {"up", list(camera.up)}};
        json_["zebra_period"] = page.stage->zebra_period;
        json_["sheets"] = ordered_json::array();
        json_["results"] = ordered_json::array();
        json_["line_before"] = packed(line_positions(move.rest.mesh.V, move));
    }

    void add(const PageEntry& entry)
    {
        const MoveResult& move = *entry.move;
        const Sheet sheet = make_sheet(move.rest.mesh, faces_in(move.rest.mesh, box_), move.correspondence.line);
        const QualityMaps maps = quality_maps(quality_input(move, *page_.target));
        const bool narrow = sheet.source.size() < 65536;
        const ordered_json shape = {{"index", packed_indices(sheet.corners, narrow)},
                                    {"narrow", narrow},
                                    {"rest", packed(positions(move.rest.mesh.V, sheet))},
                                    {"gauss_before", packed(signs(maps.gauss_before, sheet))}};
        json_["results"].push_back({{"name", entry.name},
                                    {"sheet", sheet_number(shape)},
                                    {"moved", packed(positions(move.V, sheet))},
                                    {"gauss_after", packed(signs(maps.gauss_after, sheet))},
                                    {"bulge", packed(bulges(maps.bulge_mm, sheet))},
                                    {"line", packed(line_positions(move.V, move))}});
    }

    std::string text()
    {
        json_["bulge_range"] = bulge_range_;
        json_["slide_range"] = slide_range_;
        return script_json(json_line(json_));
    }

private:
    /// Methods that do not cut the mesh share their triangles.
    std::size_t sheet_number(const ordered_json& shape)
    {
        const auto [at, fresh] = sheets_.try_emplace(json_line(shape), sheets_.size());
        if (fresh) {
            json_["sheets"].push_back(shape);
        }
        return at->second;
    }

    std::vector<float> positions(const Positions& V, const Sheet& sheet) const
    {
        std::vector<float> list;
        for (const int v : sheet.source) {
            for (int k = 0; k < 3; ++k) {
                list.push_back(static_cast<float>(V(v, k) - centre_[k]));
            }
        }
        return list;
    }

    std::vector<float> line_positions(const Positions& V, const MoveResult& move)
    {
        std::vector<int> chain = move.correspondence.line.vertices;
        if (move.correspondence.line.closed) {
            chain.push_back(chain.front());
        }
        for (const int v : chain) {
            slide_range_ = std::max(slide_range_, (move.V.row(v) - move.rest.mesh.V.row(v)).norm());
        }
        return positions(V, {chain, {}});
    }

    /// -1, 0, 1; 2 where nothing was measured.
    static std::vector<std::int8_t> signs(const std::vector<double>& values, const Sheet& sheet)
    {
        std::vector<std::int8_t> list;
        for (const int v : sheet.source) {
            const double x = v < static_cast<int>(values.size()) ? values[v] : std::nan("");
            list.push_back(static_cast<std::int8_t>(std::isnan(x) ? 2 : (x > 0) - (x < 0)));
        }
        return list;
    }

    std::vector<float> bulges(const std::vector<double>& values, const Sheet& sheet)
    {
        std::vector<float> list;
        for (const int v : sheet.source) {
            const double x = v < static_cast<int>(values.size()) && std::isfinite(values[v]) ? values[v] : 0;
            bulge_range_ = std::max(bulge_range_, std::abs(x));
            list.push_back(static_cast<float>(x));
        }
        return list;
    }

    const Page& page_;
    ordered_json json_;
    Eigen::AlignedBox3d box_;
    Vec3 centre_ = Vec3::Zero();
    std::map<std::string, std::size_t> sheets_;
    double bulge_range_ = 0, slide_range_ = 0;
};

} // namespace

std::string scene_json(const Page& page)
{
    Scene scene(page);
    for (const PageEntry& entry : page.entries) {
        if (entry.move != nullptr) {
            scene.add(entry);
        }
    }
    return scene.text();
}

} // namespace tapeline::page
