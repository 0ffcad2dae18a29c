// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shaders.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tapeline {

namespace {

/// Room around the model, as a share of the picture: for title, scale bar and labels.
constexpr double margin = 1.16;

std::vector<int> listed_or_all(const Mesh& mesh, const std::vector<int>& faces)
{
    std::vector<int> list = faces;
    if (list.empty()) {
        list.resize(mesh.F.rows());
        std::iota(list.begin(), list.end(), 0);
    }
    return list;
}

} // namespace

Camera fit_camera(const Mesh& mesh, const std::vector<int>& faces, double aspect)
{
    Camera camera;
    const std::vector<int> list = listed_or_all(mesh, faces);
    if (list.empty() || !mesh.V.allFinite()) {
        return camera;
    }
    Vec3 facing = Vec3::Zero();
    double area = 0;
    for (const int t : list) {
        facing += triangle_area(mesh, t) * triangle_normal(mesh, t);
        area += triangle_area(mesh, t);
    }
    // A closed part faces nowhere and is seen in the default way; a panel is seen at about 45° to its mean normal.
    if (area > 0 && facing.norm() > 0.2 * area) {
        const Vec3 normal = facing.normalized();
        Vec3 aside = -camera.direction;
        aside -= aside.dot(normal) * normal;
        aside = aside.norm() > 1e-6 ? aside.normalized() : normal.unitOrthogonal();
        camera.direction = -(normal + 0.95 * aside).normalized();
    }
    camera.height_mm = 1;
    const picture::View view(camera, 1, 1);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const int t : list) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = view.turn(mesh.V.row(mesh.F(t, k)));
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    }
    const Vec3 middle = 0.5 * (low + high), size = high - low;
    camera.target = middle.x() * view.right + middle.y() * view.up + middle.z() * view.towards;
    camera.height_mm = margin * std::max(size.y(), size.x() / aspect);
    if (!(camera.height_mm > 0)) {
        camera.height_mm = 1;
    }
    return camera;
}

double fit_zebra(const Mesh& mesh, const Camera& camera, const std::vector<int>& faces)
{
    const std::vector<int> list = listed_or_all(mesh, faces);
    const picture::View view(camera, 1, 1);
    const Positions normals = vertex_normals(mesh);
    std::vector<double> angles;
    for (const int t : list) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 n = view.turn(normals.row(mesh.F(t, k)));
            if (n.z() > 0.05) {
                angles.push_back(picture::reflection_angle(n));
            }
        }
    }
    if (angles.size() < 3) {
        return 10;
    }
    const auto quantile = [&](double q) {
        const auto at = angles.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(angles.size() - 1));
        std::nth_element(angles.begin(), at, angles.end());
        return *at;
    };
    const double spread = quantile(0.98) - quantile(0.02);
    return std::clamp(spread / 12, 0.5, 15.0);
}

} // namespace tapeline
