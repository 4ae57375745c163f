// SPDX-License-Identifier: GPL-3.0-or-later
// Cells around an edge, and whether they go round it once.
//
//        y                  Seen along the edge u v, each cell is a wedge from x to y. All cells may be
//       /  '.               upright and still go round twice; the triangulation then covers a part of
//      / c   '.             space twice, which no certificate shows.
//     uv ------ x
#ifndef KINEX_STRUCTURES_TRIANGULATION_EDGE_WINDING_H
#define KINEX_STRUCTURES_TRIANGULATION_EDGE_WINDING_H

#include <vector>

#include "structures/triangulation/lifted_geometry.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

// Adds the cells around edges of `near` that they go round more than once. Edges of cells that are
// `wrong`, ascending, anyway are passed over.
void add_windings(const LiftedGeometry<SpaceComplex>& geometry, const Triangulation3& store,
                  const std::vector<Triangulation3::Cell>& near,
                  std::vector<Triangulation3::Cell>& wrong);

}  // namespace kinex

#endif
