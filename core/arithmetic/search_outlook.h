// SPDX-License-Identifier: GPL-3.0-or-later
// What a filtered search for the first root (core/numbers/first_root.h) says about a certificate.
#ifndef KINEX_CORE_ARITHMETIC_SEARCH_OUTLOOK_H
#define KINEX_CORE_ARITHMETIC_SEARCH_OUTLOOK_H

#include <array>
#include <limits>
#include <optional>

#include "core/arithmetic/arithmetic.h"
#include "core/numbers/first_root.h"

namespace kinex {

// The answer of a search up to the lesser of `limit` and `end`, where the certificate ends; sets `time`.
// nullopt: the search has not decided, and `time` is as before.
inline std::optional<Outlook> outlook_of(filter::Search search, const filter::Enclosure& root,
                                         double limit, double end, FailureTime& time) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (search) {
    case filter::Search::kFound:
      time = {root.lo, root.hi, 0};
      return Outlook::kFails;
    case filter::Search::kNone:
      if (limit < end) {
        time = {limit, limit, 0};
        return Outlook::kLater;
      }
      time = {kInfinity, kInfinity, 0};
      return Outlook::kNever;
    case filter::Search::kUnknown:
      break;
  }
  return std::nullopt;
}

// The search from its first node [from, end], whose coefficients are known up to `error` (negative: no
// bound is known). All but the first, which the caller has judged, are looked at before it begins.
template <int D>
[[gnu::always_inline]] inline filter::Search search_from(const filter::FirstRoot<D, true>& search,
                                                         double from, double end,
                                                         std::array<double, D + 1>& bernstein,
                                                         double error, filter::Enclosure& root) {
  bool clear = error >= 0;
  for (int i = 1; i <= D; ++i) clear = clear && bernstein[i] > error;
  return clear ? filter::Search::kNone : search.from_first_node(from, end, bernstein, error, root);
}

}  // namespace kinex

#endif
