// SPDX-License-Identifier: GPL-3.0-or-later
// Signs from a table of coordinates: those of separate calls and those of exact positions, whatever
// the numbers are.
#include <array>

#include "predicates/predicates.h"
#include "tests/core/arithmetic/certificate_fixture.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace coordinate_table_test {

enum Kind { kSmall, kFractions, kFar, kHuge, kTiny, kMixed, kAtRest, kQuadratic, kKinds };

std::uint64_t next(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return state >> 33;
}

Rational between(std::uint64_t& state, int least, int most) {
  const auto range = static_cast<std::uint64_t>(most - least + 1);
  return Rational(least + static_cast<int>(next(state) % range));
}

Rational power_of_ten(int exponent) {
  Rational p(1);
  for (int i = 0; i < std::abs(exponent); ++i) p *= Rational(10);
  return exponent < 0 ? Rational(1) / p : p;
}

// Few values, so that coordinates are equal at some times, or always.
Coefficients line(Kind kind, std::uint64_t& state) {
  const Rational a = between(state, -4, 4), b = between(state, -3, 3);
  switch (kind) {
    case kFractions:
      return {a / Rational(3), b / between(state, 5, 9)};
    case kFar:
      return {power_of_ten(13) + a, power_of_ten(12) + b / Rational(8)};
    case kHuge:
      return {a * power_of_ten(40), b * power_of_ten(38)};
    case kTiny:
      return {a * power_of_ten(-60), b * power_of_ten(-59)};
    case kMixed:
      return {a * power_of_ten(static_cast<int>(next(state) % 80) - 40), b / Rational(7)};
    case kAtRest:
      return {a, Rational(0)};
    case kQuadratic:
      return {a, b, between(state, -1, 1)};
    default:
      return {a, b};
  }
}

Rational value_at(const Coefficients& c, const Rational& t) {
  Rational value(0);
  for (std::size_t i = c.size(); i-- > 0;) value = value * t + c[i];
  return value;
}

// The sign of b - a right after t.
Sign exact_sign(Coefficients a, const Coefficients& b, Rational t) {
  a.resize(3);
  for (std::size_t i = 0; i < 3; ++i) a[i] = (i < b.size() ? b[i] : Rational(0)) - a[i];
  const std::array<Rational, 3> derivatives{value_at(a, t), a[1] + Rational(2) * a[2] * t, a[2]};
  for (const Rational& d : derivatives) {
    if (!d.is_zero()) return d < Rational(0) ? Sign::kNegative : Sign::kPositive;
  }
  return Sign::kZero;
}

struct Table {
  Table(std::string_view arithmetic_name, Kind kind, std::uint64_t seed) {
    std::uint64_t state = seed;
    for (std::size_t i = 0; i < 90; ++i) {
      lines.push_back({line(kind, state), line(kind, state)});
      objects.push_back(static_cast<ObjectId>(i * 7 % 90));  // some order
    }
    const Scene scene = make_scene(lines, Rational(0));
    arithmetic = make_arithmetic(arithmetic_name, scene);
    set_motions(scene, *arithmetic);
    for (const int axis : {0, 1}) {
      orders[static_cast<std::size_t>(axis)] = arithmetic->bind(make_coordinate_order(axis));
    }
  }
  // An object beyond those of the scene, at rest.
  ObjectId constant(const Rational& x, const Rational& y) {
    lines.push_back({{x}, {y}});
    Trajectory trajectory;
    trajectory.coordinates = lines.back();
    const auto id = static_cast<ObjectId>(lines.size() - 1);
    arithmetic->set_motion(id, trajectory, std::nullopt);
    return id;
  }
  std::vector<Sign> signs(std::size_t axis, ObjectId second, std::size_t place, std::size_t size) {
    std::vector<Sign> result(size);
    arithmetic->signs_after(orders[axis], tables[axis], place,
                            std::span(objects).subspan(place, size), second, result.data());
    return result;
  }
  OutOfInterval out(std::size_t axis, ObjectId low, ObjectId high, std::size_t place,
                    std::size_t size) {
    return arithmetic->out_of_interval(orders[axis], tables[axis], place,
                                       std::span(objects).subspan(place, size), low, high);
  }
  void fill() {
    for (const std::size_t axis : {0u, 1u}) {
      arithmetic->fill(orders[axis], objects, tables[axis]);
    }
  }
  std::uint64_t counted(std::size_t axis) const {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : arithmetic->counters().by_predicate[orders[axis]].signs) sum += n;
    return sum;
  }

  std::vector<std::vector<Coefficients>> lines;
  std::vector<ObjectId> objects;
  std::unique_ptr<Arithmetic> arithmetic;
  std::array<PredicateId, 2> orders{};
  std::array<CoordinateTable, 2> tables;
};

