// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: the proof as data: a group for every edge, and for the edge from every hull vertex to
// infinity.
#include <algorithm>

#include "structures/triangulation/delaunay_2.h"

namespace kinex {

void Delaunay2::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  if (on_line_) {
    group.kind = "neighbours on a line";
    return line_.each_link([&](ObjectId before, ObjectId after, CertificateId certificate) {
      group.about = {before, after};
      visitor.group(group);
      visitor.certificate(certificate, "order");
    });
  }
  const ObjectId infinity = store_.infinity();
  for (Triangle t = 0; t < store_.triangle_capacity(); ++t) {
    if (!store_.live(t)) continue;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge g = store_.twin(h);
      if (g < h) continue;
      const ObjectId u = std::min(store_.origin(h), store_.origin(g));
      const ObjectId v = std::max(store_.origin(h), store_.origin(g));
      const bool to_infinity = v == infinity;
      const bool on_hull = store_.apex(h) == infinity || store_.apex(g) == infinity;
      group.kind = to_infinity ? "hull vertex" : on_hull ? "hull edge" : "edge";
      group.about = {u};
      if (!to_infinity) group.about.push_back(v);
      visitor.group(group);
      if (store_.label(h) == kNoCertificate) continue;
      visitor.certificate(store_.label(h), is_straight(h) ? "between its neighbours on the hull"
                                           : to_infinity  ? "the hull turns left"
                                           : on_hull      ? "the third vertex is inside"
                                                          : "the circle is empty");
    }
  }
}

}  // namespace kinex
