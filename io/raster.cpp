// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/raster.h"

#include "kernel/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace tapeline::picture {

namespace {

constexpr int sub = 4;          ///< samples a pixel in each direction
constexpr int band_height = 16; ///< pixel rows that one task draws

/// What is in front at one sample.
struct Hit {
    float z = -std::numeric_limits<float>::infinity();
    int face = -1;
    float w1 = 0, w2 = 0; ///< barycentric weights of corners 1 and 2
};

/// A projected triangle in sample coordinates.
struct Flat {
    Vec3 a, b, c;
    double left, right, top, bottom;

    Flat(const Mesh& mesh, const std::vector<Vec3>& projected, int t)
        : a(projected[mesh.F(t, 0)]), b(projected[mesh.F(t, 1)]), c(projected[mesh.F(t, 2)]),
          left(std::min({a.x(), b.x(), c.x()})), right(std::max({a.x(), b.x(), c.x()})),
          top(std::min({a.y(), b.y(), c.y()})), bottom(std::max({a.y(), b.y(), c.y()}))
    {
    }
};

double cross(const Vec3& o, const Vec3& p, double x, double y)
{
    return (p.x() - o.x()) * (y - o.y()) - (p.y() - o.y()) * (x - o.x());
}

/// Draws one triangle into the samples of a band that starts at sample row `first_row`.
void draw(const Flat& f, int face, int width, int first_row, int rows, std::vector<Hit>& hits)
{
    const double area = cross(f.a, f.b, f.c.x(), f.c.y());
    if (!(std::abs(area) > 1e-12)) {
        return; // seen edge on
    }
    const int y0 = std::max(first_row, static_cast<int>(std::ceil(f.top - 0.5)));
    const int y1 = std::min(first_row + rows - 1, static_cast<int>(std::floor(f.bottom - 0.5)));
    const int x0 = std::max(0, static_cast<int>(std::ceil(f.left - 0.5)));
    const int x1 = std::min(width - 1, static_cast<int>(std::floor(f.right - 0.5)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double w1 = cross(f.c, f.a, px, py) / area, w2 = cross(f.a, f.b, px, py) / area;
            const double w0 = 1 - w1 - w2;
            if (w0 < 0 || w1 < 0 || w2 < 0) {
                continue;
            }
            const auto z = static_cast<float>(w0 * f.a.z() + w1 * f.b.z() + w2 * f.c.z());
            Hit& hit = hits[static_cast<size_t>(y - first_row) * width + x];
            if (z > hit.z) {
                hit = {z, face, static_cast<float>(w1), static_cast<float>(w2)};
            }
        }
    }
}

/// The samples of one pixel, or of a quarter of it, that lie in one triangle.
struct Patch {
    int face = -1, part = 0, count = 0;
    double w1 = 0, w2 = 0; ///< sums over the samples
};

/// Samples to shade, gathered to those that are shaded as one.
class Patches {
public:
    explicit Patches(Sampling sampling) : sampling_(sampling) {}