void expect_exact(Table& table, std::size_t axis, ObjectId second, const Rational& now) {
  for (const auto& [place, size] : {std::pair<std::size_t, std::size_t>(0, 90), {3, 70}, {89, 1}, {5, 0}}) {
    const std::uint64_t before = table.counted(axis);
    const std::vector<Sign> signs = table.signs(axis, second, place, size);
    EXPECT_EQ(table.counted(axis), before + size);
    for (std::size_t i = 0; i < size; ++i) {
      const ObjectId first = table.objects[place + i];
      EXPECT_EQ(signs[i], exact_sign(table.lines[first][axis], table.lines[second][axis], now))
          << first << " " << second << " at " << now.to_string();
    }
  }
}

// The same objects between two others.
void expect_exact_interval(Table& table, std::size_t axis, ObjectId low, ObjectId high,
                           const Rational& now) {
  using Part = std::pair<std::size_t, std::size_t>;
  for (const Part& part : {Part(0, 64), Part(26, 64), Part(3, 33), Part(7, 4), Part(8, 3), Part(89, 1), Part(5, 0)}) {
    const std::size_t place = part.first, size = part.second;
    const std::uint64_t before = table.counted(axis);
    const OutOfInterval out = table.out(axis, low, high, place, size);
    EXPECT_EQ(table.counted(axis), before + 2 * size);
    OutOfInterval expected;
    for (std::size_t i = 0; i < size; ++i) {
      const auto sign = [&](ObjectId end) {
        const ObjectId first = table.objects[place + i];
        return exact_sign(table.lines[first][axis], table.lines[end][axis], now);
      };
      if (sign(low) == Sign::kPositive) expected.before |= std::uint64_t{1} << i;
      if (sign(high) == Sign::kNegative) expected.after |= std::uint64_t{1} << i;
    }
    EXPECT_EQ(out.before, expected.before) << low << " at " << now.to_string();
    EXPECT_EQ(out.after, expected.after) << high << " at " << now.to_string();
  }
}

