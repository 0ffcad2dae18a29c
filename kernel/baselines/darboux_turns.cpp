// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/baselines/linear_frames.h"
#include "kernel/closest_point.h"
#include "kernel/line_tangents.h"

#include <Eigen/Geometry>
#include <optional>

namespace tapeline {

namespace {

/// Columns: tangent, the normal's part across it, their cross product. None where the normal runs along the tangent.
std::optional<Eigen::Matrix3d> darboux_frame(const Vec3& tangent, const Vec3& normal)
{
    const Vec3 across = normal - normal.dot(tangent) * tangent;
    if (!(across.norm() > 1e-6)) {
        return std::nullopt;
    }
    Eigen::Matrix3d frame;
    frame.col(0) = tangent;
    frame.col(1) = across.normalized();
    frame.col(2) = tangent.cross(frame.col(1));
    return frame;
}

} // namespace

std::vector<Eigen::Matrix3d> darboux_turns(const Mesh& rest, const std::vector<int>& line, bool closed,
                                           const std::vector<Vec3>& targets, bool on_surface)
{
    std::vector<Vec3> places;
    for (const int v : line) {
        places.push_back(rest.V.row(v));
    }
    const std::vector<Vec3> from = line_tangents(places, closed), to = line_tangents(targets, closed);
    const Positions normals = vertex_normals(rest);
    const std::optional<ClosestPoint> surface = on_surface ? std::optional<ClosestPoint>(rest) : std::nullopt;
    std::vector<Eigen::Matrix3d> turns;
    for (size_t i = 0; i < line.size(); ++i) {
        const auto before = darboux_frame(from[i], normals.row(line[i]));
        std::optional<Eigen::Matrix3d> after;
        if (before && surface) {
            const MeshFoot foot = surface->closest(targets[i]);
            Vec3 normal = Vec3::Zero();
            for (int k = 0; k < 3 && foot.face >= 0; ++k) {
                normal += foot.barycentric[k] * Vec3(normals.row(rest.F(foot.face, k)));
            }
            after = darboux_frame(to[i], normal.normalized());
        }
        turns.push_back(before && after ? *after * before->transpose()
                                        : Eigen::Quaterniond::FromTwoVectors(from[i], to[i]).toRotationMatrix());
    }
    return turns;
}

} // namespace tapeline
