// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/plate_system.h"

#include "kernel/deformation.h"
#include "kernel/line_tangents.h"
#include "kernel/local_global.h"
#include "kernel/parallel.h"
#include "kernel/placement.h"
#include "kernel/plate_domain.h"
#include "kernel/topology.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

/// Further solves for what rounding left of the residual: the matrix is K M^-1 K, badly conditioned on fine meshes.
constexpr int refinements = 1;
/// How far a moment-free line lets the section across it answer the curving and twisting of the line itself: 0 keeps the
/// section's curvature at the line, 1 (the bare D : b) opposes it by all of the line's.
constexpr double poisson_ratio = 0.5;
/// The answer is no larger than this share of the section's curvature at rest, or it would turn the section over: an
/// inflection beside the line. Chosen, with the default stiffness ratio of 3, on the tests' crease panel and the gallery's
/// panel at 100 mm and edges of 5 to 20 mm: more makes inflections, less makes the crown rounder.
constexpr double most_answer = 1;
/// The twist is known from the pass before only; fibres stiffer than this get less of it, or the passes would not settle.
constexpr double twist_stiffness = 20;
/// What a pass does to the stretch around a vertex, and with it to the curvature carried there, answers what moved it by
/// about (curvature x width)² / 5: the curvature follows the stretch where that product is below the first of these, from
/// the second on it is that of the domain. Beyond 2.2 the passes run away.
constexpr double gently_curved = 1, strongly_curved = 2;

/// x, but never beyond ±limit; smooth, and x itself as long as it is much smaller.
double limited(double x, double limit)
{
    const double size = std::sqrt(std::hypot(x * x, limit * limit));
    return size > 0 ? x * limit / size : 0;
}

std::string place(const Mesh& mesh, int v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2));
}

/// First vertex that no chain of triangles joins to a constraint; -1 when there is none.
int loose_vertex(const Mesh& mesh, const std::vector<int>& constrained)
{
    const Topology topology(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<char> held(mesh.V.rows(), 0);
    std::vector<int> front = constrained;
    for (const int v : front) {
        held[v] = 1;
    }
    while (!front.empty()) {
        const int v = front.back();
        front.pop_back();
        for (const int e : topology.vertex_edges(v)) {
            const int next = topology.other_end(e, v);
            if (!held[next]) {
                held[next] = 1;
                front.push_back(next);
            }
        }
    }
    const auto loose = std::ranges::find(held, 0);
    return loose == held.end() ? -1 : static_cast<int>(loose - held.begin());
}

Eigen::Matrix<double, 3, 2> tangent_basis(const Vec3& normal)
{
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = normal.unitOrthogonal();
    basis.col(1) = normal.cross(basis.col(0));
    return basis;
}

/// Unit tangent of the polyline at its entry i.
Vec3 tangent(const Positions& V, const std::vector<int>& line, bool closed, size_t i)
{
    const auto [before, after] = line_neighbours(i, line.size(), closed);
    return (V.row(line[after]) - V.row(line[before])).normalized();
}

} // namespace

Result<PlateSystem> PlateSystem::create(const Mesh& rest, const PlateSupport& support, const Material& material)
{
    PlateSystem system(rest, support);
    system.twist_share_ = std::min(1.0, twist_stiffness / material.stiffness_ratio);
    if (auto fine = system.lay_out(material); !fine) {
        return tl::unexpected(fine.error());
    }
    const PlateShape shape = plate_shape(rest, material);
    Material turned = material;
    turned.stiff_direction = system.support_turn_ * material.stiff_direction;
    system.shape_ = plate_shape(system.domain_, turned);
    system.find_targets(shape);
    return system.factorise().map([&] { return std::move(system); });
}

Result<Positions> PlateSystem::domain(const Mesh& rest, const PlateSupport& support, const Material& material)
{
    PlateSystem system(rest, support);
    return system.lay_out(material).map([&] { return std::move(system.domain_.V); });
}

Result<void> PlateSystem::lay_out(const Material& material)
{
    return check().map([&] {
        find_free();
        find_rows();
        predict(material);
    });
}

