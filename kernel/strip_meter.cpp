// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/strip_meter.h"

#include "kernel/quality_detail.h"

#include <numeric>

namespace tapeline {

StripMeter::StripMeter(Mesh rest) : StripMeter(Model{std::move(rest), {}, {}, {}}) {}

StripMeter::StripMeter(Model rest) : rest_(std::make_shared<const Model>(std::move(rest)))
{
    auto shape = std::make_shared<quality::RestShape>(rest_->mesh);
    if (rest_->surface) {
        std::vector<int> all(rest_->mesh.F.rows());
        std::iota(all.begin(), all.end(), 0);
        shape->exact.emplace(*rest_, all);
    } else {
        shape->surface.emplace(rest_->mesh);
    }
    shape_ = std::move(shape);
}

Result<QualityReport> StripMeter::measure(const QualityInput& input) const
{
    if (&input.rest != &rest()) {
        return fail(ErrorKind::rejected, "Cannot measure: the input's rest mesh is not this meter's.");
    }
    QualityInput own = input;
    own.cad = rest_.get();
    return quality::measured(own, &quality::measure_strip, shape_);
}

} // namespace tapeline
