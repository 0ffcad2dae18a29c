// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip_meter.h"

#include "kernel/quality_detail.h"

namespace tapeline {

StripMeter::StripMeter(Mesh rest) : rest_(std::move(rest))
{
    auto shape = std::make_shared<quality::RestShape>(rest_);
    shape->surface.emplace(rest_);
    shape_ = std::move(shape);
}

Result<QualityReport> StripMeter::measure(const QualityInput& input) const
{
    if (&input.rest != &rest_) {
        return fail(ErrorKind::rejected, "Cannot measure: the input's rest mesh is not this meter's.");
    }
    return quality::measured(input, &quality::measure_strip, shape_);
}

} // namespace tapeline
