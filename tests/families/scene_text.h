// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers, and scenes as text, for the families.
#ifndef KINEX_TESTS_FAMILIES_SCENE_TEXT_H
#define KINEX_TESTS_FAMILIES_SCENE_TEXT_H

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace kinex::families {

// The engine is specified bit by bit; so is this.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // Uniform in lo .. hi (to within 2^-32).
  int between(int lo, int hi) {
    return lo + static_cast<int>(engine_() % static_cast<std::uint64_t>(hi - lo + 1));
  }
  bool chance(int percent) { return between(0, 99) < percent; }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[static_cast<std::size_t>(between(0, static_cast<int>(from.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

// ["1", "-2"]: one coefficient list, low degree first.
using Coefficients = std::vector<std::string>;
std::string list_text(const Coefficients& coefficients);
// One list per axis.
std::string lists_text(const std::vector<Coefficients>& lists);

struct PieceText {
  std::string from, to;  // empty: not written
  std::vector<Coefficients> coordinates;
  std::vector<Coefficients> rotor;  // empty: not written
};
struct ObjectText {
  std::vector<PieceText> pieces;
  std::vector<Coefficients> polygon;  // vertices; empty: a point
};
// A scene as JSON, objects "o0", "o1", ..; `end` empty: without end. `more` is put in as it is.
std::string scene_text(int dimension, const std::string& start, const std::string& end,
                       const std::vector<ObjectText>& objects, const std::string& more = "");

}  // namespace kinex::families

#endif
