// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/lab/binary_scale.h"

namespace kinex::trade {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The largest table for the assignment: beyond it events are matched in order only.
constexpr std::size_t kMostSteps = 4000000;
constexpr int kErrorBits = 20;

using Places = std::vector<std::size_t>;

std::vector<Places> places_of(const std::vector<std::uint32_t>& names, std::size_t count) {
  std::vector<Places> places(count);
  for (std::size_t i = 0; i < names.size(); ++i) places[names[i]].push_back(i);
  return places;
}

// Assigns to each of the fewer times one of the more, in order, with the smallest sum of distances.
Places assign(const std::vector<double>& fewer, const std::vector<double>& more) {
  const std::size_t f = fewer.size(), slack = more.size() - f;
  Places result(f);
  for (std::size_t i = 0; i < f; ++i) result[i] = i;
  if (f == 0 || slack == 0 || f > kMostSteps / (slack + 1)) return result;
  // best[i][s]: the first i are matched, s of the more were left out.
  std::vector<std::vector<double>> best(f + 1, std::vector<double>(slack + 1, kInfinity));
  best[0].assign(slack + 1, 0);
  for (std::size_t i = 1; i <= f; ++i) {
    for (std::size_t s = 0; s <= slack; ++s) {
      const double distance = std::fabs(fewer[i - 1] - more[i - 1 + s]);
      const double matched = best[i - 1][s] + (std::isnan(distance) ? kInfinity : distance);
      best[i][s] = s == 0 ? matched : std::min(matched, best[i][s - 1]);
    }
  }
  std::size_t s = slack;
  for (std::size_t i = f; i > 0; --i) {
    while (s > 0 && best[i][s] == best[i][s - 1]) --s;
    result[i - 1] = i - 1 + s;
  }
  return result;
}

double about(const RealRoot& root) { return root.lower_double() / 2 + root.upper_double() / 2; }

// Pairs (i, j), i < j, with ranks[i] > ranks[j].
std::uint64_t inversions_of(std::vector<std::uint32_t> ranks) {
  std::uint64_t count = 0;
  std::vector<std::uint32_t> work(ranks.size());
  for (std::size_t width = 1; width < ranks.size(); width *= 2) {
    for (std::size_t begin = 0; begin < ranks.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, ranks.size());
      const std::size_t end = std::min(begin + 2 * width, ranks.size());
      std::size_t a = begin, b = middle;
      for (std::size_t out = begin; out < end; ++out) {
        if (b == end || (a < middle && ranks[a] <= ranks[b])) {
          work[out] = ranks[a++];
        } else {
          count += middle - a;
          work[out] = ranks[b++];
        }
      }
    }
    std::swap(ranks, work);
  }
  return count;
}

void find_first(ExactTrace& exact, const InexactTrace& inexact, Deviation& result) {
  RootCounters counters;
  std::size_t begin = 0;  // of the events at the instant of event k
  std::vector<std::uint32_t> due;
  for (std::size_t k = 0; k < std::max(exact.size(), inexact.size()); ++k) {
    if (k >= exact.size()) {
      result.first = k + 1;
      result.first_time = inexact.times[k];
      return;
    }
    if (due.empty()) {
      begin = k;
      for (std::size_t i = begin; i < exact.size() && exact.instants[i] == exact.instants[begin];
           ++i) {
        due.push_back(exact.names[i]);
      }
    }
    const auto found =
        k < inexact.size() ? std::find(due.begin(), due.end(), inexact.names[k]) : due.end();
    if (found == due.end()) {
      result.first = k + 1;
      result.first_time = rational_near(exact.times[exact.instants[k]], counters);
      return;
    }
    due.erase(found);
  }
}

// ulp_of(root), for a root that is not 0 in an interval that does not hold 0.
Rational ulp_of_root(RealRoot& root, RootCounters& counters) {
  const Rational lower = root.lower(), upper = root.upper();
  const Rational small = lab::ulp_of(lower), large = lab::ulp_of(upper);
  if (small == large) return small;
  // A power of two lies inside the interval: on which side of it is the root?
  const bool positive = lower.sign() > 0;
  const Rational power = lab::power_of_two(lab::floor_log2(lab::absolute(positive ? upper : lower)));
  const int side = compare(root, positive ? power : -power, counters);
  return side == 0 || (side > 0) == positive ? std::max(small, large) : std::min(small, large);
}

// Adds |time - root| to the largest errors.
void add_error(RealRoot& root, const Rational& time, RootCounters& counters, Deviation& result) {
  if (compare(root, time, counters) == 0) return;
  if (compare(root, Rational(0), counters) == 0) {
    result.error = std::max(result.error, lab::absolute(time).upper_double());
    return;
  }
  for (;; root.refine(counters)) {
    const Rational lower = root.lower(), upper = root.upper();
    if (lower.sign() != upper.sign()) continue;
    const Rational largest = std::max(lab::absolute(time - lower), lab::absolute(time - upper));
    if ((upper - lower) * lab::power_of_two(kErrorBits) > largest) continue;
    result.error = std::max(result.error, largest.upper_double());
    const Rational ulps = largest / ulp_of_root(root, counters);
    result.error_ulps = std::max(result.error_ulps, ulps.upper_double());
    return;
  }
}

}  // namespace

std::vector<std::size_t> match_events(const ExactTrace& exact, const InexactTrace& inexact) {
  std::uint32_t names = 0;
  for (const std::uint32_t name : exact.names) names = std::max(names, name + 1);
  for (const std::uint32_t name : inexact.names) names = std::max(names, name + 1);
  const std::vector<Places> a = places_of(exact.names, names);
  const std::vector<Places> b = places_of(inexact.names, names);
  std::vector<std::size_t> result(exact.size(), kUnmatched);
  std::vector<double> times_a, times_b;
  for (std::uint32_t name = 0; name < names; ++name) {
    times_a.clear();
    times_b.clear();
    for (const std::size_t i : a[name]) times_a.push_back(about(exact.times[exact.instants[i]]));
    for (const std::size_t i : b[name]) {
      const std::optional<Rational>& t = inexact.times[i];
      times_b.push_back(t ? t->to_double() : kInfinity);
    }
    if (a[name].size() <= b[name].size()) {
      const Places chosen = assign(times_a, times_b);
      for (std::size_t i = 0; i < chosen.size(); ++i) result[a[name][i]] = b[name][chosen[i]];
    } else {
      const Places chosen = assign(times_b, times_a);
      for (std::size_t i = 0; i < chosen.size(); ++i) result[a[name][chosen[i]]] = b[name][i];
    }
  }
  return result;
}

Deviation deviation_of(ExactTrace& exact, const InexactTrace& inexact) {
  Deviation result;
  const std::vector<std::size_t> matched = match_events(exact, inexact);
  std::vector<std::size_t> partner(inexact.size(), kUnmatched);
  RootCounters counters;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (matched[i] == kUnmatched) continue;
    ++result.matched;
    partner[matched[i]] = i;
    const std::optional<Rational>& time = inexact.times[matched[i]];
    if (time) {
      add_error(exact.times[exact.instants[i]], *time, counters, result);
    } else {
      result.error = result.error_ulps = kInfinity;
    }
  }
  result.missed = exact.size() - result.matched;
  result.invented = inexact.size() - result.matched;
  std::vector<std::uint32_t> ranks;
  for (const std::size_t i : partner) {
    if (i != kUnmatched) ranks.push_back(exact.instants[i]);
  }
  result.inversions = inversions_of(std::move(ranks));
  find_first(exact, inexact, result);
  return result;
}

}  // namespace kinex::trade
