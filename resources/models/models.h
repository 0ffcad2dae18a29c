// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace tapeline::models {

/// A hood, 1400 × 1200 mm, crowned both ways (radii about 3 m and 1.8 m). A gently bent character line crosses it from
/// the rim at x = 0, where it is 20° sharp, keeps that to x = 250 and fades to nothing at x = 1250; from there to the
/// rim at x = 1400 the two faces go on tangentially. Two faces, seven edges.
TopoDS_Shape hood();

/// A fender around a wheel arch: a sharp line runs about 45 mm above the arch with a narrow strip beneath it, and the
/// panel beyond the line leaves it through a tight bend (radius about 50 mm). Two faces.
TopoDS_Shape wheel_arch();

/// A chess pawn, 70 mm high, a solid of revolution about z with sharp circular edges.
TopoDS_Shape pawn();

/// A mechanical bracket: a flat side meets a curved side at a sharp, curved edge; fillets and holes elsewhere. A solid.
TopoDS_Shape bracket();

/// The crease-slide panel, 800 × 600 mm with a 12° crease along y = 0, as 3 × 2 patches that share no edge.
TopoDS_Shape panel();

/// A door skin, 1000 × 600 mm, crowned both ways: a sharp shoulder line along y = 0, a fainter line bent like a bow some
/// 130 mm above it, and a seam at x = 60 that crosses both. Six faces.
TopoDS_Shape door();

/// The crease-slide panel with a styled line: along y = 0 the surface drops by 29° and turns flat again through a bend
/// 8 mm wide. Three faces, the bend one of them.
TopoDS_Shape filleted_panel();

} // namespace tapeline::models