Result<void> PlateSystem::check() const
{
    if (auto sound = check_triangles(rest_); !sound) {
        return sound;
    }
    if (const int v = loose_vertex(rest_, support_.constrained); v >= 0) {
        return fail(ErrorKind::rejected,
                    fmt::format("a part of the region at {} mm touches neither the line nor a fixed rim, so nothing "
                                "holds it: choose a region that is one piece",
                                place(rest_, v)));
    }
    return {};
}

void PlateSystem::find_free()
{
    unknown_of_.assign(rest_.V.rows(), 0);
    for (const int v : support_.constrained) {
        unknown_of_[v] = -1;
    }
    for (int v = 0; v < rest_.V.rows(); ++v) {
        if (unknown_of_[v] == 0) {
            unknown_of_[v] = free_count();
            free_.push_back(v);
        }
    }
}

void PlateSystem::find_rows()
{
    const auto n = static_cast<size_t>(rest_.V.rows());
    std::vector<std::vector<int>> still(n);
    around_ = beside_ = still;
    for (int t = 0; t < rest_.F.rows(); ++t) {
        const bool moves =
            unknown_of_[rest_.F(t, 0)] >= 0 || unknown_of_[rest_.F(t, 1)] >= 0 || unknown_of_[rest_.F(t, 2)] >= 0;
        for (int k = 0; k < 3; ++k) {
            (moves ? around_ : still)[rest_.F(t, k)].push_back(t);
        }
    }
    weights_.assign(n, 0);
    for (size_t v = 0; v < n; ++v) {
        weights_[v] = around_[v].empty() ? 0 : 1;
        if (!still[v].empty()) {
            around_[v].swap(beside_[v] = still[v]);
        }
    }
    for (const int v : support_.free_slope) {
        weights_[v] = unknown_of_[v] >= 0 ? weights_[v] : 0;
    }
    // The slope across a border is what its row decides; a rotation that followed it would decide nothing.
    const Topology topology(rest_.F, static_cast<int>(n));
    keep_beside_creases(rest_, topology, beside_);
    for (const MeshEdge& edge : topology.edges()) {
        for (const int v : {edge.a, edge.b}) {
            if (edge.border() && weights_[v] > 0 && still[v].empty()) {
                around_[v].clear();
            }
        }
    }
}

void PlateSystem::predict(const Material& material)
{
    std::vector<int> clamped, all;
    for (size_t i = 0; i < support_.constrained.size(); ++i) {
        all.push_back(static_cast<int>(i));
        if (weights_[support_.constrained[i]] > 0) {
            clamped.push_back(static_cast<int>(i));
        }
    }
    const FittedMotion motion =
        fitted_motion(rest_.V, support_.constrained, support_.targets, clamped.empty() ? all : clamped);
    support_turn_ = motion.R;
    domain_ = rest_;
    if (!motion.still) {
        domain_.V = (rest_.V * motion.R.transpose()).rowwise() + motion.shift.transpose();
    }
    std::vector<int> given = support_.constrained;
    std::vector<int> free_entries;
    for (size_t k = 0; k < support_.carried.size(); ++k) {
        if (unknown_of_[support_.carried[k]] >= 0) {
            given.push_back(support_.carried[k]);
            free_entries.push_back(static_cast<int>(k));
        }
    }
    Positions places(static_cast<Eigen::Index>(given.size()), 3);
    places << support_.targets, support_.places(free_entries, Eigen::all);
    domain_.V = stretched_domain(rest_, domain_.V, given, places, material);
    for (const int i : all) {
        domain_.V.row(support_.constrained[i]) = support_.targets.row(i);
    }
}

Eigen::Matrix3d PlateSystem::moment(const Mesh& from, const std::vector<TriangleElement>& elements, const Positions& to,
                                    int v) const
{
    Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
    double area = 0;
    for (const int t : around_[v]) {
        Eigen::Matrix3d X;
        for (int k = 0; k < 3; ++k) {
            X.col(k) = (to.row(from.F(t, k)) - to.row(from.F(t, 0))).transpose();
        }
        S += elements[t].area * X * elements[t].gradient.transpose() * elements[t].basis.transpose();
        area += elements[t].area;
    }
    return S / area;
}