    void clear() { count_ = 0; }
    /// `column` and `row` of the sample in its pixel.
    void add(const Hit& hit, int column, int row)
    {
        const int part = sampling_ == Sampling::every_face ? 0 : column / (sub / 2) + 2 * (row / (sub / 2));
        int k = 0;
        while (k < count_ && (patches_[k].face != hit.face || patches_[k].part != part)) {
            ++k;
        }
        if (k == count_) {
            patches_[count_++] = {hit.face, part, 0, 0, 0};
        }
        ++patches_[k].count;
        patches_[k].w1 += hit.w1;
        patches_[k].w2 += hit.w2;
    }
    std::span<const Patch> all() const { return {patches_.data(), static_cast<size_t>(count_)}; }

private:
    Sampling sampling_;
    std::array<Patch, sub * sub> patches_;
    int count_ = 0;
};

/// Shades a band's samples and averages them over their pixels.
void resolve(const std::vector<Hit>& hits, int first_pixel_row, int pixel_rows, const Shader& shader, Sampling sampling,
             Raster& raster)
{
    Patches patches(sampling);
    const int samples_wide = raster.width * sub;
    for (int y = 0; y < pixel_rows; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            Colour sum{0, 0, 0};
            int covered = 0;
            patches.clear();
            float farthest = std::numeric_limits<float>::infinity();
            for (int k = 0; k < sub * sub; ++k) {
                const Hit& hit = hits[static_cast<size_t>(y * sub + k / sub) * samples_wide + x * sub + k % sub];
                farthest = std::min(farthest, hit.z);
                if (hit.face < 0) {
                    continue;
                }
                patches.add(hit, k % sub, k / sub);
                ++covered;
            }
            for (const Patch& patch : patches.all()) {
                const double w1 = patch.w1 / patch.count, w2 = patch.w2 / patch.count;
                const Colour c = shader(patch.face, Vec3(1.0 - w1 - w2, w1, w2));
                for (int i = 0; i < 3; ++i) {
                    sum[i] += static_cast<float>(patch.count) * c[i];
                }
            }
            const size_t pixel = static_cast<size_t>(first_pixel_row + y) * raster.width + x;
            for (int i = 0; i < 3; ++i) {
                raster.colour[pixel][i] = covered > 0 ? sum[i] / static_cast<float>(covered) : 0;
            }
            raster.coverage[pixel] = static_cast<float>(covered) / (sub * sub);
            raster.depth[pixel] = farthest;
            raster.face[pixel] = hits[static_cast<size_t>(y * sub + sub / 2) * samples_wide + x * sub + sub / 2].face;
        }
    }
}

} // namespace

View::View(const Camera& camera, int picture_width, int picture_height)
    : target(camera.target), width(picture_width), height(picture_height)
{
    towards = -camera.direction.normalized();
    Vec3 sideways = camera.up.cross(towards);
    if (sideways.norm() < 1e-9 * camera.up.norm()) {
        sideways = towards.unitOrthogonal(); // looking straight along `up`
    }
    right = sideways.normalized();
    up = towards.cross(right);
    pixels_per_mm = picture_height / camera.height_mm;
}

Raster rasterise(const Mesh& mesh, const View& view, const Shader& shader, Sampling sampling)
{
    Raster raster;
    raster.width = view.width;
    raster.height = view.height;
    const size_t pixels = static_cast<size_t>(view.width) * view.height;
    raster.colour.resize(pixels);
    raster.coverage.resize(pixels);
    raster.depth.resize(pixels);
    raster.face.resize(pixels);
    std::vector<Vec3> projected(mesh.V.rows());
    parallel_for(static_cast<int>(projected.size()), [&](int v) {
        const Vec3 p = view.project(mesh.V.row(v));
        projected[v] = Vec3(sub * p.x(), sub * p.y(), p.z());
    });
    const int bands = (view.height + band_height - 1) / band_height;
    const double band_samples = band_height * sub;
    std::vector<std::vector<int>> faces_in(bands);
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Flat f(mesh, projected, t);
        if (f.bottom < 0 || f.top >= view.height * sub || f.right < 0 || f.left >= view.width * sub) {
            continue;
        }
        const int first = std::max(0, static_cast<int>(std::floor(f.top / band_samples)));
        const int last = std::min(bands - 1, static_cast<int>(std::floor(f.bottom / band_samples)));
        for (int band = first; band <= last; ++band) {
            faces_in[band].push_back(t);
        }
    }
    parallel_for(
        bands,
        [&](int band) {
            const int first = band * band_height, rows = std::min(band_height, view.height - first);
            std::vector<Hit> hits(static_cast<size_t>(rows) * sub * view.width * sub);
            for (const int t : faces_in[band]) {
                draw(Flat(mesh, projected, t), t, view.width * sub, first * sub, rows * sub, hits);
            }
            resolve(hits, first, rows, shader, sampling, raster);
        },
        1);
    return raster;
}

float encode(float linear)
{
    const float x = std::clamp(linear, 0.0F, 1.0F);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

float decode(float srgb) { return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F); }

} // namespace tapeline::picture
