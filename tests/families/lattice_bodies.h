// SPDX-License-Identifier: GPL-3.0-or-later
// Small rigid polygons with integer vertices, for the families.
#ifndef KINEX_TESTS_FAMILIES_LATTICE_BODIES_H
#define KINEX_TESTS_FAMILIES_LATTICE_BODIES_H

#include <vector>

#include "tests/families/scene_text.h"

namespace kinex::families {

// A square, a triangle, a diamond or a sliver, within one unit of its frame's origin.
inline std::vector<Coefficients> lattice_polygon(Random& random) {
  static const std::vector<std::vector<Coefficients>> kPolygons{
      {{"-1", "-1"}, {"1", "-1"}, {"1", "1"}, {"-1", "1"}},
      {{"0", "0"}, {"1", "0"}, {"0", "1"}},
      {{"1", "0"}, {"0", "1"}, {"-1", "0"}, {"0", "-1"}},
      {{"-1", "0"}, {"1", "0"}, {"0", "1/8"}},
  };
  return random.pick(kPolygons);
}

// At rest in one of some positions, or turning by up to half a turn in one unit of time.
inline std::vector<Coefficients> lattice_rotor(Random& random) {
  static const std::vector<std::vector<Coefficients>> kRotors{
      {{"1"}, {"1"}}, {{"0"}, {"1"}}, {{"2"}, {"1"}}, {{"1"}, {"0", "1"}}, {{"1"}, {"0", "-1/4"}}};
  return random.pick(kRotors);
}

// Every integer coefficient times `factor`.
inline void list_scale(std::vector<Coefficients>& lists, int factor) {
  for (Coefficients& list : lists) {
    for (std::string& c : list) c = std::to_string(std::stoi(c) * factor);
  }
}

}  // namespace kinex::families

#endif
