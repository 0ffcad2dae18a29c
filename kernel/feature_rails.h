// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/face_patch.h"
#include "kernel/topology.h"

#include <utility>
#include <vector>

namespace tapeline {

/// The feature lines of a model other than the chain `line` (closed: its ends are joined, too), as mesh edges, ascending.
/// Found as kernel/feature_lines.h does by default.
std::vector<VertexPair> other_feature_edges(const Model& model, const std::vector<int>& line, bool closed);

/// A stretch of a rail from one of its ends to the next, as a polyline.
struct RailPiece {
    std::vector<Vec3> points;
    double length() const; ///< [mm]
};

/// A place on a rail's piece.
struct RailFoot {
    Vec3 point = Vec3::Zero();
    double arc = 0; ///< from the piece's beginning [mm]
};

/// The point of the piece closest to p, or to the straight line through p along the unit vector `beyond` (not zero).
RailFoot nearest_on(const RailPiece& piece, const Vec3& p, const Vec3& beyond = Vec3::Zero());

/// Lines on a surface that its vertices must not leave: the other feature lines in a side, and open borders. A vertex on
/// a rail may only move along it, so that the line stays where it is, however the surface slides.
/// - A vertex with two rail edges that turn by at most 60° slides along both.
/// - A vertex with two edges that turn more, or with more than two, is a corner: it stays.
/// - A vertex with one edge, where a line fades out, is free.
/// Vertices that the caller decides about (`given`) end the rails that reach them.
class FeatureRails {
public:
    FeatureRails() = default;
    FeatureRails(const Mesh& mesh, const std::vector<VertexPair>& edges, const std::vector<char>& given);

    bool empty() const { return ends_.empty(); } ///< there are no rails
    bool slides(int v) const { return !empty() && next_[v].first >= 0; }
    bool corner(int v) const { return !empty() && corner_[v]; }
    /// Unit tangent of the rail at a vertex that slides.
    Vec3 tangent(int v) const;
    /// The place at arc length s [mm] from v along its rail, in the tangent's sense; the rail's end at most.
    Vec3 along(int v, double s) const;
    /// The rails that begin at `v` (a given vertex or a corner), each up to its next corner, given vertex or end.
    std::vector<RailPiece> pieces(int v) const;

private:
    Vec3 position(int v) const { return mesh_->V.row(v); }
    std::vector<int> chain(int before, int at, double length) const;

    const Mesh* mesh_ = nullptr;
    std::vector<std::vector<int>> ends_;    ///< per vertex the other ends of its rail edges
    std::vector<std::pair<int, int>> next_; ///< per sliding vertex its neighbours against and along the tangent
    std::vector<char> corner_;
};

} // namespace tapeline
