// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>

#include "experiments/formats/log_instant.h"

namespace kinex::formats {

namespace {

using Places = std::vector<std::size_t>;
constexpr std::size_t kNone = LogMatch::kNone;

std::vector<Places> places_by_name(const std::vector<MatchedLog::Entry>& entries,
                                   std::size_t names) {
  std::vector<Places> places(names);
  for (std::size_t i = 0; i < entries.size(); ++i) places[entries[i].name].push_back(i);
  return places;
}

// What says how far entries of both logs are apart: their times, or their places.
class Distances {
 public:
  Distances(const MatchedLog& a, const MatchedLog& b)
      : timed_(a.header.has_times() && b.header.has_times()), of_a_(where(a)), of_b_(where(b)) {}
  bool timed() const { return timed_; }
  double between(std::size_t i, std::size_t j) const {
    const double apart = std::abs(of_a_[i] - of_b_[j]);
    return std::isnan(apart) ? 0 : apart;  // "nan" of an inexact log
  }

 private:
  std::vector<double> where(const MatchedLog& log) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < log.entries.size(); ++i) {
      result.push_back(
          timed_ ? std::strtod(log.instants[log.entries[i].instant].decimal.c_str(), nullptr)
                 : static_cast<double>(i));
    }
    return result;
  }
  bool timed_;
  std::vector<double> of_a_, of_b_;
};

// Whether an instant is after the one at which the other log ends.
class AfterEnd {
 public:
  AfterEnd(const MatchedLog& other, const MatchedLog& log)
      : whole_(other.ending.whole()), end_(other.ending.reached), header_(other.header) {
    const LogEnding& ending = log.ending;
    if (whole_) {
      ends_ = end_ && (!ending.whole() || !ending.reached || *end_ < *ending.reached);
      return;
    }
    if (!other.instants.empty()) last_ = other.instants.back();
    ends_ = !log.instants.empty() && !(last_ && same_text(*last_, log.instants.back()));
  }

  // False: the log has no later instants.
  bool ends() const { return ends_; }
  // Not at the end of a whole run: that one was cut off, perhaps in the midst of an instant.
  bool may_be_torn() const { return !whole_; }

  bool operator()(const LogInstant& instant, const LogHeader& header) {
    if (!ends_ || !header.has_times()) return false;
    if (end_ && compared(instant, header, *end_) <= 0) return false;
    return whole_ || !last_ || compared(instant, header, *last_) > 0;
  }
  // At the last instant of a log that may be torn there, or after it; without times: perhaps.
  bool not_before(const LogInstant& instant, const LogHeader& header) {
    if (!header.has_times() || !header_.has_times() || !last_) return true;
    if (header.has_intervals() && header_.has_intervals()) {
      return compared(instant, header, *last_) >= 0;
    }
    constexpr double kNear = 1e-9;  // the same instant in two arithmetics
    const double t = decimal(instant), last = decimal(*last_);
    return t >= last - kNear * std::max(1.0, std::abs(last));
  }

 private:
  static double decimal(const LogInstant& instant) {
    return std::strtod(instant.decimal.c_str(), nullptr);
  }
  static int order(double a, double b) { return a < b ? -1 : a > b ? 1 : 0; }

  int compared(const LogInstant& instant, const LogHeader& header, const Rational& end) {
    if (!header.has_intervals()) return order(decimal(instant), end.to_double());
    if (instant.lower == instant.upper) return instant.lower < end ? -1 : end < instant.lower;
    if (instant.upper <= end) return -1;
    if (instant.lower >= end) return 1;
    if (!header.has_names() || !instant_problem(instant, header).empty()) return 0;
    RealRoot root = root_of(instant);
    return compare(root, end, counters_);
  }

  int compared(const LogInstant& instant, const LogHeader& header, const LogInstant& last) {
    if (!header.has_intervals() || !header_.has_intervals())
      return order(decimal(instant), decimal(last));
    if (same_text(instant, last)) return 0;
    if (instant.upper < last.lower) return -1;
    if (last.upper < instant.lower) return 1;
    if (!header.has_names() || !header_.has_names() || !instant_problem(instant, header).empty() ||
        !instant_problem(last, header_).empty()) {
      return 0;
    }
    RealRoot root = root_of(instant), of_last = root_of(last);
    return compare(root, of_last, counters_);
  }

