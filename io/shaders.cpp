// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shaders.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapeline::picture {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
const Colour paint{0.60F, 0.66F, 0.72F};      ///< sRGB of the plain surface
const Colour back_paint{0.66F, 0.58F, 0.50F}; ///< of its inner side
const Colour neutral{0.80F, 0.81F, 0.82F};    ///< of surface without a value
const Colour zero_grey{0.62F, 0.63F, 0.64F};
const Colour red{0.78F, 0.16F, 0.14F}, blue{0.13F, 0.35F, 0.76F}, white{0.96F, 0.96F, 0.95F};

Colour mix(const Colour& a, const Colour& b, float t)
{
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Colour decoded(const Colour& c) { return {decode(c[0]), decode(c[1]), decode(c[2])}; }

Colour scaled(const Colour& c, double factor)
{
    const auto f = static_cast<float>(factor);
    return {c[0] * f, c[1] * f, c[2] * f};
}

/// Light that a matt surface with normal n (picture's axes) sends to the viewer: a large key light from the upper left, a
/// fill light from the right, and sky that is brighter than the ground.
double matt_light(const Vec3& n)
{
    static const Vec3 key = Vec3(-0.55, 0.70, 0.60).normalized(), fill = Vec3(0.90, 0.05, 0.35).normalized();
    const double wrapped = std::max(0.0, (n.dot(key) + 0.3) / 1.3);
    const double side = std::max(0.0, n.dot(fill));
    return 0.15 + 0.14 * (0.5 + 0.5 * n.y()) + 0.60 * wrapped * wrapped + 0.26 * side * side;
}

/// Gloss of the key light, of the silhouette, and of a studio with soft bright and dark zones: a nearly flat panel shows
/// its form only in what it mirrors.
double gloss(const Vec3& n)
{
    static const Vec3 half = (Vec3(-0.5, 0.75, 0.65).normalized() + Vec3::UnitZ()).normalized();
    const double shine = std::pow(std::max(0.0, n.dot(half)), 48);
    const double rim = std::pow(1 - std::clamp(n.z(), 0.0, 1.0), 4);
    const double studio = 0.5 + 0.5 * std::cos((reflection_angle(n) - 62) / 38 * std::numbers::pi);
    return 0.10 * shine + 0.10 * rim + 0.13 * studio * studio;
}

/// The reflection of a tube: bright, with edges as wide as a fiftieth of the period.
double tube(double angle, double period)
{
    const double wave = std::abs(std::remainder(angle / period, 1.0)); // 0 in a tube's middle, 0.5 between tubes
    return std::clamp((0.25 - wave) * 50 + 0.5, 0.0, 1.0);
}

} // namespace

double reflection_angle(const Vec3& normal)
{
    // The viewer's ray (0, 0, -1) mirrored at the surface; tubes run to the upper right, behind the viewer.
    static const double lean = 20 / degrees;
    const Vec3 axis(std::cos(lean), std::sin(lean), 0), across(-std::sin(lean), std::cos(lean), 0);
    const Vec3 ray = 2 * normal.z() * normal - Vec3::UnitZ();
    return degrees * std::atan2(ray.dot(across), ray.z());
}

Colour map_colour(double fraction)
{
    const auto t = static_cast<float>(std::clamp(std::abs(fraction), 0.0, 1.0));
    return mix(white, fraction < 0 ? blue : red, std::pow(t, 0.8F));
}

Colour sign_colour(double value)
{
    if (std::isnan(value)) {
        return neutral;
    }
    return value > 0 ? Colour{0.84F, 0.36F, 0.32F} : (value < 0 ? Colour{0.30F, 0.50F, 0.84F} : zero_grey);
}

Shader make_shader(const Mesh& mesh, const Positions& normals, const PictureOptions& options)
{
    const auto normal_at = [&normals](int t, const Vec3& w) {
        const Vec3 n = (w[0] * normals.row(3 * t) + w[1] * normals.row(3 * t + 1) + w[2] * normals.row(3 * t + 2))
                           .transpose()
                           .normalized();
        return std::pair(n.z() >= 0 ? n : Vec3(-n), n.z() >= 0);
    };
    if (options.shading == Shading::zebra) {
        const double period = options.zebra_period;
        return [=](int t, const Vec3& w) {
            const auto [n, front] = normal_at(t, w);
            const double light = tube(reflection_angle(n), period);
            const double tone = (0.035 + 0.86 * light) * (0.72 + 0.30 * matt_light(n)) + 0.05 * gloss(n);
            return scaled(front ? Colour{1, 1, 1} : Colour{1, 0.9F, 0.8F}, tone);
        };
    }
    if (options.shading == Shading::shaded) {
        return [=](int t, const Vec3& w) {
            const auto [n, front] = normal_at(t, w);
            Colour c = scaled(decoded(front ? paint : back_paint), 1.5 * matt_light(n));
            for (float& channel : c) {
                channel += static_cast<float>(front ? gloss(n) : 0.3 * gloss(n));
            }
            return c;
        };
    }
    const bool sign_only = options.shading == Shading::curvature_sign;
    const double range = options.value_range;
    std::vector<Colour> vertex_colours(mesh.V.rows());
    for (size_t v = 0; v < vertex_colours.size(); ++v) {
        const double value = options.values[v];
        vertex_colours[v] =
            decoded(sign_only || std::isnan(value) ? sign_colour(value) : map_colour(range > 0 ? value / range : 0));
    }
    return [=, &mesh](int t, const Vec3& w) {
        const auto [n, front] = normal_at(t, w);
        Colour c{0, 0, 0};
        for (int k = 0; k < 3; ++k) {
            const Colour& corner = vertex_colours[mesh.F(t, k)];
            for (int i = 0; i < 3; ++i) {
                c[i] += static_cast<float>(w[k]) * corner[i];
            }
        }
        return scaled(c, (front ? 0.55 : 0.4) + 0.55 * matt_light(n));
    };
}

} // namespace tapeline::picture
