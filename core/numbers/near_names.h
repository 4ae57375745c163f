// SPDX-License-Identifier: GPL-3.0-or-later
// "Did you mean": the known names that are most like a name that is not known.
#ifndef KINEX_CORE_NUMBERS_NEAR_NAMES_H
#define KINEX_CORE_NUMBERS_NEAR_NAMES_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kinex {

// The edit distance: the fewest insertions, deletions, substitutions and swaps of neighbouring letters
// that turn one name into the other. Case is ignored, and '-' is '_'. O(length^2).
std::size_t name_distance(std::string_view a, std::string_view b);

// At most three of `known`, the nearest first: those at the smallest distance if that is at most a
// third of the length of `name` (1 at least), else those of which it is a part of four letters or more,
// or a beginning of three or more.
std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& known);

// The remedy for an unknown name: "did you mean a or b?", or `otherwise` where nothing is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                         const std::string& otherwise);

}  // namespace kinex

#endif
