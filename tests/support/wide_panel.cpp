// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/wide_panel.h"

#include "tests/support/moves.h"

#include <cmath>

namespace tapeline::testing {

WidePanel::WidePanel(Diagonals diagonals, int nx, int ny)
    : model(model_of(grid(nx, ny, -500, 500, -400, 400, crease_panel_height, diagonals, {ny / 2})))
{
    const Mesh& mesh = model.mesh;
    std::vector<int> faces;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        const Vec3 centre = (mesh.V.row(mesh.F(t, 0)) + mesh.V.row(mesh.F(t, 1)) + mesh.V.row(mesh.F(t, 2))) / 3;
        if (std::abs(centre.x()) < 400 && std::abs(centre.y()) < 300) {
            faces.push_back(t);
        }
    }
    region = region_of_faces(model, faces, false, {});
    for (int i = 0; i <= nx; ++i) {
        if (std::abs(-500 + 1000.0 * i / nx) < 400) {
            line.push_back(ny / 2 * (nx + 1) + i);
        }
    }
}

} // namespace tapeline::testing