  bool whole_, ends_ = false;
  std::optional<Rational> end_;
  std::optional<LogInstant> last_;
  const LogHeader& header_;
  RootCounters counters_;
};

// By entry of `log`: it is after the end of the other log.
std::vector<bool> after_end(const MatchedLog& log, AfterEnd& after) {
  std::vector<bool> result(log.entries.size(), false);
  if (!after.ends()) return result;
  std::vector<bool> of_instant;
  for (const LogInstant& instant : log.instants) of_instant.push_back(after(instant, log.header));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = of_instant[log.entries[i].instant];
  return result;
}

class Matcher {
 public:
  Matcher(const MatchedLog& a, const MatchedLog& b, InstantsOf& instants)
      : a_(a),
        b_(b),
        instants_(instants),
        distances_(a, b),
        in_b_(a.entries.size(), kNone),
        taken_(b.entries.size(), false) {}

  // Entries that no match can have.
  void leave_out(const std::vector<bool>& of_a, const std::vector<bool>& of_b) {
    left_out_ = of_a;
    for (std::size_t j = 0; j < of_b.size(); ++j) taken_[j] = taken_[j] || of_b[j];
  }

  // Those at one instant, as far as they are in the same order in both logs: it may have one event twice.
  void match_instants() {
    std::unordered_map<std::string, std::vector<std::uint32_t>> by_decimal;
    for (std::uint32_t k = 0; k < b_.instants.size(); ++k) {
      by_decimal[b_.instants[k].decimal].push_back(k);
    }
    const Places of_a = begins_of(a_), of_b = begins_of(b_);
    for (std::uint32_t k = 0; k < a_.instants.size(); ++k) {
      const auto found = by_decimal.find(a_.instants[k].decimal);
      if (found == by_decimal.end()) continue;
      for (const std::uint32_t other : found->second) {
        if (instants_.same(k, other)) {
          align(of_a[k], of_a[k + 1], of_b[other], of_b[other + 1]);
        }
      }
    }
  }

