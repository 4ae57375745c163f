// SPDX-License-Identifier: GPL-3.0-or-later
// An order that is known as a difference of coordinates, and scenes of motions that are hard for it.
#ifndef KINEX_TESTS_CORE_ARITHMETIC_DIFFERENCE_FIXTURE_H
#define KINEX_TESTS_CORE_ARITHMETIC_DIFFERENCE_FIXTURE_H

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "core/arithmetic/coordinate_difference.h"
#include "tests/core/arithmetic/certificate_fixture.h"

namespace kinex::test {

class KnownDifference final : public FormulaPredicate<Order>, public CoordinateDifference {
 public:
  int difference_axis() const override { return 0; }
};

enum class Numbers { kDegenerate, kRandom, kExtreme, kWide, kDoubles, kMixed, kAnySize };
inline constexpr int kNumbers = 7;

// Of few bits, so that roots coincide, are double, or are now; of up to 60; or 53 at very different sizes,
// down to those below all doubles.
inline Rational draw(std::mt19937_64& random, Numbers numbers) {
  const auto bits = [&](unsigned n) {
    return Rational(Integer(static_cast<std::int64_t>(random() >> (64 - n)) - (std::int64_t{1} << (n - 1))));
  };
  switch (numbers) {
    case Numbers::kDegenerate: return bits(3);
    case Numbers::kRandom: return bits(20);
    case Numbers::kExtreme: return bits(random() % 3 == 0 ? 44 : 8);
    case Numbers::kDoubles: {
      const Rational size(Integer::power_of_two(random() % 90));
      return bits(54) * size / Rational(Integer::power_of_two(80));
    }
    case Numbers::kAnySize: {
      const Rational size(Integer::power_of_two(random() % 2200));
      return bits(54) * size / Rational(Integer::power_of_two(1200));
    }
    case Numbers::kMixed: return random() % 2 == 0 ? bits(60) : bits(3);
    default: return bits(60);
  }
}

inline Scene draw_scene(std::mt19937_64& random, Numbers numbers, int degree) {
  constexpr int kObjects = 6;
  std::vector<std::vector<Coefficients>> coordinates;
  for (int i = 0; i < kObjects; ++i) {
    Coefficients c;
    for (int k = 0; k <= degree; ++k) c.push_back(draw(random, numbers));
    coordinates.push_back({c});
  }
  if (random() % 2 == 0) coordinates[1][0][static_cast<std::size_t>(degree)] = coordinates[0][0].back();
  if (random() % 4 == 0) coordinates[3] = coordinates[2];
  // Differences below the rounding of their terms.
  if (random() % 2 == 0) {
    coordinates[5] = coordinates[2];
    for (Rational& c : coordinates[5][0]) c += Rational(static_cast<int>(random() % 3) - 1);
  }
  // Two roots close together: objects 0 and 1 meet at r and at r + 2^-k.
  if (degree > 1 && random() % 2 == 0) {
    const Rational a(static_cast<int>(random() % 7) - 3), r = Rational(static_cast<int>(random() % 64)) / Rational(16);
    const Rational s = r + Rational(1) / Rational(Integer::power_of_two(random() % 64));
    coordinates[1] = coordinates[0];
    coordinates[1][0][0] += a * r * s;
    coordinates[1][0][1] -= a * (r + s);
    coordinates[1][0][2] += a;
  }
  Scene scene = make_scene(coordinates, Rational(static_cast<int>(random() % 5) - 2) / Rational(3));
  scene.end = Rational(6);
  if (random() % 3 == 0) scene.objects[4].motion.pieces[0].to = Rational(2);
  return scene;
}

}  // namespace kinex::test

#endif
