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

#include "structures/triangulation/space_geometry.h"
#include "structures/triangulation/triangulation_3.h"

namespace kinex {

// The cells around the edge between places i and j of the cell c, in order, from c on.
std::vector<Triangulation3::Cell> cells_around_edge(const Triangulation3& store,
                                                    Triangulation3::Cell c, unsigned i, unsigned j);

// True if the finite ones among these cells, which are upright, go round the edge u v once at most.
bool goes_round_once(const SpaceGeometry& geometry, const Triangulation3& store,
                     const std::vector<Triangulation3::Cell>& cells, ObjectId u, ObjectId v);

}  // namespace kinex

#endif
