// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace tapeline::testing {

namespace {

constexpr double pi = std::numbers::pi;

Mesh mesh_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& faces)
{
    Mesh mesh;
    mesh.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (size_t i = 0; i < points.size(); ++i) {
        mesh.V.row(static_cast<Eigen::Index>(i)) = points[i];
    }
    for (size_t t = 0; t < faces.size(); ++t) {
        mesh.F.row(static_cast<Eigen::Index>(t)) << faces[t][0], faces[t][1], faces[t][2];
    }
    return mesh;
}

/// Quads between rings of `segments` vertices; ring j + 1 lies to the left of ring j's direction.
void join_rings(int segments, int rings, std::vector<std::array<int, 3>>& faces)
{
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < segments; ++i) {
            const int a = j * segments + i, b = j * segments + (i + 1) % segments;
            faces.push_back({a, b, b + segments});
            faces.push_back({a, b + segments, a + segments});
        }
    }
}

/// Corners in file order to a mesh; corners with equal floats become one vertex.
Mesh joined(const std::vector<std::array<float, 3>>& corners)
{
    std::map<std::array<float, 3>, int> index;
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    std::array<int, 3> face{};
    for (size_t k = 0; k < corners.size(); ++k) {
        const auto [at, added] = index.emplace(corners[k], static_cast<int>(points.size()));
        if (added) {
            points.emplace_back(corners[k][0], corners[k][1], corners[k][2]);
        }
        face[k % 3] = at->second;
        if (k % 3 == 2 && face[0] != face[1] && face[1] != face[2] && face[0] != face[2]) {
            faces.push_back(face);
        }
    }
    return mesh_of(points, faces);
}

} // namespace

Mesh cube(int n)
{
    std::map<std::array<int, 3>, int> index;
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [found, added] = index.emplace(at, static_cast<int>(points.size()));
        if (added) {
            points.emplace_back(2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1);
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, n}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[axis] = side;
                        at[(axis + 1) % 3] = i + di;
                        at[(axis + 2) % 3] = j + dj;
                        return vertex(at);
                    };
                    const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    if (side == 0) {
                        faces.push_back({a, c, b});
                        faces.push_back({a, d, c});
                    } else {
                        faces.push_back({a, b, c});
                        faces.push_back({a, c, d});
                    }
                }
            }
        }
    }
    return mesh_of(points, faces);
}

Mesh cylinder(int segments, int rings, double radius, double height)
{
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < segments; ++i) {
            const double angle = 2 * pi * i / segments;
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * j / rings);
        }
    }
    join_rings(segments, rings, faces);
    const int bottom = static_cast<int>(points.size()), top = bottom + 1;
    points.emplace_back(0, 0, 0);
    points.emplace_back(0, 0, height);
    for (int i = 0; i < segments; ++i) {
        const int next = (i + 1) % segments;
        faces.push_back({bottom, next, i});
        faces.push_back({top, rings * segments + i, rings * segments + next});
    }
    return mesh_of(points, faces);
}

Mesh ball(int slices)
{
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    const int circles = slices / 2 - 1;
    for (int j = 1; j <= circles; ++j) {
        const double polar = pi * (1 - static_cast<double>(j) / (circles + 1));
        for (int i = 0; i < slices; ++i) {
            const double angle = 2 * pi * i / slices;
            points.emplace_back(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
        }
    }
    join_rings(slices, circles - 1, faces);
    const int south = static_cast<int>(points.size());
    points.emplace_back(0, 0, -1);
    points.emplace_back(0, 0, 1);
    for (int i = 0; i < slices; ++i) {
        const int next = (i + 1) % slices;
        faces.push_back({south, next, i});
        faces.push_back({south + 1, (circles - 1) * slices + i, (circles - 1) * slices + next});
    }
    return mesh_of(points, faces);
}

Mesh cone(int segments, int rings, double half_angle)
{
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    for (int j = 0; j <= rings; ++j) {
        const double slant = 2.1 - 2.0 * j / rings;
        for (int i = 0; i < segments; ++i) {
            const double angle = 2 * pi * i / segments;
            points.emplace_back(slant * std::sin(half_angle) * std::cos(angle),
                                slant * std::sin(half_angle) * std::sin(angle), -slant * std::cos(half_angle));
        }
    }
    join_rings(segments, rings, faces);
    return mesh_of(points, faces);
}

Mesh renumbered(const Mesh& mesh, unsigned seed, std::vector<int>* new_index)
{
    std::mt19937 sequence(seed);
    const auto shuffled = [&](Eigen::Index n) {
        std::vector<int> order(n);
        std::iota(order.begin(), order.end(), 0);
        for (size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[sequence() % i]);
        }
        return order;
    };
    const auto vertex = shuffled(mesh.V.rows()), face = shuffled(mesh.F.rows());
    Mesh result = mesh;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        result.V.row(vertex[v]) = mesh.V.row(v);
    }
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const auto turn = static_cast<int>(sequence() % 3);
        for (int k = 0; k < 3; ++k) {
            result.F(face[t], k) = vertex[mesh.F(t, (k + turn) % 3)];
        }
    }
    if (new_index) {
        *new_index = vertex;
    }
    return result;
}

Mesh plain_off(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::string word;
    int vertices = 0, triangles = 0, edges = 0;
    file >> word >> vertices >> triangles >> edges;
    std::vector<Vec3> points(vertices);
    for (Vec3& p : points) {
        file >> p.x() >> p.y() >> p.z();
    }
    std::vector<std::array<int, 3>> faces(triangles);
    for (auto& face : faces) {
        int corners = 0;
        file >> corners >> face[0] >> face[1] >> face[2];
    }
    return file ? mesh_of(points, faces) : Mesh{};
}

Mesh plain_stl(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::string all((std::istreambuf_iterator<char>(file)), {});
    std::vector<std::array<float, 3>> corners;
    std::uint32_t count = 0;
    if (all.size() >= 84) {
        std::memcpy(&count, all.data() + 80, 4);
    }
    if (all.size() == 84 + 50 * static_cast<size_t>(count)) {
        for (size_t t = 0; t < count; ++t) {
            for (size_t k = 1; k < 4; ++k) {
                std::array<float, 3> corner{};
                std::memcpy(corner.data(), all.data() + 84 + 50 * t + 12 * k, 12);
                corners.push_back(corner);
            }
        }
        return joined(corners);
    }
    for (size_t at = all.find("vertex"); at != std::string::npos; at = all.find("vertex", at + 6)) {
        std::array<float, 3> corner{};
        const char* text = all.c_str() + at + 6;
        for (float& value : corner) {
            char* end = nullptr;
            value = std::strtof(text, &end);
            text = end;
        }
        corners.push_back(corner);
    }
    return joined(corners);
}

} // namespace tapeline::testing