  // The rest of those at one instant.
  void match_at_instants() {
    std::unordered_map<std::string, std::uint32_t> numbers;
    const auto number = [&numbers](const LogInstant& instant) {
      return numbers.emplace(instant.decimal, static_cast<std::uint32_t>(numbers.size()))
          .first->second;
    };
    std::vector<std::uint32_t> of_a, of_b;
    for (const LogInstant& instant : a_.instants) of_a.push_back(number(instant));
    for (const LogInstant& instant : b_.instants) of_b.push_back(number(instant));
    const auto key = [](const MatchedLog::Entry& entry,
                        const std::vector<std::uint32_t>& decimals) {
      return std::uint64_t{entry.name} << 32 | decimals[entry.instant];
    };
    std::unordered_map<std::uint64_t, Places> left;
    for (std::size_t j = b_.entries.size(); j-- > 0;) {
      if (!taken_[j]) left[key(b_.entries[j], of_b)].push_back(j);
    }
    for (std::size_t i = 0; i < a_.entries.size(); ++i) {
      const auto found = left.find(key(a_.entries[i], of_a));
      if (!is_free(i) || found == left.end()) continue;
      Places& places = found->second;  // the first one at its end
      for (std::size_t k = places.size(); k-- > 0;) {
        if (!instants_.same(a_.entries[i].instant, b_.entries[places[k]].instant)) continue;
        take(i, places[k]);
        places.erase(places.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      }
    }
  }

  // Without times: what both logs begin and end with.
  void match_ends() {
    if (distances_.timed()) return;
    const auto &a = a_.entries, &b = b_.entries;
    std::size_t begin = 0, end = 0;
    const std::size_t most = std::min(a.size(), b.size());
    while (begin < most && a[begin].name == b[begin].name) {
      take(begin, begin);
      ++begin;
    }
    while (begin + end < most && a[a.size() - 1 - end].name == b[b.size() - 1 - end].name) {
      ++end;
      take(a.size() - end, b.size() - end);
    }
  }

  // The entries of one name that are left over, between those that are matched.
  void match_rest(const Places& of_a, const Places& of_b) {
    std::size_t next = 0;  // in of_b
    Places left_a, left_b;
    for (std::size_t k = 0; k <= of_a.size(); ++k) {
      if (k < of_a.size() && in_b_[of_a[k]] == kNone) {
        if (is_free(of_a[k])) left_a.push_back(of_a[k]);
        continue;
      }
      const auto end = k == of_a.size()
                           ? of_b.end()
                           : std::lower_bound(of_b.begin(), of_b.end(), in_b_[of_a[k]]);
      for (; of_b.begin() + static_cast<std::ptrdiff_t>(next) < end; ++next) {
        if (!taken_[of_b[next]]) left_b.push_back(of_b[next]);
      }
      pair_up(left_a, left_b);
      left_a.clear();
      left_b.clear();
    }
  }

  std::vector<std::size_t> result() && { return std::move(in_b_); }

 private:
  bool is_free(std::size_t i) const { return in_b_[i] == kNone && !left_out_[i]; }

  void take(std::size_t i, std::size_t j) {
    in_b_[i] = j;
    taken_[j] = true;
  }

  // For each instant the place of its first entry; then the number of entries.
  static Places begins_of(const MatchedLog& log) {
    Places begins;
    for (std::size_t i = 0; i < log.entries.size(); ++i) {
      if (log.entries[i].instant == begins.size()) begins.push_back(i);
    }
    begins.push_back(log.entries.size());
    return begins;
  }

  // A longest common subsequence of free entries of two instants; none if that takes too long.
  void align(std::size_t begin_a, std::size_t end_a, std::size_t begin_b, std::size_t end_b) {
    constexpr std::size_t kMostSteps = std::size_t{1} << 20;
    const auto equal = [this](std::size_t i, std::size_t j) {
      return a_.entries[i].name == b_.entries[j].name && is_free(i) && !taken_[j];
    };
    while (begin_a < end_a && begin_b < end_b && equal(begin_a, begin_b)) {
      take(begin_a++, begin_b++);
    }
    while (begin_a < end_a && begin_b < end_b && equal(end_a - 1, end_b - 1)) {
      take(--end_a, --end_b);
    }
    const std::size_t rows = end_a - begin_a, columns = end_b - begin_b;
    if (rows == 0 || columns == 0 || rows > kMostSteps / columns) return;
    // length[i][j]: of the entries from i and j on.
    std::vector<std::uint32_t> length((rows + 1) * (columns + 1), 0);
    const auto at = [columns](std::size_t i, std::size_t j) { return i * (columns + 1) + j; };
    for (std::size_t i = rows; i-- > 0;) {
      for (std::size_t j = columns; j-- > 0;) {
        length[at(i, j)] = equal(begin_a + i, begin_b + j)
                               ? length[at(i + 1, j + 1)] + 1
                               : std::max(length[at(i + 1, j)], length[at(i, j + 1)]);
      }
    }
    for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
      if (equal(begin_a + i, begin_b + j)) {
        take(begin_a + i++, begin_b + j++);
      } else {
        ++(length[at(i + 1, j)] >= length[at(i, j + 1)] ? i : j);
      }
    }
  }

  void pair_up(const Places& of_a, const Places& of_b) {
    const bool few_in_a = of_a.size() <= of_b.size();
    const Places &few = few_in_a ? of_a : of_b, &many = few_in_a ? of_b : of_a;
    const Places nearest = nearest_of(few, many, few_in_a);
    for (std::size_t k = 0; k < few.size(); ++k) {
      const std::size_t other = many[nearest[k]];
      few_in_a ? take(few[k], other) : take(other, few[k]);
    }
  }

  // For each of the few one of the many, in order, all in all the nearest; the earlier ones if in doubt.
  Places nearest_of(const Places& few, const Places& many, bool few_in_a) const {
    constexpr std::size_t kMostSteps = std::size_t{1} << 24;
    const std::size_t skips = many.size() - few.size();
    Places result;
    for (std::size_t k = 0; k < few.size(); ++k) result.push_back(k);
    if (few.empty() || skips == 0 || few.size() > kMostSteps / (skips + 1)) return result;
    // best[s]: of the first few with s of the many left out; the last of the many is one of these if `skipped`.
    std::vector<double> best(skips + 1, 0);
    std::vector<bool> skipped(few.size() * (skips + 1), false);
    for (std::size_t k = 0; k < few.size(); ++k) {
      for (std::size_t s = 0; s <= skips; ++s) {
        const std::size_t one = few[k], other = many[k + s];
        best[s] += few_in_a ? distances_.between(one, other) : distances_.between(other, one);
        if (s == 0 || best[s] < best[s - 1]) continue;
        best[s] = best[s - 1];
        skipped[k * (skips + 1) + s] = true;
      }
    }
    std::size_t s = skips;
    for (std::size_t k = few.size(); k-- > 0;) {
      while (skipped[k * (skips + 1) + s]) --s;
      result[k] = k + s;
    }
    return result;
  }

