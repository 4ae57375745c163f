// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates of many arguments, of high degree, with weights and constants, in every arithmetic,
// against a rational oracle that sees only their values (rational_oracle.h).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/arithmetic/general_predicates.h"
#include "tests/core/arithmetic/rational_oracle.h"
#include "tests/sanitized.h"

namespace kinex {
namespace general_predicates_test {

using test::Coefficients;
using test::GeneralPredicate;
using test::Place;
using test::RationalOracle;

constexpr const char* kArithmetics[] = {"exact", "sturm", "double", "gsl", "mpfr:300"};

// What the coordinates of a scene look like.
enum class Kind {
  kSmall,       // integers of a few units: full of ties
  kInteger,     // integers of 16 bits
  kScaled,      // with the common denominator 3 * 2^10
  kFractions,   // without a common denominator of few bits
  kHuge,        // about 1e300
  kTiny,        // about 1e-300
  kTogether,    // all move alike, and points coincide: identically zero
  kDoubleRoots  // in (t - 1)^2: touches
};
constexpr Kind kKinds[] = {Kind::kSmall, Kind::kInteger,  Kind::kScaled,   Kind::kFractions,
                           Kind::kHuge,  Kind::kTiny,     Kind::kTogether, Kind::kDoubleRoots};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  long below(long n) { return static_cast<long>(engine_() % static_cast<std::uint64_t>(n)); }
  Rational number(Kind kind) {
    switch (kind) {
      case Kind::kInteger:
        return Rational(below(1 << 16) - (1 << 15));
      case Kind::kScaled:
        return Rational(Integer(below(1 << 18) - (1 << 17)), Integer(3 * 1024));
      case Kind::kFractions:
        return Rational(Integer(below(2001) - 1000), Integer(1 + below(5000)));
      case Kind::kHuge:
        return Rational(below(2001) - 1000) * test::rational("1e300");
      case Kind::kTiny:
        return Rational(below(2001) - 1000) * test::rational("1e-300");
      default:
        return Rational(below(7) - 3);
    }
  }
  // The motion of one coordinate. Of degrees beyond 5 it is a + b t^degree, which the oracle can
  // do.
  Coefficients motion(Kind kind, int degree) {
    Coefficients c;
    for (int k = 0; k <= degree; ++k) {
      const bool zero = degree > 5 && k > 0 && k < degree;
      c.push_back(zero ? Rational() : number(kind));
    }
    if (kind == Kind::kDoubleRoots && degree >= 2) {
      c = test::times({Rational(1), Rational(-2), Rational(1)},
                      Coefficients(c.begin(), c.end() - 2));
    }
    return c;
  }

 private:
  std::mt19937_64 engine_;
};

// Points in the plane with weights: as many as the predicate takes.
Scene random_scene(Draw& draw, Kind kind, int degree, int objects) {
  std::vector<std::vector<Coefficients>> coordinates;
  const Coefficients common[2] = {draw.motion(kind, degree), draw.motion(kind, degree)};
  for (int i = 0; i < objects; ++i) {
    auto& axes = coordinates.emplace_back();
    for (const Coefficients& shared : common) {
      axes.push_back(kind == Kind::kTogether ? shared : draw.motion(kind, degree));
      if (kind == Kind::kTogether && i % 3 != 0) axes.back()[0] += draw.number(Kind::kSmall);
    }
  }
  Scene scene = test::make_scene(coordinates, Rational(draw.below(3) - 1));
  for (SceneObject& object : scene.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    axes.push_back({draw.below(4) != 0 ? draw.number(kind) : Rational()});
  }
  scene.extents = Extents::kWeight;
  return scene;
}

// The weights stay.
Scene moved(Scene scene, const Rational& scale, const Rational& by) {
  for (SceneObject& object : scene.objects) {
    auto& axes = object.motion.pieces[0].trajectory.coordinates;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (Rational& c : axes[axis]) c *= scale;
      axes[axis][0] += by;
    }
  }
  return scene;
}

// A predicate over the first objects of a scene, in the order of `places`.
struct Case {
  const GeneralPredicate& general;
  const Scene& scene;
  std::vector<int> places;

  Query query(PredicateId id) const {
    Query q;
    q.predicate = id;
    for (const int place : places) q.ids[q.arity++] = static_cast<ObjectId>(place);
    return q;
  }
  RationalOracle oracle(int degree) const {
    const auto value = [this](const Rational& t) {
      std::vector<Place> positions;
      for (const int place : places) {
        const SceneObject& object = scene.objects[static_cast<std::size_t>(place)];
        Place& p = positions.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
          p.push_back(object.motion.pieces[0].trajectory.position(axis, t));
        }
      }
      return general.value(positions);
    };
    return RationalOracle(value, general.predicate->degree(degree));
  }
};

