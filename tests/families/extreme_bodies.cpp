// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies with numbers of 1e+-300 and beyond in every field: times, polygons, motions, rotors.
// Each field has an exponent of its own, or all are ordinary but one.
#include "tests/families/check_scene.h"
#include "tests/families/scene_text.h"

namespace kinex::families {
namespace {

// Exponents of ten, around the ends of binary64 and beyond them.
int extreme(Random& random) {
  static const std::vector<int> kExponents{0,    0,   0,    1,   -1,   16,   -16,  150,
                                           -150, 299, -299, 307, -307, 309,  -309, 320,
                                           -320, 324, -324, 400, -400, 1000, -1000};
  return random.pick(kExponents);
}

std::string number(int mantissa, int exponent) {
  return std::to_string(mantissa) + (exponent == 0 ? "" : "e" + std::to_string(exponent));
}

// 1 + 10^-exponent, exactly.
std::string nearly_one(int exponent) {
  const std::string zeros(static_cast<std::size_t>(exponent) - 1, '0');
  return "1" + zeros + "1/1" + zeros + "0";
}

// A triangle or square of this size; or one whose corners are off a unit square by very little.
std::vector<Coefficients> polygon(Random& random, int exponent) {
  if (random.chance(10)) {
    const std::string near = nearly_one(random.pick(std::vector<int>{16, 150, 309, 325}));
    return {{"0", "0"}, {near, "0"}, {"1", near}, {"0", "1"}};
  }
  const std::string a = number(1, exponent), b = number(-1, exponent);
  if (random.chance(30)) return {{b, b}, {a, b}, {a, number(3, exponent)}};
  return {{b, b}, {a, b}, {a, a}, {b, a}};
}

std::vector<Coefficients> rotor(Random& random, int exponent) {
  if (random.chance(40)) return {};
  const std::string turn = number(random.between(-3, 3), exponent);
  if (random.chance(30)) return {{number(1, exponent)}, {number(2, exponent)}};
  return {{"1"}, {"0", turn}};
}

}  // namespace

void extreme_bodies(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const int n = random.between(2, 3);
  const bool one_field = random.chance(50);
  const int field = random.between(0, 4);
  // Sizes and distances go together half of the time: otherwise most scenes have no events.
  const int unit = one_field && field != 0 ? 0 : extreme(random);
  const auto exponent = [&](int f) { return one_field && f != field ? unit : extreme(random); };
  std::vector<ObjectText> objects;
  for (int i = 0; i < n; ++i) {
    ObjectText object;
    PieceText piece;
    const int size = random.chance(70) ? unit : exponent(1);
    object.polygon = polygon(random, size);
    for (int axis = 0; axis < 2; ++axis) {
      const int place = random.chance(70) ? unit : exponent(2);
      const int speed = random.chance(60) ? unit : exponent(3);
      piece.coordinates.push_back(
          {number(random.between(-9, 9), place), number(random.between(-9, 9), speed)});
      if (random.chance(20)) {
        piece.coordinates.back().push_back(number(random.between(-3, 3), exponent(3)));
      }
    }
    piece.rotor = rotor(random, one_field && field != 4 ? 0 : extreme(random));
    object.pieces.push_back(std::move(piece));
    objects.push_back(std::move(object));
  }
  std::string start = "0", end = "2";
  if (random.chance(30)) start = number(-1, extreme(random));
  if (random.chance(30)) end = number(3, extreme(random));
  if (random.chance(10)) end.clear();
  SceneCheck what;
  what.arithmetics = {"double", "gsl", "mpfr:100"};
  // The reference takes a second for a scene and more: beyond the first hundred it has every 200th.
  if (seed <= 100 || seed % 200 == 0) what.arithmetics.insert(what.arithmetics.begin(), "sturm");
  check_scene(scene_text(2, start, end, objects), what, tally);
}

}  // namespace kinex::families
