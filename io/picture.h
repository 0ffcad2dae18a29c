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
    shaded,
    zebra,         ///< reflection stripes
    curvature_sign ///< sign of the Gaussian curvature per vertex, from `values`
};

/// A camera that fits the listed box; equal cameras give comparable before/after pictures.
struct Camera {
    Vec3 target = Vec3::Zero();
    Vec3 direction = Vec3(-1, 1.5, -1).normalized(); ///< from the eye to the target
    Vec3 up = Vec3::UnitZ();
    double height_mm = 1; ///< what the picture's height spans (orthographic)
};
/// Looks at the mesh obliquely from the side its normals face, so that everything is inside the picture.
Camera fit_camera(const Mesh& mesh, const std::vector<int>& faces = {});

struct PictureLine {
    std::vector<Vec3> points;
    std::array<double, 3> colour{0.85, 0.1, 0.1}; ///< RGB in [0, 1]
    std::string label;                            ///< drawn at the middle; empty = none
};

struct PictureOptions {
    int width = 1200, height = 900;
    Shading shading = Shading::shaded;
    std::optional<Camera> camera;
    std::vector<double> values; ///< per vertex, for curvature_sign
    std::vector<PictureLine> lines;
    std::string title;
};

/// Renders a mesh to a PNG without a display. Deterministic.
Result<void> draw_mesh(const std::filesystem::path& png, const Mesh& mesh, const PictureOptions& options = {});

/// Draws sections (after solid, before dotted) with curvature combs, one panel a station.
Result<void> draw_sections(const std::filesystem::path& png, const std::vector<Section>& sections);

} // namespace tapeline