std::vector<int> in_order(int n) {
  std::vector<int> places;
  for (int i = 0; i < n; ++i) places.push_back(i);
  return places;
}

std::unique_ptr<Arithmetic> arithmetic_of(const char* name, const Scene& scene) {
  NumberNeeds needs = needs_of_objects(scene);
  if (scene.extents == Extents::kWeight) needs.add_weights(scene);
  auto arithmetic = make_arithmetic(name, scene, needs);
  for (ObjectId i = 0; i < scene.objects.size(); ++i) {
    arithmetic->set_motion(i, scene.objects[i].motion.pieces[0].trajectory, {});
  }
  arithmetic->set_now(scene.start);
  return arithmetic;
}

using FirstFailure = std::optional<std::pair<Rational, Rational>>;

// Exact answers against the oracle's.
void check_exactly(const Case& c, const RationalOracle& oracle, const FirstFailure& wanted,
                   const char* name, const std::string& text) {
  const auto arithmetic = arithmetic_of(name, c.scene);
  const Query query = c.query(arithmetic->bind(c.general.predicate));
  const Rational& now = c.scene.start;
  ASSERT_EQ(to_int(arithmetic->sign_after(query)), oracle.sign_right_after(now)) << text;
  FailureTime time;
  const Outlook outlook = arithmetic->failure(query, time);
  if (oracle.is_zero()) {
    ASSERT_EQ(outlook, Outlook::kIdenticallyZero) << text;
    return;
  }
  if (!wanted) {
    ASSERT_EQ(outlook, Outlook::kNever) << text;
    return;
  }
  if (wanted->first == wanted->second) {
    ASSERT_EQ(outlook, Outlook::kFailsNow) << text;
    return;
  }
  ASSERT_EQ(outlook, Outlook::kFails) << text;
  // The enclosure holds it: the only root of (lo, hi] is not outside of [time.lo, time.hi].
  if (std::isfinite(time.hi)) {
    const Rational lo = *Rational::from_double(time.lo), hi = *Rational::from_double(time.hi);
    if (lo > wanted->first) {
      ASSERT_EQ(oracle.roots(wanted->first, std::min(lo, wanted->second)), oracle.sign_at(lo) == 0)
          << text;
    }
    ASSERT_GT(hi, wanted->first) << text;
    if (hi < wanted->second) {
      ASSERT_EQ(oracle.roots(wanted->first, hi), 1) << text;
    }
  }
  ASSERT_GE(arithmetic->compare(query, time, wanted->first), 0) << text;
  ASSERT_LE(arithmetic->compare(query, time, wanted->second), 0) << text;
  arithmetic->advance(query, time);
  ASSERT_EQ(arithmetic->sign_after(query), Sign::kNegative) << text;
  if (c.general.negating.empty()) return;
  Query opposite = query;
  for (std::size_t i = 0; i < query.arity; ++i) {
    opposite.ids[i] = query.ids[static_cast<std::size_t>(c.general.negating[i])];
  }
  ASSERT_EQ(arithmetic->sign_after(opposite), Sign::kPositive) << text;
  FailureTime next;
  const Outlook later = arithmetic->failure(opposite, next);
  ASSERT_NE(later, Outlook::kFailsNow) << text;
  if (later == Outlook::kFails) {
    ASSERT_GT(arithmetic->compare(opposite, next, wanted->second), 0) << text;
  }
}

// Inexact ones where the value is far from zero. `times`: no touches, and no times beyond all
// reach.
void check_roughly(const Case& c, const RationalOracle& oracle, const FirstFailure& wanted,
                   bool times, const char* name, const std::string& text) {
  const auto arithmetic = arithmetic_of(name, c.scene);
  const Query query = c.query(arithmetic->bind(c.general.predicate));
  const Rational& now = c.scene.start;
  // The value relative to the sum of the absolute values of its terms in t.
  Rational value, sum, power(1);
  for (const Rational& k : oracle.coefficients()) {
    const Rational term = k * power;
    value += term;
    sum += term.sign() < 0 ? -term : term;
    power *= now;
  }
  const double relative = sum.is_zero() ? 0 : std::fabs((value / sum).to_double());
  const Sign sign = arithmetic->sign_after(query);
  FailureTime time;
  const Outlook outlook = arithmetic->failure(query, time);
  if (relative < 1e-3) return;
  ASSERT_EQ(to_int(sign), oracle.sign_right_after(now)) << text;
  if (wanted && wanted->first == wanted->second) {
    ASSERT_EQ(outlook, Outlook::kFailsNow) << text;
  } else if (!times || arithmetic->precision() < 300) {
    return;
  } else if (wanted) {
    ASSERT_EQ(outlook, Outlook::kFails) << text;
    ASSERT_GE(time.hi, wanted->first.lower_double()) << text;
    ASSERT_LE(time.lo, wanted->second.upper_double()) << text;
  } else {
    ASSERT_EQ(outlook, Outlook::kNever) << text;
  }
}

