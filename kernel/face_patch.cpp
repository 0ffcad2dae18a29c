// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/face_patch.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tapeline {

namespace {

/// Disjoint sets over the 3 m triangle corners.
class CornerSets {
public:
    explicit CornerSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    int find(int i)
    {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    /// The smaller index stays the root, so that local vertices are numbered in the order of the triangles.
    void join(int i, int j)
    {
        i = find(i);
        j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<int> parent_;
};

struct Side {
    int a, b, corner; ///< corner = 3 * local triangle + k; the side joins corners k and (k + 1) % 3
    bool forward;
};

std::vector<Side> sorted_sides(const Mesh& mesh, std::span<const int> faces)
{
    std::vector<Side> sides;
    sides.reserve(3 * faces.size());
    for (int t = 0; t < static_cast<int>(faces.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.F(faces[t], k), to = mesh.F(faces[t], (k + 1) % 3);
            sides.push_back({std::min(from, to), std::max(from, to), 3 * t + k, from < to});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& l, const Side& r) { return std::tie(l.a, l.b, l.corner) < std::tie(r.a, r.b, r.corner); });
    return sides;
}

int next_corner(int corner) { return corner - corner % 3 + (corner + 1) % 3; }

} // namespace

FacePatch patch_of_faces(const Mesh& mesh, std::span<const int> faces, const std::vector<VertexPair>& walls)
{
    const int count = static_cast<int>(faces.size());
    const std::vector<Side> sides = sorted_sides(mesh, faces);
    CornerSets sets(3 * count);
    for (size_t i = 0; i < sides.size();) {
        size_t end = i + 1;
        while (end < sides.size() && sides[end].a == sides[i].a && sides[end].b == sides[i].b) {
            ++end;
        }
        const bool two = end == i + 2 && sides[i].forward != sides[i + 1].forward;
        if (two && !std::binary_search(walls.begin(), walls.end(), VertexPair{sides[i].a, sides[i].b})) {
            sets.join(sides[i].corner, next_corner(sides[i + 1].corner));
            sets.join(next_corner(sides[i].corner), sides[i + 1].corner);
        }
        i = end;
    }

    FacePatch patch;
    patch.to_face.assign(faces.begin(), faces.end());
    patch.mesh.F.resize(count, 3);
    std::vector<int> local(3 * static_cast<size_t>(count), -1);
    for (int c = 0; c < 3 * count; ++c) {
        const int root = sets.find(c);
        if (local[root] < 0) {
            local[root] = static_cast<int>(patch.to_vertex.size());
            patch.to_vertex.push_back(mesh.F(faces[c / 3], c % 3));
        }
        patch.mesh.F(c / 3, c % 3) = local[root];
    }
    patch.mesh.V.resize(static_cast<int>(patch.to_vertex.size()), 3);
    for (int v = 0; v < patch.mesh.V.rows(); ++v) {
        patch.mesh.V.row(v) = mesh.V.row(patch.to_vertex[v]);
    }
    return patch;
}

} // namespace tapeline
