// SPDX-License-Identifier: GPL-3.0-or-later
// is_spread_out: a triangulation covers its hull once. For audits: it wants CGAL's points.
#ifndef KINEX_STRUCTURES_TRIANGULATION_SPREAD_OUT_H
#define KINEX_STRUCTURES_TRIANGULATION_SPREAD_OUT_H

#include "structures/triangulation/triangulation_2.h"

namespace kinex {

// Certificates that have failed an even number of times since now are positive again, though triangles
// have turned over, or the hull winds around twice. True if all triangles that are not ghosts turn to the left, and the hull
// winds around once. `point(id)`: CGAL's, of an exact kernel.
template <class PointAt>
bool is_spread_out(const Triangulation2& store, const PointAt& point) {
  for (Triangulation2::Triangle t = 0; t < store.triangle_capacity(); ++t) {
    if (!store.live(t) || store.ghost(t)) continue;
    const auto c = store.corners(t);
    if (!CGAL::left_turn(point(c[0]), point(c[1]), point(c[2]))) return false;
  }
  int ends = 0;  // of the part of the hull on which x ascends
  const auto first = store.out(store.infinity());
  auto at = first;
  do {
    const auto next = store.around(at), last = store.around(next);
    const auto a = point(store.target(at)), b = point(store.target(next));
    if (a < b && !(b < point(store.target(last)))) ++ends;
    at = next;
  } while (at != first);
  return ends == 1;
}

}  // namespace kinex

#endif
