// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationHysteresis: independent check of a wedge's line: its own polygon lies on one side and
// all vertices of the other one, placed in the world, on the other. Where a disc is the proof, the
// line only avoids the disc's middle, and a parallel to it the polygon.
#include <algorithm>
#include <vector>

#include "core/numbers/show_text.h"
#include "structures/collision/separation_hysteresis.h"

namespace kinex {
namespace {

struct PlacedInFrame {
  PlacedInFrame(const SceneObject& object, const Snapshot& snapshot, ObjectId id)
      : body(object), x(snapshot.position(id, 0)), y(snapshot.position(id, 1)) {
    const Rational &p = snapshot.position(id, 2), &q = snapshot.position(id, 3);
    const Rational n = p * p + q * q;
    c = (p * p - q * q) / n;
    s = Rational(2) * p * q / n;
  }
  Vertex2 to_world(const Vertex2& v) const {
    return {x + c * v[0] - s * v[1], y + s * v[0] + c * v[1]};
  }
  Vertex2 to_frame(const Vertex2& v) const {
    const Rational dx = v[0] - x, dy = v[1] - y;
    return {c * dx + s * dy, c * dy - s * dx};
  }
  const SceneObject& body;
  const Rational &x, &y;
  Rational c, s;
};

}  // namespace

void SeparationHysteresis::audit(const Snapshot& snapshot, AuditReport& report) const {
  for (PairId p = 0; p < pairs_.size(); ++p) {
    if (!has_wedge(p)) continue;
    const BodyPair& pair = pairs_[p];
    const bool of_a = !wedges_[p].line_is_of_b();
    const PlacedInFrame a(pairs_.scene().objects[pair.a], snapshot, pair.a);
    const PlacedInFrame b(pairs_.scene().objects[pair.b], snapshot, pair.b);
    const PlacedInFrame &own = of_a ? a : b, &other = of_a ? b : a;
    const Trajectory& line = pairs_.kernel().derived().trajectory(wedges_[p].objects()[0]);
    const auto along =
        [&](const Vertex2& v) {  // the normal of the line, from the frame of its body
          const Rational product =
              line.position(0, Rational()) * v[0] + line.position(1, Rational()) * v[1];
          return of_a ? product : -product;  // a line of B'
        };
    std::vector<Rational> inner, outer;
    for (const Vertex2& v : own.body.polygon) inner.push_back(along(v));
    for (const Vertex2& v : other.body.polygon) {
      outer.push_back(along(own.to_frame(other.to_world(v))));
    }
    const Rational most = *std::max_element(inner.begin(), inner.end());
    const Rational least = *std::min_element(outer.begin(), outer.end());
    const Rational offset = line.position(2, Rational());
    const bool is_disc = pair.certificates == 1;
    report.check(most <= offset && (is_disc ? most : offset) < least, [&] {
      return "the line of " + show_text(own.body.id) + " does not keep " +
             show_text(other.body.id) + " off";
    });
  }
}

}  // namespace kinex
