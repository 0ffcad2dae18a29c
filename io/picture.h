// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"
#include "kernel/mesh.h"
#include "kernel/quality.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

enum class Shading {
    shaded,         ///< soft key and fill light
    zebra,          ///< reflection of a ceiling of parallel light tubes (stripes break where the tangent plane does)
    curvature_sign, ///< sign per vertex from `values`: red positive, blue negative, grey zero, surface colour NaN
    signed_map      ///< size per vertex from `values`: red positive, blue negative, with a colour scale
};

/// A parallel projection; equal cameras give comparable before/after pictures.
struct Camera {
    Vec3 target = Vec3::Zero();                      ///< seen in the middle of the picture [mm]
    Vec3 direction = Vec3(-1, 1.5, -1).normalized(); ///< from the eye to the target
    Vec3 up = Vec3::UnitZ();                         ///< upwards in the picture; need not be normal to `direction`
    double height_mm = 1;                            ///< what the picture's height spans
};
/// Looks at the mesh obliquely from the side its normals face, so that all of it (or of the listed triangles) is
/// inside a picture whose width is `aspect` times its height, with a margin for the title.
Camera fit_camera(const Mesh& mesh, const std::vector<int>& faces = {}, double aspect = 4.0 / 3);

/// Period of zebra stripes, in degrees of the reflected direction, that shows about a dozen stripes on the mesh (or on
/// the listed triangles). Pictures to be compared must use the same period.
double fit_zebra(const Mesh& mesh, const Camera& camera, const std::vector<int>& faces = {});

struct PictureLine {
    std::vector<Vec3> points;                     ///< [mm]; parts behind the surface are not drawn
    std::array<double, 3> colour{0.85, 0.1, 0.1}; ///< RGB in [0, 1]
    std::string label;                            ///< drawn at the middle; empty = none
    bool dotted = false;
    double width = 1; ///< times the usual width, which grows with the picture
};

struct PictureOptions {
    int width = 1200, height = 900; ///< pixels, 64 to 8192 each
    Shading shading = Shading::shaded;
    std::optional<Camera> camera;  ///< none: `fit_camera` of the mesh
    std::vector<double> values;    ///< per vertex, for curvature_sign and signed_map; NaN = not measured
    double value_range = 0;        ///< signed_map: value of the full colour; 0 = largest |value|
    std::string value_unit = "mm"; ///< signed_map: written at the colour scale
    double zebra_period = 0;       ///< [deg]; 0 = `fit_zebra` of the mesh
    /// Edges at least this sharp [deg], and what goes on from them while it stands out, are drawn thin and not smoothed over.
    double crease_angle = 10;
    std::vector<std::vector<int>> sharp_lines; ///< vertex chains that are not smoothed over, however weak their crease
    std::vector<PictureLine> lines;
    std::string title;
    bool legend = true; ///< scale bar, colour scale
};

/// Renders a mesh to a PNG without a display. Same input, same bytes. Rejected when a size or index is out of range, a
/// coordinate is not finite, or `values` does not have one entry per vertex; unreadable when the file cannot be written.
Result<void> draw_mesh(const std::filesystem::path& png, const Mesh& mesh, const PictureOptions& options = {});

/// Draws sections (after solid, before dotted) with curvature combs, one panel a station. All panels share one scale; the
/// height is enlarged where the sections are flat, by the factor written in each panel. Rejected when there are none.
Result<void> draw_sections(const std::filesystem::path& png, const std::vector<Section>& sections);

} // namespace tapeline
