// SPDX-License-Identifier: GPL-3.0-or-later
// Regular2: the proof as data: a group for every edge, and for every hidden point.
#include <algorithm>

#include "structures/triangulation/regular_2.h"

namespace kinex {

void Regular2::visit_proof(ProofVisitor& visitor) const {
  const ObjectId infinity = store_.infinity();
  ProofGroup group;
  for (HalfEdge h = 0; h < store_.half_edge_capacity(); ++h) {
    if (!store_.live(Triangulation2::triangle(h)) || store_.twin(h) < h) continue;
    const ObjectId u = std::min(store_.origin(h), store_.target(h));
    const ObjectId v = std::max(store_.origin(h), store_.target(h));
    const bool to_infinity = v == infinity;
    const bool on_hull = store_.apex(h) == infinity || store_.apex(store_.twin(h)) == infinity;
    group.kind = to_infinity ? "hull vertex" : on_hull ? "hull edge" : "edge";
    group.about = {u};
    if (!to_infinity) group.about.push_back(v);
    visitor.group(group);
    if (store_.label(h) == kNoCertificate) continue;
    visitor.certificate(store_.label(h), to_infinity ? "the hull turns left"
                                         : on_hull   ? "the third vertex is inside"
                                                     : "the lifted edge is convex");
  }
  group.kind = "hidden point";
  for (ObjectId h = 0; h < witness_.size(); ++h) {
    if (witness_[h].corners[0] == kNoObject) continue;
    group.about = {h};
    visitor.group(group);
    for (unsigned i = 0; i < 4; ++i) {
      if (witness_[h].certificates[i] == kNoCertificate) continue;
      visitor.certificate(witness_[h].certificates[i],
                          i == 3 ? "above the plane of its witness" : "inside its witness");
    }
  }
}

}  // namespace kinex