void PlateSystem::find_targets(const PlateShape& rest)
{
    const int n = static_cast<int>(rest_.V.rows());
    targets_.resize(n, 3);
    normals_.resize(n, 3);
    curvature_.resize(n);
    tangents_.resize(n);
    unstretched_.resize(n);
    stretch_share_.resize(n);
    const double width = plate_width(rest_, support_.line, support_.closed);
    const bool same = domain_.V == rest_.V;
    parallel_for(n, [&](int v) {
        Eigen::Matrix3d R = support_turn_;
        if (!same && !around_[v].empty()) {
            R = polar_rotation(moment(rest_, rest.elements, domain_.V, v));
        }
        const Vec3 normal = rest.normals.row(v), carried = R * normal, own = shape_.laplacian.row(v);
        curvature_[v] = R * rest.curvature[v] * R.transpose();
        stretch_share_[v] = 1 - smooth_step(curvature_[v].norm() * width, gently_curved, strongly_curved);
        normals_.row(v) = carried;
        const double at_rest = normal.dot(rest.laplacian.row(v)) / rest.cells[v] + rest.bend(v);
        const double wanted = at_rest - shape_.metric[v].cwiseProduct(curvature_[v]).sum();
        targets_.row(v) = own + carried * (shape_.cells[v] * wanted - carried.dot(own));
        if (same) {
            targets_.row(v) = own;
        } else if (!beside_[v].empty()) {
            targets_.row(v) = own - pull_across_planes(rest_, R, domain_, shape_.elements, v, beside_[v]);
        }
        tangents_[v] = tangent_basis(carried);
        if (!around_[v].empty()) {
            const Eigen::Matrix3d still = moment(domain_, shape_.elements, domain_.V, v);
            unstretched_[v] = (tangents_[v].transpose() * still * tangents_[v]).inverse();
        }
    });
    const std::vector<Vec3> bends = polyline_curvature(rest_.V, support_.line, support_.closed);
    const std::vector<double> twists = line_twist(rest_.V, rest.normals, support_.line, support_.closed);
    for (size_t i = 0; i < bends.size(); ++i) {
        const int v = support_.line[i];
        const Vec3 t = tangent(rest_.V, support_.line, support_.closed, i);
        line_bend_.push_back(bends[i].dot(rest.normals.row(v)) - t.dot(rest.curvature[v] * t));
        const Vec3 across = Vec3(rest.normals.row(v)).cross(t);
        line_twist_.push_back(twists[i] - t.dot(rest.curvature[v] * across));
    }
}

Result<void> PlateSystem::factorise()
{
    std::vector<double> masses(rest_.V.rows(), 0);
    for (int t = 0; t < rest_.F.rows(); ++t) {
        const bool moves =
            unknown_of_[rest_.F(t, 0)] >= 0 || unknown_of_[rest_.F(t, 1)] >= 0 || unknown_of_[rest_.F(t, 2)] >= 0;
        for (int k = 0; k < 3 && moves; ++k) {
            masses[rest_.F(t, k)] += shape_.elements[t].area / 3;
        }
    }
    for (size_t v = 0; v < weights_.size(); ++v) {
        weights_[v] = weights_[v] > 0 ? 1 / masses[v] : 0;
    }
    if (free_count() == 0) {
        return {};
    }
    // B = Sᵀ S with S = M^-1/2 K, rows that count, columns of the free vertices.
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(shape_.K.nonZeros());
    for (const int v : free_) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(shape_.K, v); it; ++it) {
            if (weights_[it.row()] > 0) {
                entries.emplace_back(static_cast<int>(it.row()), unknown_of_[v],
                                     std::sqrt(weights_[it.row()]) * it.value());
            }
        }
    }
    Eigen::SparseMatrix<double> S(rest_.V.rows(), free_count());
    S.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> B = S.transpose() * S;
    if (!solver_.factorize(B)) {
        return fail(ErrorKind::not_converged,
                    "the region's bending matrix cannot be factorised because its triangles are too thin: remesh the "
                    "region (--max-edge)");
    }
    return {};
}

