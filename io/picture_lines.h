// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/canvas.h"
#include "io/raster.h"

#include <vector>

/// Inside of io/picture: lines and labels on a rasterised surface.
namespace tapeline::picture {

/// Decides what of a line is in front of the surface.
class Visibility {
public:
    /// `size_mm`: of the model; a thousandth of it is how deep a line may lie within the surface.
    Visibility(const Raster& raster, const View& view, double size_mm);
    /// Whether a projected point can be seen.
    bool sees(const Vec3& projected) const;
    /// The parts of a 3D polyline that can be seen, as polylines of projected points about a pixel apart.
    std::vector<std::vector<Vec3>> visible_parts(const std::vector<Vec3>& line) const;

private:
    const Raster& raster_;
    const View& view_;
    double bias_mm_;
};

/// Draws feature lines with a light halo and their labels. Labels keep clear of each other and of the picture's border.
void draw_lines(const Canvas& canvas, const Visibility& visibility, const View& view,
                const std::vector<PictureLine>& lines);

/// Strokes mesh edges thinly.
void draw_edges(const Canvas& canvas, const Visibility& visibility, const std::vector<std::pair<Vec3, Vec3>>& edges,
                const Ink& colour, double width);

} // namespace tapeline::picture