  const MatchedLog& a_;
  const MatchedLog& b_;
  InstantsOf& instants_;
  const Distances distances_;
  std::vector<std::size_t> in_b_;
  std::vector<bool> taken_;     // of b
  std::vector<bool> left_out_;  // of a
};

// The last entries of a log without a match are after the end of one that may be torn at this instant. An
// entry that has a match, or is before that, ends them.
void add_torn(const MatchedLog& log, const std::vector<bool>& matched, AfterEnd& after,
              std::vector<bool>& result) {
  if (!after.may_be_torn()) return;
  for (std::size_t i = log.entries.size(); i-- > 0;) {
    if (matched[i]) return;
    if (!result[i] && !after.not_before(log.instants[log.entries[i].instant], log.header)) return;
    result[i] = true;
  }
}

}  // namespace

InstantsOf::InstantsOf(const MatchedLog& a, const MatchedLog& b) : a_(a), b_(b) {
  if (a.header.has_names() && b.header.has_names()) {
    compared_ = InstantsCompared::kExactly;
  } else if (a.header.has_intervals() && b.header.has_intervals()) {
    compared_ = InstantsCompared::kIntervals;
  }
}

bool InstantsOf::same(std::uint32_t in_a, std::uint32_t in_b) {
  if (compared_ == InstantsCompared::kNot) return true;
  const auto [place, is_new] = known_.try_emplace({in_a, in_b}, false);
  if (is_new) place->second = look(a_.instants[in_a], b_.instants[in_b]);
  return place->second;
}

bool InstantsOf::look(const LogInstant& a, const LogInstant& b) {
  if (same_text(a, b)) return true;
  const bool names_a = a_.header.has_names(), names_b = b_.header.has_names();
  if (names_a && names_b && a.root == b.root && a.polynomial == b.polynomial) return true;
  if (a.upper < b.lower || b.upper < a.lower) return false;
  if (!names_a && !names_b) return true;
  // Only instants without defects can be compared as numbers.
  if ((names_a && !instant_problem(a, a_.header).empty()) ||
      (names_b && !instant_problem(b, b_.header).empty())) {
    return false;
  }
  if (names_a && names_b) {
    RealRoot of_a = root_of(a), of_b = root_of(b);
    return compare(of_a, of_b, counters_) == 0;
  }
  RealRoot root = root_of(names_a ? a : b);
  const LogInstant& interval = names_a ? b : a;
  return compare(root, interval.lower, counters_) >= 0 &&
         compare(root, interval.upper, counters_) <= 0;
}

LogMatch match_logs(const MatchedLog& a, const MatchedLog& b, InstantsOf& instants,
                    std::size_t names) {
  AfterEnd end_of_b(b, a), end_of_a(a, b);
  LogMatch match;
  match.after_b = after_end(a, end_of_b);
  match.after_a = after_end(b, end_of_a);
  Matcher matcher(a, b, instants);
  if (instants.compared() != InstantsCompared::kNot) {
    matcher.leave_out(match.after_b, match.after_a);
    matcher.match_instants();
    matcher.match_at_instants();
  } else {
    matcher.leave_out(std::vector<bool>(a.entries.size(), false), {});
    matcher.match_ends();
  }
  const std::vector<Places> of_a = places_by_name(a.entries, names),
                            of_b = places_by_name(b.entries, names);
  for (std::size_t name = 0; name < names; ++name) matcher.match_rest(of_a[name], of_b[name]);
  match.in_b = std::move(matcher).result();
  std::vector<bool> matched_a, matched_b(b.entries.size(), false);
  for (const std::size_t j : match.in_b) {
    matched_a.push_back(j != kNone);
    if (j != kNone) matched_b[j] = true;
  }
  for (std::size_t i = 0; i < matched_a.size(); ++i) {
    if (matched_a[i]) match.after_b[i] = false;
  }
  for (std::size_t j = 0; j < matched_b.size(); ++j) {
    if (matched_b[j]) match.after_a[j] = false;
  }
  add_torn(a, matched_a, end_of_b, match.after_b);
  add_torn(b, matched_b, end_of_a, match.after_a);
  return match;
}

}  // namespace kinex::formats
