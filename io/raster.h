// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/picture.h"
#include "kernel/mesh.h"

#include <array>
#include <functional>
#include <vector>

/// Inside of io/picture: a small software rasteriser, so that pictures need no display and come out the same everywhere.
namespace tapeline::picture {

using Colour = std::array<float, 3>; ///< RGB, linear light

/// A camera with a picture size: where a point falls.
struct View {
    Vec3 target, right, up, towards; ///< unit vectors of the picture; `towards` points at the viewer
    double pixels_per_mm = 1;
    int width = 0, height = 0;

    View(const Camera& camera, int picture_width, int picture_height);
    /// x, y in pixels from the upper left corner; z in mm, growing towards the viewer.
    Vec3 project(const Vec3& p) const
    {
        const Vec3 q = p - target;
        return {0.5 * width + pixels_per_mm * q.dot(right), 0.5 * height - pixels_per_mm * q.dot(up), q.dot(towards)};
    }
    /// A direction in the picture's axes: right, up, towards the viewer.
    Vec3 turn(const Vec3& d) const { return {d.dot(right), d.dot(up), d.dot(towards)}; }
};

/// Colour of a triangle's point; called from several threads.
using Shader = std::function<Colour(int face, const Vec3& barycentric)>;

struct Raster {
    int width = 0, height = 0;
    std::vector<Colour> colour;  ///< per pixel, row by row from above: mean over the covered part, linear light
    std::vector<float> coverage; ///< per pixel, in [0, 1]
    std::vector<float> depth;    ///< per pixel: z of the farthest sample [mm]; -infinity where any sample is background
    std::vector<int> face;       ///< per pixel: triangle at its middle, -1 = background
};

/// How often the shader is asked.
enum class Sampling {
    every_quarter, ///< four times a pixel, for colours that jump within a triangle, as stripes do
    every_face ///< once for each triangle that a pixel shows; edges of triangles are as smooth, at a fraction of the time
};

/// Draws all triangles, whichever way they face, at 4 × 4 samples a pixel.
Raster rasterise(const Mesh& mesh, const View& view, const Shader& shader, Sampling sampling = Sampling::every_quarter);

/// sRGB value of linear light, both in [0, 1].
float encode(float linear);
float decode(float srgb);

} // namespace tapeline::picture
