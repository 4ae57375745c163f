// SPDX-License-Identifier: GPL-3.0-or-later
// Queries for the tests of continuous contact.
#ifndef KINEX_TESTS_PREDICATES_CCD_CONTACT_SUPPORT_H
#define KINEX_TESTS_PREDICATES_CCD_CONTACT_SUPPORT_H

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "predicates/ccd/continuous_contact.h"

namespace kinex::test {

using Point = std::array<Rational, 3>;
using Points = std::array<Point, 8>;  // four at t = 0, then four at t = 1

ContactQuery query_of(ContactKind kind, const Points& points);
Points points_of(const ContactQuery& query);
// The positions of the four points at t.
std::array<Point, 4> positions(const Points& points, const Rational& t);
// For messages.
std::string show(ContactKind kind, const Points& points);

class QueryMaker {
 public:
  explicit QueryMaker(std::uint64_t seed) : random_(seed) {}

  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int in) { return integer(1, in) == 1; }
  // Small integers (sometimes fractions): many degenerate, coplanar, grazing, at rest.
  Points small();
  // Doubles in [-1, 1], one body moved towards the other so that many meet.
  ContactQuery::Doubles ordinary(ContactKind kind);
  // The same, made to miss or to meet by about `gap`.
  ContactQuery::Doubles near(ContactKind kind, double gap);

 private:
  double unit() { return static_cast<double>(integer(-(1LL << 52), 1LL << 52)) * 0x1p-52; }

  std::mt19937_64 random_;
};

}  // namespace kinex::test

#endif
