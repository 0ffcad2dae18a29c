// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/picture.h"
#include "kernel/clip.h"
#include "kernel/curve.h"
#include "kernel/error.h"
#include "kernel/move.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace tapeline {

/// One picture as the bytes of a PNG file.
struct Picture {
    std::string name;  ///< file name, "before_zebra.png"
    std::string title; ///< for people
    std::string png;
};

/// What pictures that are to be compared share.
struct Stage {
    Camera camera;            ///< shows the region
    double zebra_period = 0;  ///< [deg]
    Camera closeup;           ///< looks along the line at the section in `cut`
    CutPlane cut;             ///< across the moved line where it moved farthest
    bool has_closeup = false; ///< false where there is no section with both sides
};
/// Camera and stripes fit the region of the model before any method has cut it; the close-up follows `move`.
Stage make_stage(const Mesh& model, const Region& region, const MoveResult& move, const TargetCurve& target);

struct PictureSize {
    int width = 1200, height = 900; ///< pixels
    bool both_lines = true;         ///< show the moved line in the picture before, too
    bool legend = true;             ///< scale bar and colours, for pictures that stand alone
};

/// The pictures of one state, before or after the move: "before_shaded.png" and so on for shaded, zebra, curvature (sign
/// of the Gaussian curvature) and, where there is one, closeup (cut across the line, seen along it).
Result<std::vector<Picture>> draw_state(const MoveResult& move, const TargetCurve& target, bool after,
                                        const Stage& stage, const PictureSize& size);

/// Sections across the line at so many places as one picture, "sections.png".
Result<Picture> draw_section_panels(const MoveResult& move, const TargetCurve& target, int stations);

/// All pictures of one move: both states and the sections.
Result<std::vector<Picture>> draw_move(const MoveResult& move, const TargetCurve& target, const Stage& stage);

/// Vertices of the whole feature line that this one is a part of, in order: its crease goes on beyond the part.
std::vector<int> whole_line(const FeatureLine& line);

/// The region with a margin: what is shown of a move from close.
Eigen::AlignedBox3d shown_box(const Mesh& mesh, const Region& region);
/// The triangles that reach into the box, ascending.
std::vector<int> faces_in(const Mesh& mesh, const Eigen::AlignedBox3d& box);

/// The model with its numbered feature lines, as a PNG file.
Result<void> draw_lines(const std::filesystem::path& png, const Mesh& mesh, const std::vector<FeatureLine>& lines);

} // namespace tapeline
