// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/method.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace tapeline {

namespace {

// One record a paragraph: the formatter would give each field its own line.
// clang-format off
constexpr std::array methods = {
    MethodInfo{.method = Method::plate_fl, .name = "plate-fl",
               .title = "both sides apart, as asan-fl, but as thin plates that keep the tangent plane at the rim",
               .deformer = Deformer::plate, .splits = true},
    MethodInfo{.method = Method::asan_fl, .name = "asan-fl",
               .title = "both sides apart: harmonic retraction, tapered extension, stiff along the move",
               .splits = true},
    MethodInfo{.method = Method::asan_fl_paper, .name = "asan-fl-paper",
               .title = "ASAN-FL as published: retraction along planes, free extension",
               .splits = true, .as_published = true, .retraction = RetractionMode::planes,
               .extension_target = ExtensionTarget::free},
    MethodInfo{.method = Method::asan_fl_sequential, .name = "asan-fl-sequential",
               .title = "ASAN-FL with a retraction that slides vertex by vertex (Pinskiy 2010)",
               .splits = true, .retraction = RetractionMode::sequential},
    MethodInfo{.method = Method::asan, .name = "asan",
               .title = "as-stiff-as-needed on the uncut region, stiff across the move"},
    MethodInfo{.method = Method::arap, .name = "arap",
               .title = "as-rigid-as-possible, spokes only (Sorkine and Alexa 2007)",
               .deformer = Deformer::spokes},
    MethodInfo{.method = Method::arap_sr, .name = "arap-sr",
               .title = "as-rigid-as-possible, spokes and rims (Chao et al. 2010)",
               .deformer = Deformer::spokes_and_rims},
    MethodInfo{.method = Method::arap_n, .name = "arap-n",
               .title = "as-rigid-as-possible, one rotation for each n-ring (Chen et al. 2017)",
               .deformer = Deformer::rings},
    MethodInfo{.method = Method::sr_arap, .name = "sr-arap",
               .title = "as-rigid-as-possible with smooth rotations (Levi and Gotsman 2015)",
               .deformer = Deformer::smooth_rotations},
    MethodInfo{.method = Method::lri, .name = "lri",
               .title = "linear rotation-invariant coordinates (Lipman et al. 2005)",
               .deformer = Deformer::linear_frames, .direct = true},
};
// clang-format on

} // namespace

std::span<const MethodInfo> method_table() { return methods; }

const MethodInfo& method_info(Method method)
{
    const auto* const found = std::ranges::find(methods, method, &MethodInfo::method);
    assert(found != methods.end());
    return *found;
}

std::optional<Method> method_named(std::string_view name)
{
    const auto* const found = std::ranges::find(methods, name, &MethodInfo::name);
    return found == methods.end() ? std::nullopt : std::optional(found->method);
}

} // namespace tapeline
