// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/linear_solver.h"
#include "kernel/plate_shape.h"

#include <Eigen/Sparse>
#include <vector>

namespace tapeline {

/// What holds a plate.
struct PlateSupport {
    std::vector<int> constrained; ///< vertices whose positions are given, without repeats
    Positions targets = {};       ///< one row each [mm]
    /// Constrained vertices at which the plate may tilt: a hinge on a border, a kink inside. At all others its tangent
    /// plane follows the triangles that have no free corner (the ring outside a rim), or stays smooth across.
    std::vector<int> free_slope = {};
    std::vector<int> line =
        {}; ///< the chain of free_slope vertices along which the plate ends or kinks, in order; may be empty
    bool closed = false; ///< whether that chain closes
    /// Free vertices that the domain carries to given places, as a strip that moves with the line and is not stretched.
    std::vector<int> carried = {};
    Positions places = {}; ///< one row each [mm]
};

/// The thin-plate energy of a mesh with its support, factorised once: what kernel/plate iterates on.
///
/// The plate is described over a *domain*: the rest mesh stretched to where the support wants it, by the harmonic
/// extension of the support's displacements and of the carried vertices'. Over it, with x the positions wanted, K the orthotropic stiffness matrix and
/// M_a the area of vertex a (a third of each of its triangles that has a free corner),
///
///     E(x) = Σ_a |(K x)_a - R_a T_a|² / M_a
///
/// summed over the free vertices and the constrained ones that are not in `free_slope`. T_a is what (K x)_a would be
/// with the rest shape's curvature: its normal part is -M_a D : b with b the second fundamental form at rest, carried to
/// the domain and kept under stretching; its tangential part is the domain's own. Where a clamped rim runs along a
/// crease, T_a is the domain's (K x)_a less what its free triangles pull across their planes at rest: a crease's angle is
/// no curvature to be kept under stretching, and the domain has turned against it. So E measures how much the surface
/// bends, not how it is stretched; where the domain is the rest mesh, T = K p and E is method.md A9's energy of u = x - p
/// (up to the rotations). R_a is fitted to the triangles around a, from the domain to x; where some of them have no free
/// corner, to those alone, so that a clamped rim keeps its own rotation. At free vertices of borders it is the rigid
/// motion of the support: the surface meets a free border as it did, ∂u/∂n = 0.
///
/// Rows of the other vertices are left out: the plate has no moment there. Along `line`, D : b would couple that with the
/// line's own new curvature and, where D is oblique to the line, with the surface's twist along it (a Poisson ratio of
/// 1). Both are known, the twist from the last pass; given to the row, they leave the section across the line its
/// curvature (a Poisson ratio of 0). It answers them by half of that (a Poisson ratio of 0.5), but never by more than its
/// own curvature at rest, and so keeps its sign.
class PlateSystem {
public:
    /// Rejected when a triangle has no area or a vertex hangs on no constraint; not converged when the matrix cannot be
    /// factorised.
    static Result<PlateSystem> create(const Mesh& rest, const PlateSupport& support, const Material& material);

    /// The domain alone, without the factorisation: `start()` of the system.
    static Result<Positions> domain(const Mesh& rest, const PlateSupport& support, const Material& material);

    int free_count() const { return static_cast<int>(free_.size()); }

    /// The start of the iteration: the domain, which meets the support. It is the rest shape to the bit where the
    /// support does not move.
    const Positions& start() const { return domain_.V; }

    /// Fits rotations, stretch and the line's normals to these positions.
    void fit(const Positions& V);
    /// One back-solve: the positions that minimise E for what was fitted last. `V` must meet the support; being near to
    /// the answer it only saves rounding error.
    Positions minimise(const Positions& V) const;
    /// E for what was fitted last, without unit.
    double energy(const Positions& V) const;

private:
    PlateSystem(const Mesh& rest, const PlateSupport& support) : rest_(rest), support_(support) {}
    Result<void> lay_out(const Material& material);
    Result<void> check() const;
    void find_free();
    void predict(const Material& material);
    void find_rows();
    void find_targets(const PlateShape& rest);
    Result<void> factorise();
    void fit_line(const Positions& V);
    Eigen::Matrix3d moment(const Mesh& from, const std::vector<TriangleElement>& elements, const Positions& to,
                           int v) const;
    Positions residuals(const Positions& V) const;

    Mesh rest_, domain_;
    PlateSupport support_;
    PlateShape shape_;             ///< of the domain
    Eigen::Matrix3d support_turn_; ///< rotation of the rigid motion that fits the clamped support best
    std::vector<int> free_, unknown_of_;
    std::vector<double> weights_; ///< per vertex 1 / M_a, 0 where its row does not count
    std::vector<std::vector<int>>
        around_; ///< per vertex the triangles that its rotation is fitted to; none: not fitted
    std::vector<std::vector<int>> beside_;              ///< at clamped rims on creases the triangles that move
    Positions targets_;                                 ///< T
    Positions normals_;                                 ///< the rest normals carried to the domain
    std::vector<Eigen::Matrix3d> curvature_;            ///< b, carried to the domain
    std::vector<Eigen::Matrix<double, 3, 2>> tangents_; ///< orthonormal, of the domain
    std::vector<Eigen::Matrix2d> unstretched_; ///< inverse of what is fitted to the domain itself, in those tangents
    std::vector<double> stretch_share_;        ///< of the stretch beyond the domain's that the curvature follows
    /// Per entry of the line what its curvature vector · n and the surface's twist along it are at rest, less b.
    std::vector<double> line_bend_, line_twist_;
    double twist_share_ = 1; ///< of the twist that is given to a line vertex's row
    CholeskySolver solver_;
    Positions wanted_; ///< R T of the last fit
    Positions ends_;   ///< rows given along the line
};

} // namespace tapeline
