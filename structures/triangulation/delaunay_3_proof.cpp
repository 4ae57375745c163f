// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay3: the proof as data: a group for every facet, and for every edge of the hull.
#include "structures/triangulation/delaunay_3.h"

namespace kinex {

void Delaunay3::visit_proof(ProofVisitor& visitor) const {
  if (planar()) plane_->visit_proof(visitor);
  const ObjectId infinity = store_.infinity();
  ProofGroup group;
  for (Cell c = 0; c < store_.cell_capacity(); ++c) {
    if (!store_.live(c)) continue;
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      const Facet g = store_.mate(f);
      if (g < f) continue;
      const Triangulation3::Triple t = store_.triple(f);
      const bool to_infinity = t[2] == infinity;
      const bool on_hull = store_.apex(f) == infinity || store_.apex(g) == infinity;
      group.kind = to_infinity ? "hull edge" : on_hull ? "hull facet" : "facet";
      group.about = {t[0], t[1]};
      if (!to_infinity) group.about.push_back(t[2]);
      visitor.group(group);
      if (store_.label(f) == kNoCertificate) continue;
      visitor.certificate(store_.label(f), to_infinity ? "the hull is convex"
                                           : on_hull   ? "the fourth vertex is inside"
                                                       : "the sphere is empty");
    }
  }
}

}  // namespace kinex
