// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/quality.h"

#include <memory>

namespace tapeline {

namespace quality {
struct RestShape;
}

/// `measure_strip` again and again for one rest mesh, as while a target is dragged: the mesh's connectivity, its
/// normals and the search tree over its triangles are made once. The numbers are those of `measure_strip`. May be
/// shared by threads.
class StripMeter {
public:
    /// Every index of the mesh must be one of its vertices.
    explicit StripMeter(Mesh rest);
    /// The same for a model, whose CAD faces, if it has any, bulges are measured from.
    explicit StripMeter(Model rest);

    const Mesh& rest() const { return rest_->mesh; }
    const Model& model() const { return *rest_; }

    /// `input.rest` must be `rest()`, and `input.cad` is `model()`. Rejected as `measure_strip` does.
    Result<QualityReport> measure(const QualityInput& input) const;

private:
    std::shared_ptr<const Model> rest_;
    std::shared_ptr<const quality::RestShape> shape_;
};

} // namespace tapeline
