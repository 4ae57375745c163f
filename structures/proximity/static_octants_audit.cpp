// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/static_octants_audit.h"

#include <cstddef>

#include "core/numbers/rational.h"

namespace kinex {
namespace {

// Where another point is: its offset; of level coordinates the one after an infinitesimal turn
// counts, of equal points the ids, along (2, 1). `sum` and `difference` decide likewise.
struct Offset {
  Rational x, y;
  int sign_x, sign_y, sign_sum, sign_difference;
};

int decided(const Rational& first, const Rational& second, int last) {
  if (!first.is_zero()) return first < Rational(0) ? -1 : 1;
  if (!second.is_zero()) return second < Rational(0) ? -1 : 1;
  return last;
}

Offset offset(const Snapshot& s, ObjectId p, ObjectId q) {
  const Rational x = s.position(q, 0) - s.position(p, 0), y = s.position(q, 1) - s.position(p, 1);
  const int last = p < q ? 1 : -1;
  return {x,
          y,
          decided(x, -y, last),
          decided(y, x, last),
          decided(x + y, x - y, last),
          decided(x - y, -x - y, last)};
}

// The cone is where both signs are negative, and the smallest length comes first; of equal ones the
// second length decides, then the id along (2, 1), up or down.
struct Cone {
  int sign_x, sign_y, sign_sum, sign_difference;  // wanted; 0: any
  int x, y;                                       // the length: x times this plus y times that
};

// -K2, K1, and the quadrant of both of the opposite octants; -K4, K3, and theirs.
constexpr Cone kStaticCones[6] = {
    {-1, 0, 0, 1, 0, -1}, {0, 1, 0, 1, 1, 0},  {-1, 1, 0, 0, -1, 1},
    {0, -1, 1, 0, 1, 0},  {-1, 0, 1, 0, 0, 1}, {-1, -1, 0, 0, -1, -1},
};

bool inside(const Cone& cone, const Offset& at) {
  const auto fits = [](int wanted, int sign) { return wanted == 0 || wanted == sign; };
  return fits(cone.sign_x, at.sign_x) && fits(cone.sign_y, at.sign_y) &&
         fits(cone.sign_sum, at.sign_sum) && fits(cone.sign_difference, at.sign_difference);
}

}  // namespace

std::vector<std::array<ObjectId, 6>> static_octants(const Snapshot& snapshot) {
  std::array<ObjectId, 6> none;
  none.fill(kNoObject);
  std::vector<std::array<ObjectId, 6>> result(snapshot.objects(), none);
  for (ObjectId p = 0; p < snapshot.objects(); ++p) {
    for (ObjectId q = 0; q < snapshot.objects(); ++q) {
      if (p == q || !snapshot.alive(p) || !snapshot.alive(q)) continue;
      const Offset at = offset(snapshot, p, q);
      for (std::size_t cone = 0; cone < 6; ++cone) {
        const Cone& c = kStaticCones[cone];
        if (!inside(c, at)) continue;
        ObjectId& best = result[p][cone];
        if (best == kNoObject) {
          best = q;
          continue;
        }
        // From the best one so far to q, in the direction of the cone and across it: (x, y) times
        // (cx, cy) and, turned counter-clockwise by an infinitesimal angle, times (cy, -cx).
        const Offset step = offset(snapshot, best, q);
        const Rational along = Rational(c.x) * step.x + Rational(c.y) * step.y;
        const Rational across = Rational(c.y) * step.x - Rational(c.x) * step.y;
        const int up = best < q ? 1 : -1;
        const int last = 2 * c.x + c.y > 0 ? up : -up;
        if (decided(along, across, last) < 0) best = q;
      }
    }
  }
  return result;
}

}  // namespace kinex
