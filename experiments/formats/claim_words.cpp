// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/claim_words.h"

#include <string_view>
#include <utility>

namespace kinex::formats {

namespace {

// Of points (a, b) and, in the same words, of lines y = a x + b.
constexpr std::pair<std::string_view, std::string_view> kOfLines[] = {
    {"order_x", "the slope of {0} is at most that of {1}"},
    {"order_y", "{0} is not above {1} at x = 0"},
    {"orientation_2",
     "{2} is not below the crossing of {0} and {1}, if {0} has the smaller slope, and not above it "
     "otherwise"},
    {"slope_order_2",
     "the crossing of {2} and {3} is not to the right of that of {0} and {1}, if slopes grow from "
     "{0} to {1} and from {2} "
     "to {3}"},
};

}  // namespace

ClaimForm claim_form(const Predicate& predicate, const Scene& scene) {
  ClaimForm form = predicate.form();
  if (!scene.has_lines()) return form;
  for (const auto& [name, words] : kOfLines) {
    if (predicate.name() == name) form.says = words;
  }
  return form;
}

}  // namespace kinex::formats
