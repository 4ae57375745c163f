// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of two lengths, known as such or by their formula alone, and scenes of points that are hard for
// them.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_LENGTH_FIXTURE_H
#define KINEX_TESTS_CORE_ARITHMETIC_LENGTH_FIXTURE_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/arithmetic/length_order.h"
#include "tests/core/arithmetic/difference_fixture.h"

namespace kinex::test {

// |p1 - p2|^2 - |p0 - p2|^2, or |p3 - p2|^2 - |p1 - p0|^2.
template <int Dimension, bool kShared>
struct Lengths {
  static constexpr int kArity = kShared ? 3 : 4, kDegree = 2, kAlternating = kShared ? 2 : 0;
  static constexpr bool kAlternatesInHalves = !kShared;
  static constexpr int kReference = kShared ? 2 : 0;
  static constexpr bool kOnlyToReference = false;
  static constexpr LengthEnds kEnds = kShared ? LengthEnds{2, 0, 2, 1} : LengthEnds{0, 1, 2, 3};
  std::string_view name() const { return "lengths"; }
  int dimension() const { return Dimension; }
  template <class Points>
  auto value(const Points& p) const {
    const auto term = [&p](int axis) {
      const auto u = p(kEnds.longer_to, axis) - p(kEnds.longer_from, axis);
      const auto v = p(kEnds.shorter_to, axis) - p(kEnds.shorter_from, axis);
      return wide_product(u - v, u + v);
    };
    if constexpr (Dimension == 1) {
      return term(0);
    } else if constexpr (Dimension == 2) {
      return term(0) + term(1);
    } else {
      return term(0) + term(1) + term(2);
    }
  }
};

// Counts how often the general path evaluates the formula: not at all where a path of its own answers.
template <class Formula>
class CountedFormula : public FormulaPredicate<Formula> {
 public:
  explicit CountedFormula(int& count) : count_(count) {}
  bool alternates_in_halves() const override { return Formula::kAlternatesInHalves; }
  void plain_with_reach(int d, const MotionView<double>* points, double shift, double* out,
                        double* reach) const override {
    ++count_;
    FormulaPredicate<Formula>::plain_with_reach(d, points, shift, out, reach);
  }

 private:
  int& count_;
};

template <class Formula>
class KnownLengths final : public CountedFormula<Formula>, public LengthOrder {
 public:
  using CountedFormula<Formula>::CountedFormula;
  LengthEnds length_ends() const override { return Formula::kEnds; }
};

template <int Dimension>
std::shared_ptr<const Predicate> make_lengths(bool shared, bool known, int& count) {
  using Shared = Lengths<Dimension, true>;
  using Apart = Lengths<Dimension, false>;
  if (shared) {
    if (known) return std::make_shared<KnownLengths<Shared>>(count);
    return std::make_shared<CountedFormula<Shared>>(count);
  }
  if (known) return std::make_shared<KnownLengths<Apart>>(count);
  return std::make_shared<CountedFormula<Apart>>(count);
}
inline std::shared_ptr<const Predicate> make_lengths(int dimension, bool shared, bool known,
                                                     int& count) {
  switch (dimension) {
    case 1:
      return make_lengths<1>(shared, known, count);
    case 2:
      return make_lengths<2>(shared, known, count);
    case 3:
      return make_lengths<3>(shared, known, count);
    default:
      throw std::logic_error("1 to 3 axes");
  }
}

inline constexpr int kPoints = 7;

// Points whose lengths are alike at times, or always: copies, mirror images, equal velocities, points
// that touch.
inline Scene draw_points(std::mt19937_64& random, Numbers numbers, int degree, int dimension) {
  std::vector<std::vector<Coefficients>> p(kPoints);
  for (auto& point : p) {
    for (int axis = 0; axis < dimension; ++axis) {
      Coefficients c;
      for (int k = 0; k <= degree; ++k) c.push_back(draw(random, numbers));
      point.push_back(std::move(c));
    }
  }
  const auto axes = static_cast<std::size_t>(dimension);
  if (random() % 3 == 0) p[3] = p[2];
  if (random() % 3 == 0) {  // the mirror image of 1 in 0
    for (std::size_t a = 0; a < axes; ++a) {
      for (std::size_t k = 0; k < p[1][a].size(); ++k)
        p[4][a][k] = Rational(2) * p[0][a][k] - p[1][a][k];
    }
  }
  if (random() % 3 == 0) {  // all but the last move alike
    for (int i = 1; i + 1 < kPoints; ++i) {
      for (std::size_t a = 0; a < axes; ++a) {
        for (std::size_t k = 1; k < p[0][a].size(); ++k)
          p[static_cast<std::size_t>(i)][a][k] = p[0][a][k];
      }
    }
  }
  if (random() % 3 == 0) {  // 5 meets 0 at a time of few bits, and is close to it elsewhere
    const Rational r = Rational(static_cast<int>(random() % 16)) / Rational(4);
    p[5] = p[0];
    const std::size_t axis = random() % axes;
    p[5][axis][0] -= r;
    p[5][axis][1] += Rational(1);
  }
  if (random() % 4 == 0) {  // rest
    for (auto& c : p[6]) {
      for (std::size_t k = 1; k < c.size(); ++k) c[k] = Rational(0);
    }
  }
  static const std::vector<Rational> kStarts{Rational(0), rational("1/3"), Rational(-2),
                                             rational("-5/7"), rational("1000/3")};
  const Rational start = kStarts[random() % kStarts.size()];
  Scene scene = make_scene(p, start);
  if (random() % 4 != 0) scene.end = start + Rational(6);
  if (random() % 3 == 0) scene.objects[4].motion.pieces[0].to = start + Rational(2);
  return scene;
}

}  // namespace kinex::test

#endif
