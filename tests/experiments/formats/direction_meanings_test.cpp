// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates along vectors whose log does not name the vectors.
#include "experiments/formats/direction_meanings.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/numbers/real_root.h"
#include "experiments/formats/certificate_polynomial.h"
#include "predicates/points/unit_directions.h"
#include "predicates/points/unit_directions_3.h"
#include "predicates/predicates.h"

namespace kinex::formats {
namespace direction_meanings_test {

Trajectory path(std::vector<std::vector<Rational>> coordinates) {
  Trajectory result;
  result.coordinates = std::move(coordinates);
  return result;
}

// Whether some meaning vanishes at t and is negative right after it.
bool fails(const DirectionMeanings& meanings, const char* predicate, const std::vector<Trajectory>& paths,
           const Rational& t, bool filtered) {
  std::vector<const Trajectory*> of;
  for (const Trajectory& one : paths) of.push_back(&one);
  RealRoot instant(t);
  RootCounters counters;
  std::optional<DirectionMeanings::Instant> at;
  if (filtered) at = {instant.lower_double(), instant.upper_double()};
  return meanings.any(predicate, of, at, [&](const Predicate& meaning) {
    const Polynomial p = certificate_polynomial(meaning, of);
    return !p.is_zero() && sign_at(p, instant, counters) == Sign::kZero &&
           sign_after(p, instant, counters) == Sign::kNegative;
  });
}

TEST(DirectionMeanings, FindsTheDirectionThatFails) {
  for (const int axes : {2, 3}) {
    const std::vector<DirectionVector> all = unit_directions(4, axes);
    const DirectionMeanings meanings(all);
    // Two points that are level along one direction at 1/3, and along no other.
    for (const DirectionVector& u : all) {
      const DirectionVector across =
          axes == 2 ? DirectionVector{-u[1], u[0]} : DirectionVector{u[1] + Rational(7) * u[2], -u[0], Rational(-7) * u[0]};
      std::vector<std::vector<Rational>> c;
      for (std::size_t axis = 0; axis < u.size(); ++axis) {
        c.push_back({across[axis] * Rational(100001) + u[axis] * Rational(1), u[axis] * Rational(-3)});
      }
      const std::vector<Trajectory> paths{path(std::vector<std::vector<Rational>>(u.size(), {Rational(0)})), path(c)};
      const Rational third = Rational(1) / Rational(3), other = Rational(1) / Rational(4);
      for (const bool filtered : {false, true}) {
        EXPECT_TRUE(fails(meanings, "order_direction", paths, third, filtered));
        EXPECT_FALSE(fails(meanings, "order_direction", paths, other, filtered));
      }
    }
  }
}

// The filter finds the same as all meanings, one by one.
TEST(DirectionMeanings, ExtentsWithAndWithoutCommonEnds) {
  const std::vector<DirectionVector> all = unit_directions_2(3);
  const DirectionMeanings meanings(all);
  int found = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      for (const std::size_t n : {2u, 3u, 4u}) {
        const std::array<int, 4> ends = n == 4   ? std::array{0, 1, 2, 3}
                                        : n == 3 ? std::array{0, 1, 2, 1}
                                                 : std::array{0, 1, 0, 1};
        const char* const name = n == 4 ? "order_extent" : n == 3 ? "order_extent_3" : "order_extent_2";
        std::vector<Trajectory> paths;
        for (std::size_t k = 0; k < n; ++k) {
          const auto x = static_cast<std::int64_t>(5 * k * k + 3 * i + 1), y = static_cast<std::int64_t>(7 * k + j);
          paths.push_back(path({{Rational(x), Rational(static_cast<std::int64_t>(k))}, {Rational(y), Rational(1 - x % 3)}}));
        }
        std::vector<const Trajectory*> of;
        for (const Trajectory& one : paths) of.push_back(&one);
        const Polynomial p = certificate_polynomial(*make_extent_order(all[i], all[j], ends), of);
        if (p.degree() != 1) continue;
        const Rational t = -Rational(p[0]) / Rational(p[1]);
        EXPECT_TRUE(fails(meanings, name, paths, t, true)) << name << " " << i << " " << j;
        EXPECT_TRUE(fails(meanings, name, paths, t, false)) << name << " " << i << " " << j;
        const Rational later = t + Rational(1) / Rational(1000003);
        EXPECT_EQ(fails(meanings, name, paths, later, true), fails(meanings, name, paths, later, false));
        EXPECT_FALSE(fails(meanings, name, paths, later, true)) << name << " " << i << " " << j;
        ++found;
      }
    }
  }
  EXPECT_GT(found, 20);
}

TEST(DirectionMeanings, Arities) {
  EXPECT_EQ(DirectionMeanings::arity_of("order_direction"), 2u);
  EXPECT_EQ(DirectionMeanings::arity_of("order_extent_3"), 3u);
  EXPECT_EQ(DirectionMeanings::arity_of("order_x"), std::nullopt);
}

}  // namespace direction_meanings_test
}  // namespace kinex::formats
