// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace tapeline::testing {

/// An open tube about the x axis from x = 0, normals outwards, alternating diagonals.
inline Mesh cylinder(double radius, double length, int along, int around)
{
    Mesh mesh;
    mesh.V.resize((along + 1) * around, 3);
    mesh.F.resize(2 * along * around, 3);
    int t = 0;
    for (int i = 0; i <= along; ++i) {
        for (int j = 0; j < around; ++j) {
            const double a = 2 * std::numbers::pi * (j + 0.37) / around;
            mesh.V.row(i * around + j) << length * i / along, radius * std::cos(a), radius * std::sin(a);
            if (i == along) {
                continue;
            }
            const int p = i * around + j, q = i * around + (j + 1) % around, r = p + around, s = q + around;
            if ((i + j) % 2 == 0) {
                mesh.F.row(t++) << p, r, s;
                mesh.F.row(t++) << p, s, q;
            } else {
                mesh.F.row(t++) << p, r, q;
                mesh.F.row(t++) << r, s, q;
            }
        }
    }
    for (int f = 0; f < mesh.F.rows(); ++f) { // outwards: away from the axis
        Vec3 middle = (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
        middle.x() = 0;
        if (triangle_normal(mesh, f).dot(middle) < 0) {
            std::swap(mesh.F(f, 1), mesh.F(f, 2));
        }
    }
    return mesh;
}

/// A sphere about the origin: the faces of an octahedron cut into `cells` rows of triangles each.
inline Mesh sphere(double radius, int cells)
{
    Mesh mesh;
    std::map<std::vector<int>, int> known;
    std::vector<Vec3> points;
    std::vector<Eigen::RowVector3i> triangles;
    const auto vertex = [&](const Eigen::Vector3i& c) {
        const auto [it, fresh] = known.try_emplace({c.x(), c.y(), c.z()}, static_cast<int>(points.size()));
        if (fresh) {
            points.push_back(radius * c.cast<double>().normalized());
        }
        return it->second;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const Eigen::Vector3i sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
        const bool flip = sign.prod() < 0;
        const auto corner = [&](int i, int j) {
            return vertex(sign.cwiseProduct(Eigen::Vector3i(cells - i - j, i, j)));
        };
        const auto add = [&](int a, int b, int c) {
            triangles.push_back(flip ? Eigen::RowVector3i(a, c, b) : Eigen::RowVector3i(a, b, c));
        };
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; i + j < cells; ++j) {
                add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
                if (i + j + 1 < cells) {
                    add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
                }
            }
        }
    }
    mesh.V.resize(static_cast<int>(points.size()), 3);
    mesh.F.resize(static_cast<int>(triangles.size()), 3);
    for (size_t i = 0; i < points.size(); ++i) {
        mesh.V.row(static_cast<int>(i)) = points[i];
    }
    for (size_t t = 0; t < triangles.size(); ++t) {
        mesh.F.row(static_cast<int>(t)) = triangles[t];
    }
    return mesh;
}

} // namespace tapeline::testing
