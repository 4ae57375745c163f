// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/bound.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kinex {

std::size_t BoundContext::place(ObjectId object) const {
  if (members.empty()) return object;
  return static_cast<std::size_t>(std::lower_bound(members.begin(), members.end(), object) -
                                  members.begin());
}

bool BoundContext::plain() const {
  if (dynamic) return false;
  for (const int p : pieces) {
    if (p != 1) return false;
  }
  return true;
}

BoundCheck at_most(std::string id, std::string source, Integer bound, Integer observed) {
  BoundCheck check{std::move(id), std::move(source), std::move(bound), std::move(observed), true};
  check.holds = check.observed <= check.bound;
  return check;
}

Integer pairs(const Integer& n) {
  if (n.sign() <= 0) return Integer(0);
  return (n * (n - Integer(1))) >> 1;
}

Integer davenport_schinzel_bound(int s, const Integer& n) {
  if (n.sign() <= 0) return Integer(0);
  if (s <= 0) return Integer(1);
  if (s == 1) return n;
  if (s == 2) return n + n - Integer(1);
  static constexpr std::array<int, 8> kThree{1, 4, 8, 12, 17, 22, 27, 32};
  if (s == 3 && n <= Integer(8)) return Integer(kThree[static_cast<std::size_t>(n.to_int64()) - 1]);
  const Integer crossings = Integer(s) * pairs(n) + Integer(1);
  if (s > 3) return crossings;
  std::int64_t octaves = 0;
  while (Integer::power_of_two(static_cast<unsigned long>(octaves + 3)) < n) ++octaves;
  const Integer rarest = n * Integer(4 + 2 * octaves);
  return rarest < crossings ? rarest : crossings;
}

Integer pair_sign_changes(const std::vector<int>& pieces, int degree, int common) {
  const Integer n(static_cast<std::int64_t>(pieces.size()));
  if (n.is_zero()) return n;
  Integer joint(0);
  for (const int p : pieces) joint += Integer(p);
  // Sum over pairs of p_i + p_j + (common - 1) - 1: every object is in n - 1 pairs.
  joint = (n - Integer(1)) * joint + pairs(n) * Integer(common - 2);
  return Integer(degree + 1) * joint - pairs(n);
}

}  // namespace kinex
