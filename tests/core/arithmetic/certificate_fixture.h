// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the tests of arithmetics: predicates, scenes, polynomials with chosen roots and
// certificates on them.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_CERTIFICATE_FIXTURE_H
#define KINEX_TESTS_CORE_ARITHMETIC_CERTIFICATE_FIXTURE_H

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic/arithmetic.h"
#include "core/arithmetic/predicate_formula.h"
#include "core/motion/scene.h"

namespace kinex::test {

struct Order {
  static constexpr int kArity = 2, kDegree = 1, kAlternating = 2, kReference = 0;
  static constexpr bool kOnlyToReference = true;
  std::string_view name() const { return "order"; }
  int dimension() const { return 1; }
  template <class Points>
  auto value(const Points& p) const {
    return widen(p(1, 0) - p(0, 0));
  }
};

struct DistanceOrder {
  static constexpr int kArity = 3, kDegree = 2, kAlternating = 2, kReference = 2;
  static constexpr bool kOnlyToReference = false;
  std::string_view name() const { return "distance_order"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto term = [&p](int axis) {
      return wide_product(p(1, axis) - p(0, axis),
                          (p(1, axis) - p(2, axis)) + (p(0, axis) - p(2, axis)));
    };
    return term(0) + term(1);
  }
};

struct Orientation {
  static constexpr int kArity = 3, kDegree = 2, kAlternating = 3, kReference = 0;
  static constexpr bool kOnlyToReference = true;
  std::string_view name() const { return "orientation"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    return wide_product(p(1, 0) - p(0, 0), p(2, 1) - p(0, 1)) -
           wide_product(p(1, 1) - p(0, 1), p(2, 0) - p(0, 0));
  }
};

struct InCircle {
  static constexpr int kArity = 4, kDegree = 4, kAlternating = 4, kReference = 3;
  static constexpr bool kOnlyToReference = true;
  std::string_view name() const { return "in_circle"; }
  int dimension() const { return 2; }
  template <class Points>
  auto value(const Points& p) const {
    const auto side = [&p](int i, int axis) { return p(i, axis) - p(3, axis); };
    const auto square = [&](int i) { return side(i, 0) * side(i, 0) + side(i, 1) * side(i, 1); };
    const auto cross = [&](int i, int j) {
      return side(i, 0) * side(j, 1) - side(i, 1) * side(j, 0);
    };
    return wide_product(square(0), cross(1, 2)) + wide_product(square(1), cross(2, 0)) +
           wide_product(square(2), cross(0, 1));
  }
};

template <class Formula>
std::shared_ptr<const Predicate> make_predicate() {
  return std::make_shared<FormulaPredicate<Formula>>();
}

using Coefficients = std::vector<Rational>;  // low degree first

inline Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

// factor * product of (t - root).
inline Coefficients with_roots(const std::vector<Rational>& roots, Coefficients factor) {
  for (const Rational& root : roots) factor = times(factor, {-root, Rational(1)});
  return factor;
}

inline Rational rational(std::string_view text) { return *Rational::parse(text); }

// One piece per object, from the start without end; coordinates[object][axis].
inline Scene make_scene(const std::vector<std::vector<Coefficients>>& coordinates,
                        const Rational& start) {
  Scene scene;
  scene.name = "test";
  scene.dimension = static_cast<int>(coordinates.front().size());
  scene.start = start;
  for (const auto& axes : coordinates) {
    SceneObject object;
    object.id = std::to_string(scene.objects.size());
    MotionPiece piece;
    piece.trajectory.coordinates = axes;
    piece.trajectory.normalise();
    object.motion.pieces.push_back(std::move(piece));
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

// Objects on a line, one for each polynomial, and a last one at rest at 0. Any polynomial can thus
// be a certificate: order(last, i) is the track of i.
inline Scene make_track_scene(const std::vector<Coefficients>& tracks, const Rational& start) {
  std::vector<std::vector<Coefficients>> coordinates;
  for (const Coefficients& track : tracks) coordinates.push_back({track});
  coordinates.push_back({{Rational(0)}});
  return make_scene(coordinates, start);
}

// Sets the motions of a scene made above.
inline void set_motions(const Scene& scene, Arithmetic& arithmetic) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const MotionPiece& piece = scene.objects[i].motion.pieces.front();
    arithmetic.set_motion(static_cast<ObjectId>(i), piece.trajectory, piece.to);
  }
  arithmetic.set_now(scene.start);
}

// A few polynomials.
inline const Coefficients kPlus{Rational(1)};
inline const Coefficients kMinus{Rational(-1)};
// t^2 + t + 1: no real root.
inline const Coefficients kRootless{Rational(1), Rational(1), Rational(1)};
inline const Coefficients kTwo{Rational(-2), Rational(0), Rational(1)};       // t^2 - 2
inline const Coefficients kMinusTwo{Rational(2), Rational(0), Rational(-1)};  // 2 - t^2

// Certificates "track(i) >= 0" for given polynomials, in the arithmetic of the given name.
class Tracks {
 public:
  Tracks(const std::string& name, std::vector<Coefficients> tracks, const Rational& now,
         std::optional<Rational> end = std::nullopt)
      : scene_(make_track_scene(tracks, now)), zero_(static_cast<ObjectId>(tracks.size())) {
    scene_.end = end;
    arithmetic_ = make_arithmetic(name, scene_);
    predicate_ = arithmetic_->bind(make_predicate<Order>());
    set_motions(scene_, *arithmetic_);
  }
  Query query(ObjectId i) const { return Query(predicate_, {zero_, i}); }
  Outlook failure(ObjectId i, FailureTime& time) { return arithmetic_->failure(query(i), time); }
  Outlook failure(ObjectId i) {
    FailureTime time;
    const Outlook outlook = failure(i, time);
    arithmetic_->release(time);
    return outlook;
  }
  Sign sign(ObjectId i) { return arithmetic_->sign_after(query(i)); }
  // True if the certificate fails exactly at t.
  bool fails_at(ObjectId i, const Rational& t) {
    FailureTime time;
    if (failure(i, time) != Outlook::kFails) return false;
    const bool equal = arithmetic_->compare(query(i), time, t) == 0;
    EXPECT_LE(time.lo, t.upper_double());
    EXPECT_GE(time.hi, t.lower_double());
    arithmetic_->release(time);
    return equal;
  }
  int order(ObjectId i, ObjectId j) {
    FailureTime a, b;
    EXPECT_EQ(failure(i, a), Outlook::kFails);
    EXPECT_EQ(failure(j, b), Outlook::kFails);
    const int forth = arithmetic_->compare(query(i), a, query(j), b);
    EXPECT_EQ(arithmetic_->compare(query(j), b, query(i), a), -forth);
    arithmetic_->release(a);
    arithmetic_->release(b);
    return forth;
  }
  void advance(ObjectId i) {
    FailureTime time;
    const Outlook outlook = failure(i, time);
    ASSERT_TRUE(outlook == Outlook::kFails || outlook == Outlook::kFailsNow);
    arithmetic_->advance(query(i), time);
    ASSERT_EQ(time.root, 0u);
  }
  Arithmetic& operator*() { return *arithmetic_; }
  Arithmetic* operator->() { return arithmetic_.get(); }

 private:
  Scene scene_;
  ObjectId zero_;
  std::unique_ptr<Arithmetic> arithmetic_;
  PredicateId predicate_ = 0;
};

}  // namespace kinex::test

#endif
