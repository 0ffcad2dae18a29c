// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/geodesic_path.h"
#include "kernel/topology.h"

#include <vector>

namespace tapeline {

/// Where an extension of the line may run. Refers to a mesh and its topology that must outlive it.
struct RouteSpace {
    const Mesh& mesh;
    const Topology& topology;
    std::vector<char> allowed;     ///< per triangle: may be entered
    std::vector<char> blocked;     ///< per vertex: may not be passed through (only start or end there)
    std::vector<VertexPair> walls; ///< edges that may not be crossed, ascending

    bool is_wall(int edge) const;
    /// Allowed triangles that hold the path point (one that is a vertex: all around it).
    std::vector<int> faces_at(const PathPoint& point) const;
};

/// Shortest distances from one vertex over the mid-points of the edges that may be crossed.
class Corridor {
public:
    Corridor(const RouteSpace& space, int from);

    /// Approximate (never too short) distance to a vertex; infinite when it cannot be reached [mm].
    double distance(int vertex) const { return arrival_[vertex].distance; }
    /// The triangles that the shortest way to a reachable vertex passes, the last one first.
    std::vector<int> faces(int vertex) const;

private:
    struct Stop {
        double distance;
        int face = -1; ///< triangle through which the stop was reached
        int edge = -1; ///< edge before it; -1 = directly from the start
    };
    std::vector<Stop> edge_, arrival_;
};

/// The end from which an extension starts.
struct RouteStart {
    int vertex = -1;
    Vec3 forward = Vec3::Zero(); ///< unit tangent of the line, out of the line
    Vec3 side = Vec3::Zero();    ///< unit, tangential, to the left of the line's direction
};

struct RouteGoal {
    int vertex = -1;
    double cost = 0; ///< distance times a factor that grows with the angle to the plane of tangent and normal
};

/// Ranks the rim vertices that can be reached, best first (the paper's choice of Q, Section 5.1). `loop` labels the
/// region's border loops per vertex (-1 = not on the border); vertices off `wanted_loop` (-1 = any) come late.
std::vector<RouteGoal> rank_goals(const RouteSpace& space, const Corridor& corridor, const RouteStart& start,
                                  const std::vector<int>& loop, int wanted_loop);

/// Straight way across triangles: the exact geodesic inside the obstacles, moved off the vertices that are blocked and
/// snapped to vertices where it would cut off slivers.
Result<std::vector<PathPoint>> route_across(const RouteSpace& space, const Corridor& corridor, int from, int to);

/// The way along mesh edges that keeps closest to the straight line from start to goal.
Result<std::vector<PathPoint>> route_along_edges(const RouteSpace& space, const RouteStart& start, int to);

} // namespace tapeline
