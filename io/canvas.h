// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/raster.h"

#include <cairo.h>
#include <filesystem>
#include <memory>
#include <string>

/// Inside of io/picture: Cairo behind a light face.
namespace tapeline::picture {

using Ink = std::array<double, 4>; ///< RGB and opacity, sRGB, in [0, 1]

inline constexpr Ink dark_ink{0.13, 0.15, 0.18, 1};
inline constexpr Ink soft_ink{0.38, 0.41, 0.45, 1};

enum class Align { left, centre, right };

/// A picture in memory, with a light background that darkens a little downwards. Lengths in pixels.
class Canvas {
public:
    Canvas(int width, int height);

    /// Lays a rasterised surface over what is there.
    void lay(const Raster& raster);

    /// `cr()` is Cairo's own context, for paths.
    cairo_t* cr() const { return context_.get(); }
    void ink(const Ink& colour) const;
    /// Text with its baseline at y; returns its width.
    double text(double x, double y, const std::string& text, double size, Align align = Align::left,
                bool bold = false) const;
    double text_width(const std::string& text, double size, bool bold = false) const;
    /// Path of a rectangle with rounded corners.
    void rounded(double x, double y, double width, double height, double radius) const;

    Result<void> write(const std::filesystem::path& png) const;

private:
    struct Close {
        void operator()(cairo_t* c) const { cairo_destroy(c); }
        void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
    };
    std::unique_ptr<cairo_surface_t, Close> surface_;
    std::unique_ptr<cairo_t, Close> context_;
};

} // namespace tapeline::picture