TEST(CoordinateTable, SignsAreThoseOfExactPositions) {
  for (int kind = 0; kind < kKinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SCOPED_TRACE("kind " + std::to_string(kind) + ", seed " + std::to_string(seed));
      for (const char* name : {"exact", "sturm"}) {
        Table table(name, static_cast<Kind>(kind), seed);
        table.fill();
        std::uint64_t state = seed;
        for (const char* t : {"0", "1/2", "1", "2/3", "17/7", "1000000007/998244353"}) {
          const Rational now = rational(t);
          table.arithmetic->set_now(now);
          for (int k = 0; k < 4; ++k) {
            const auto second = static_cast<ObjectId>(next(state) % 90);
            const auto other = static_cast<ObjectId>(next(state) % 90);
            for (const std::size_t axis : {0u, 1u}) {
              expect_exact(table, axis, second, now);
              if (k == 0) expect_exact_interval(table, axis, second, other, now);
            }
          }
          // As the corner of a box: level with an object at this time, or elsewhere.
          const auto& level = table.lines[static_cast<std::size_t>(next(state) % 90)];
          const ObjectId corner =
              table.constant(value_at(level[0], now), between(state, -9, 9) / Rational(11));
          for (const std::size_t axis : {0u, 1u}) {
            expect_exact(table, axis, corner, now);
            expect_exact_interval(table, axis, corner, corner, now);
          }
        }
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

// Now is a root, known as an interval.
TEST(CoordinateTable, SignsAtFailureTimes) {
  int advanced = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Table table("exact", seed % 2 == 0 ? kFractions : kSmall, seed);
    table.fill();
    std::uint64_t state = seed;
    for (int k = 0; k < 4; ++k) {
      const auto a = static_cast<ObjectId>(next(state) % 90), b = static_cast<ObjectId>(next(state) % 90);
      if (a == b) continue;
      const Query query(table.orders[0], {a, b});
      FailureTime time;
      if (table.arithmetic->failure(query, time) != Outlook::kFails) continue;
      const Coefficients &p = table.lines[a][0], &q = table.lines[b][0];
      const Rational now = (q[0] - p[0]) / (p[1] - q[1]);
      table.arithmetic->advance(query, time);
      ++advanced;
      for (const ObjectId second : {a, b}) {
        for (const std::size_t axis : {0u, 1u}) {
          expect_exact(table, axis, second, now);
          expect_exact_interval(table, axis, second, a, now);
        }
      }
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(advanced, 20);
}

// Coordinates that differ by less than floats tell, or by less than doubles do.
TEST(CoordinateTable, NearCoordinates) {
  for (const char* t : {"0", "1/3", "999999/1000000"}) {
    for (int exponent = -30; exponent <= 2; ++exponent) {
      Table table("exact", kFractions, 5);
      std::uint64_t state = static_cast<std::uint64_t>(exponent + 40);
      for (std::size_t i = 0; i < 90; ++i) {
        Trajectory trajectory;
        const Rational step = between(state, -9, 9) * power_of_ten(exponent);
        table.lines[i] = {{Rational(1) / Rational(3) + step, Rational(5) / Rational(7) + step * Rational(2)},
                          {Rational(1000003) + step, Rational(-999983)}};
        trajectory.coordinates = table.lines[i];
        table.arithmetic->set_motion(static_cast<ObjectId>(i), trajectory, std::nullopt);
      }
      table.fill();
      const Rational now = rational(t);
      table.arithmetic->set_now(now);
      for (const std::size_t axis : {0u, 1u}) {
        expect_exact_interval(table, axis, 3, 8, now);
        expect_exact_interval(table, axis, 40, 41, now);
      }
      if (testing::Test::HasFailure()) return;
    }
  }
}

// Linear motions are looked up, and nearly all signs are found there.
TEST(CoordinateTable, DecidesMostSigns) {
  for (const Kind kind : {kSmall, kFractions, kFar}) {
    SCOPED_TRACE(kind);
    Table table("exact", kind, 3);
    table.fill();
    EXPECT_GT(table.tables[0].bytes(), 0u);
    table.arithmetic->set_now(rational("1/3"));
    table.signs(0, 1, 0, 90);
    EXPECT_GE(table.arithmetic->counters().by_predicate[table.orders[0]].signs[0], 60u);
  }
  Table quadratic("exact", kQuadratic, 3);
  quadratic.fill();
  EXPECT_EQ(quadratic.tables[0].bytes(), 0u);
}

TEST(CoordinateTable, InexactSignsAreThoseOfSeparateCalls) {
  for (const char* name : {"double", "gsl", "mpfr:24"}) {
    Table table(name, kFractions, 9);
    table.fill();
    table.arithmetic->set_now(rational("2/3"));
    for (const ObjectId second : {0u, 17u}) {
      const std::vector<Sign> signs = table.signs(0, second, 0, 90);
      for (std::size_t i = 0; i < 90; ++i) {
        const Query query(table.orders[0], {table.objects[i], second});
        EXPECT_EQ(signs[i], table.arithmetic->sign_after(query)) << name;
      }
      const OutOfInterval out = table.out(0, second, 5, 0, 64);
      for (std::size_t i = 0; i < 64; ++i) {
        const std::uint64_t bit = std::uint64_t{1} << i;
        const Query above(table.orders[0], {table.objects[i], 5});
        EXPECT_EQ((out.before & bit) != 0, signs[i] == Sign::kPositive) << name;
        EXPECT_EQ((out.after & bit) != 0,
                  table.arithmetic->sign_after(above) == Sign::kNegative) << name;
      }
    }
  }
}

}  // namespace coordinate_table_test
}  // namespace kinex::test
