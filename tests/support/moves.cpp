// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/moves.h"

#include <numeric>
#include <stdexcept>

namespace tapeline::testing {

FeatureLine line_of(const Model& model, const std::vector<int>& vertices)
{
    auto line = line_through(model, vertices);
    if (!line) {
        throw std::runtime_error(line.error().message);
    }
    return *line;
}

Region whole_model(const Model& model)
{
    std::vector<int> all(model.mesh.F.rows());
    std::iota(all.begin(), all.end(), 0);
    return region_of_faces(model, all, false, {});
}

Correspondence sends(const Model& model, const FeatureLine& line, const std::vector<Vec3>& displacements)
{
    Correspondence result;
    result.line = line;
    result.displacements = displacements;
    for (size_t i = 0; i < displacements.size(); ++i) {
        result.targets.push_back(Vec3(model.mesh.V.row(line.vertices[i])) + displacements[i]);
        result.parameters.push_back(static_cast<double>(i));
        result.tangents.push_back(Vec3::UnitX());
    }
    return result;
}

ExtendedLine already_extended(const Model& model, const Correspondence& correspondence)
{
    ExtendedLine extended;
    extended.model = model;
    extended.region = whole_model(model);
    extended.vertices = correspondence.line.vertices;
    extended.closed = correspondence.line.closed;
    extended.last = static_cast<int>(extended.vertices.size()) - 1;
    extended.targets = correspondence.targets;
    return extended;
}

} // namespace tapeline::testing
