// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/extension.h"
#include "kernel/retraction.h"

#include <optional>
#include <span>
#include <string_view>

namespace tapeline {

enum class Method {
    asan_fl,            ///< Tapeline's defaults: harmonic retraction, tapered extension, stiff along d_o
    asan_fl_paper,      ///< as published: planes retraction, free extension, the compressed side restores the crease
    asan_fl_sequential, ///< asan_fl with Pinskiy's retraction, one vertex of the line after the other
    plate_fl,           ///< as asan_fl, each part a thin plate that keeps its tangent plane at the rim
    asan,               ///< orthotropic spokes-and-rims on the uncut region, stiff across d_o
    arap,               ///< ARAP with spokes only (Sorkine and Alexa 2007)
    arap_sr,            ///< ARAP spokes-and-rims (Chao et al. 2010)
    arap_n,             ///< ARAP with n-ring rotations (Chen et al. 2017)
    sr_arap,            ///< ARAP with smooth rotations (Levi and Gotsman 2015)
    lri                 ///< linear rotation-invariant coordinates (Lipman et al. 2005)
};

/// What a solver run minimises, or solves, for given positions of the line and the rim.
enum class Deformer {
    orthotropic,      ///< ASAN: spokes-and-rims with an orthotropic material (deformation.h)
    spokes_and_rims,  ///< the same with an isotropic material
    spokes,           ///< baselines/spokes.h
    rings,            ///< baselines/rings.h
    smooth_rotations, ///< baselines/smooth_rotations.h
    linear_frames,    ///< baselines/linear_frames.h
    plate             ///< an orthotropic thin plate (plate.h)
};

/// What a method is made of. One record a method is all that moves, options, help and comparisons know of it.
struct MethodInfo {
    Method method = Method::plate_fl;
    std::string_view name;  ///< as job files and command lines call it, e.g. "asan-fl"
    std::string_view title; ///< one line for people, without a full stop
    Deformer deformer = Deformer::orthotropic;
    bool splits = false;       ///< moves on the surface cut the region along the line and retract the compressed side
    bool direct = false;       ///< solves linear systems only, so that the answer is one
    bool as_published = false; ///< where the paper and Tapeline differ, the paper's way
    RetractionMode retraction = RetractionMode::harmonic;        ///< by default, where it splits
    ExtensionTarget extension_target = ExtensionTarget::tapered; ///< by default, where it splits
};

/// All methods, the default first.
std::span<const MethodInfo> method_table();

const MethodInfo& method_info(Method method);

/// The method of that name; none when there is none.
std::optional<Method> method_named(std::string_view name);

} // namespace tapeline
