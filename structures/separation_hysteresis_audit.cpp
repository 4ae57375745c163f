// SPDX-License-Identifier: GPL-3.0-or-later
// A wedge's line, looked at by itself: it has the polygon that it belongs to on one side and all
// vertices of the other one, where they are in the world, on the other side.
#include <algorithm>

#include "structures/separation_hysteresis.h"

namespace kinex {
namespace {

struct Placed {
  Placed(const SceneObject& object, const Snapshot& snapshot, ObjectId id)
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
  CollisionPairs::audit(snapshot, report);
  for (PairId p = 0; p < wedges_.size(); ++p) {
    const Pair& bodies = pair(p);
    const Wedge& wedge = wedges_[p];
    if (bodies.a == kNoObject || bodies.touching || bodies.apart || !wedge.in_use) continue;
    const bool of_a = wedge.line_of == Frame::kA;
    const Placed a(scene_.objects[bodies.a], snapshot, bodies.a);
    const Placed b(scene_.objects[bodies.b], snapshot, bodies.b);
    const Placed &own = of_a ? a : b, &other = of_a ? b : a;
    const Trajectory& line = kernel_.derived().trajectory(wedge.objects[wedge.turn][0]);
    const auto beyond = [&](const Vertex2& v) {  // in the frame of the line's body
      Rational along = line.position(0, Rational()) * v[0] + line.position(1, Rational()) * v[1];
      if (!of_a) along = -along;  // a line of B'
      return (along - line.position(2, Rational())).sign();
    };
    const auto& inner = own.body.polygon;
    const auto& outer = other.body.polygon;
    report.check(
        std::all_of(inner.begin(), inner.end(), [&](const Vertex2& v) { return beyond(v) <= 0; }) &&
            std::all_of(
                outer.begin(), outer.end(),
                [&](const Vertex2& v) { return beyond(own.to_frame(other.to_world(v))) > 0; }),
        [&] {
          return "the line of " + own.body.id + " does not keep " + other.body.id +
                 " off, at t = " + snapshot.time().to_string();
        });
  }
}

}  // namespace kinex