void PlateSystem::fit(const Positions& V)
{
    const int n = static_cast<int>(rest_.V.rows());
    wanted_ = targets_;
    ends_ = Positions::Zero(n, 3);
    if (V == domain_.V && domain_.V == rest_.V) {
        return;
    }
    parallel_for(n, [&](int v) {
        if (weights_[v] == 0 || around_[v].empty()) {
            return;
        }
        const Eigen::Matrix3d F = moment(domain_, shape_.elements, V, v), R = polar_rotation(F);
        const Eigen::Matrix<double, 3, 2>& E = tangents_[v];
        const Eigen::Matrix2d unturned = E.transpose() * R.transpose() * F * E * unstretched_[v];
        const Eigen::Matrix3d U = E * (0.5 * (unturned + unturned.transpose())) * E.transpose();
        const Eigen::Matrix3d flat = E * E.transpose();
        const double more = shape_.metric[v].cwiseProduct(U * curvature_[v] * U - flat * curvature_[v] * flat).sum();
        const Vec3 target = targets_.row(v) - stretch_share_[v] * shape_.cells[v] * more * normals_.row(v);
        wanted_.row(v) = (R * target).transpose();
    });
    fit_line(V);
}

void PlateSystem::fit_line(const Positions& V)
{
    const Positions normals = vertex_normals(Mesh{V, rest_.F});
    const std::vector<Vec3> bends = polyline_curvature(V, support_.line, support_.closed);
    const std::vector<double> twists = line_twist(V, normals, support_.line, support_.closed);
    for (size_t i = 0; i < bends.size(); ++i) {
        const int v = support_.line[i];
        if (unknown_of_[v] >= 0) {
            continue;
        }
        const Vec3 t = tangent(V, support_.line, support_.closed, i), normal = normals.row(v);
        const double more = bends[i].dot(normal) - t.dot(curvature_[v] * t) - line_bend_[i];
        const Vec3 across = normal.cross(t);
        const double more_twist = twists[i] - t.dot(curvature_[v] * across) - line_twist_[i];
        const double known =
            t.dot(shape_.metric[v] * t) * more + 2 * twist_share_ * t.dot(shape_.metric[v] * across) * more_twist;
        const double stiffness = across.dot(shape_.metric[v] * across);
        const double own = std::abs(across.dot(curvature_[v] * across));
        const double answer = limited(-poisson_ratio * known / stiffness, most_answer * own);
        ends_.row(v) = -(known + stiffness * answer) * normals.row(v);
    }
}

Positions PlateSystem::residuals(const Positions& V) const
{
    Positions r = apply_stiffness(shape_.K, V);
    parallel_for(static_cast<int>(r.rows()), [&](int v) { r.row(v) = weights_[v] * (r.row(v) - wanted_.row(v)); });
    return r;
}

Positions PlateSystem::minimise(const Positions& V) const
{
    Positions result = V;
    for (int round = 0; round <= refinements && free_count() > 0; ++round) {
        const Positions r = residuals(result) + ends_;
        Eigen::MatrixXd gradient(free_count(), 3);
        parallel_for(free_count(), [&](int i) {
            Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
            for (Eigen::SparseMatrix<double>::InnerIterator it(shape_.K, free_[i]); it; ++it) {
                sum += it.value() * r.row(it.row());
            }
            gradient.row(i) = sum;
        });
        const Eigen::MatrixXd step = solver_.solve(gradient);
        for (int i = 0; i < free_count(); ++i) {
            result.row(free_[i]) -= step.row(i);
        }
    }
    return result;
}

double PlateSystem::energy(const Positions& V) const
{
    const Positions r = residuals(V);
    double sum = 0;
    for (int v = 0; v < r.rows(); ++v) {
        sum += weights_[v] > 0 ? r.row(v).squaredNorm() / weights_[v] : 0;
    }
    return sum;
}

} // namespace tapeline