bool in_range_of_doubles(Kind kind, const Predicate& predicate) {
  return (kind != Kind::kHuge && kind != Kind::kTiny) || predicate.degree(1) <= 1;
}

class GeneralPredicates : public ::testing::TestWithParam<std::size_t> {};

TEST_P(GeneralPredicates, AgreeWithTheirValuesInEveryArithmetic) {
  const GeneralPredicate general = test::general_predicates()[GetParam()];
  const Predicate& predicate = *general.predicate;
  Draw draw(GetParam() + 11);
  int failing = 0, zero = 0;
  for (const int degree : {1, 2, 3, 5}) {
    for (const Kind kind : kKinds) {
      const bool extreme = kind == Kind::kHuge || kind == Kind::kTiny;
      for (int round = 0; round < (degree == 5 || extreme ? 1 : test::kSanitized ? 2 : 5); ++round) {
        const Scene scene = random_scene(draw, kind, degree, predicate.arity());
        const Case c{general, scene, in_order(predicate.arity())};
        const RationalOracle oracle = c.oracle(degree);
        zero += oracle.is_zero();
        const FirstFailure wanted = oracle.first_failure(scene.start);
        failing += wanted.has_value();
        const bool times = kind == Kind::kInteger || kind == Kind::kScaled || kind == Kind::kFractions;
        for (const char* name : kArithmetics) {
          const std::string text = std::string(name) + " " + std::string(predicate.name()) +
                                   " degree " + std::to_string(degree) + " kind " +
                                   std::to_string(static_cast<int>(kind)) + " round " +
                                   std::to_string(round);
          const std::string_view exact = name;
          if (exact == "exact" || exact == "sturm") {
            check_exactly(c, oracle, wanted, name, text);
          } else if (exact == "mpfr:300" || in_range_of_doubles(kind, predicate)) {
            check_roughly(c, oracle, wanted, times, name, text);
          }
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(failing, test::kSanitized ? 8 : 20);
  if (predicate.name() != "within_five" && predicate.name() != "moment") {
    EXPECT_GT(zero, test::kSanitized ? -1 : 0);
  }
}

// Beyond what arrays of fixed size hold, and beyond the degrees of the filter: 20 to 120.
TEST_P(GeneralPredicates, OfMotionsOfDegreeTwenty) {
  const GeneralPredicate general = test::general_predicates()[GetParam()];
  const Predicate& predicate = *general.predicate;
  Draw draw(GetParam() + 5);
  for (const Kind kind : {Kind::kSmall, Kind::kScaled, Kind::kTogether}) {
    const Scene scene = random_scene(draw, kind, 20, predicate.arity());
    const Case c{general, scene, in_order(predicate.arity())};
    const RationalOracle oracle = c.oracle(20);
    const FirstFailure wanted = oracle.first_failure(scene.start);
    for (const char* name : kArithmetics) {
      const std::string text =
          std::string(name) + " kind " + std::to_string(static_cast<int>(kind));
      if (std::string_view(name) == "exact" || std::string_view(name) == "sturm") {
        check_exactly(c, oracle, wanted, name, text);
      } else {
        check_roughly(c, oracle, wanted, false, name, text);
      }
      if (HasFatalFailure()) return;
    }
  }
}

// Moving and scaling a scene changes no time; scaling needs the weights' square.
TEST_P(GeneralPredicates, DoNotDependOnOriginAndUnit) {
  const GeneralPredicate general = test::general_predicates()[GetParam()];
  const Predicate& predicate = *general.predicate;
  const bool homogeneous = !predicate.has_unit() || predicate.name() == "power";
  Draw draw(GetParam() + 2);
  for (const Kind kind : {Kind::kSmall, Kind::kInteger, Kind::kScaled, Kind::kFractions}) {
    for (int round = 0; round < 10; ++round) {
      const int degree = 1 + round % 3;
      const Scene scene = random_scene(draw, kind, degree, predicate.arity());
      std::vector<Scene> variants;
      if (general.translates) {
        for (const Rational& by : {Rational(1000003), test::rational("1/7"), test::rational("1e30")}) {
          variants.push_back(moved(scene, Rational(1), by));
        }
      }
      for (const Rational& scale : {Rational(3), test::rational("1/1024"), test::rational("5/7")}) {
        if (!homogeneous) break;
        variants.push_back(moved(scene, scale, Rational()));
        for (SceneObject& object : variants.back().objects) {
          object.motion.pieces[0].trajectory.coordinates[2][0] *= scale * scale;
        }
      }
      const auto first = arithmetic_of("sturm", scene);
      const Query query = Case{general, scene, in_order(predicate.arity())}.query(
          first->bind(general.predicate));
      FailureTime time;
      const Outlook outlook = first->failure(query, time);
      if (outlook == Outlook::kFails) first->advance(query, time);
      for (const Scene& variant : variants) {
        const auto other = arithmetic_of("exact", variant);
        other->bind(general.predicate);
        FailureTime same;
        ASSERT_EQ(other->failure(query, same), outlook);
        if (outlook != Outlook::kFails) continue;
        other->advance(query, same);
        ASSERT_EQ(other->describe_now().lower, first->describe_now().lower);
        ASSERT_EQ(other->describe_now().upper, first->describe_now().upper);
      }
    }
  }
}

// Two certificates of a scene and its mirror image fail at one instant, whatever answered.
TEST_P(GeneralPredicates, CoincidingFailuresAreEqual) {
  const GeneralPredicate general = test::general_predicates()[GetParam()];
  const int arity = general.predicate->arity();
  Draw draw(GetParam() + 3);
  int equal = 0;
  for (int round = 0; round < 60; ++round) {
    const Kind kind = kKinds[static_cast<std::size_t>(round) % 4];
    const int degree = 1 + round % 3;
    Scene scene = random_scene(draw, kind, degree, arity);
    Scene twins = scene;
    const Rational shift(1 + draw.below(3));
    for (SceneObject twin : scene.objects) {
      twin.id += "'";
      auto& axes = twin.motion.pieces[0].trajectory.coordinates;
      if (general.translates) axes[0][0] += shift;
      twins.objects.push_back(twin);
    }
    std::vector<int> second;
    for (int i = 0; i < arity; ++i) second.push_back(arity + i);
    for (const char* name : {"exact", "sturm"}) {
      const auto arithmetic = arithmetic_of(name, twins);
      const PredicateId id = arithmetic->bind(general.predicate);
      const Query a = Case{general, twins, in_order(arity)}.query(id);
      const Query b = Case{general, twins, second}.query(id);
      FailureTime ta, tb;
      const Outlook outlook = arithmetic->failure(a, ta);
      ASSERT_EQ(arithmetic->failure(b, tb), outlook);
      if (outlook != Outlook::kFails) continue;
      ++equal;
      ASSERT_EQ(arithmetic->compare(a, ta, b, tb), 0) << name << " round " << round;
      ASSERT_EQ(arithmetic->compare(b, tb, a, ta), 0);
      arithmetic->advance(a, ta);
      ASSERT_EQ(arithmetic->compare_with_now(b, tb), 0);
      ASSERT_EQ(arithmetic->sign_after(b), Sign::kNegative);
    }
  }
  EXPECT_GT(equal, 20);
}

INSTANTIATE_TEST_SUITE_P(All, GeneralPredicates,
                         ::testing::Range(std::size_t{0}, test::general_predicates().size()),
                         [](const auto& one) {
                           return std::string(
                               test::general_predicates()[one.param].predicate->name());
                         });

TEST(GeneralPredicate, IsRefusedWithoutRoom) {
  Draw draw(1);
  Scene scene = random_scene(draw, Kind::kSmall, 1, 4);
  scene.extents = Extents::kNone;
  for (SceneObject& object : scene.objects) {
    object.motion.pieces[0].trajectory.coordinates.resize(2);
  }
  for (const char* name : kArithmetics) {
    const auto arithmetic = make_arithmetic(name, scene);
    try {
      arithmetic->bind(test::make_predicate<test::Power>());
      ADD_FAILURE() << name << " has two axes";
    } catch (const std::logic_error& error) {
      EXPECT_EQ(std::string(error.what()),
                "predicate power reads 3 axes, objects have 2: its structure has to declare what it "
                "derives");
    }
  }
}

}  // namespace general_predicates_test
}  // namespace kinex
