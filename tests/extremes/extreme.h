// SPDX-License-Identifier: GPL-3.0-or-later
// The corpus of extremes, tests/corpus/extremes. The format of its index is described in make.py
// there.
#ifndef KINEX_TESTS_EXTREMES_EXTREME_H
#define KINEX_TESTS_EXTREMES_EXTREME_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/polynomial.h"
#include "core/numbers/real_root.h"

namespace kinex::extremes {

// A real number, known exactly or to lie in an open interval.
struct Place {
  std::string text;  // as the index has it
  std::optional<Rational> rational;
  std::optional<RealRoot> root;
  Rational lower, upper;  // otherwise
};

// Throws std::runtime_error for text that is no place.
Place parse_place(const std::string& text);
// Whether `root` is that number. Rational numbers are put into the polynomial; algebraic ones are
// compared as roots of two polynomials.
bool is_at(RealRoot& root, Place& place);

struct Extreme {
  std::string name;
  std::string source;                   // why the answer is known
  std::string file, polynomial, crowd;  // one of them; files with their folders
  Rational start, end;                  // of a polynomial's scene
  std::optional<std::vector<std::pair<Place, std::size_t>>> instants;  // with their events
  std::size_t events = 0;                                              // in all, if known
  bool events_known = false;
  std::vector<std::pair<Place, int>> roots;  // of a polynomial, with multiplicities
  std::string final_state;                   // "", "start", "exchanged", or "list"
  std::vector<std::string> final_list;
  bool sturm = true;
  bool page = true;  // on the page of verdicts; larger scenes are not

  Scene scene() const;
};

// The folder, and everything that its index lists. Throws for an index that cannot be read.
std::string corpus_folder();
std::vector<Extreme> read_extremes();
// The only polynomial of a file, up to a positive factor.
Polynomial read_polynomial(const Extreme& extreme);

}  // namespace kinex::extremes

#endif
