// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/log_check.h"

#include <algorithm>
#include <optional>

#include "core/polynomial_gcd.h"
#include "core/real_root.h"
#include "core/sturm_sequence.h"
#include "experiments/event_log.h"
#include "experiments/sha256.h"

namespace kinex {

namespace {

bool same_instant(const LogInstant& a, const LogInstant& b) {
  return a.root == b.root && a.lower == b.lower && a.upper == b.upper &&
         a.polynomial == b.polynomial;
}

// What is wrong with the instant's claim about itself; empty if it holds.
std::string instant_problem(const LogInstant& instant) {
  const Polynomial& p = instant.polynomial;
  if (!(p == p.canonical()))
    return "the polynomial is not primitive with a positive leading coefficient";
  if (instant.upper < instant.lower) return "the ends of the interval are in the wrong order";
  const SturmSequence sturm(p);
  if (!(square_free_part(p) == p)) return "the polynomial is not square-free";
  const bool point = instant.lower == instant.upper;
  if (point) {
    if (p.sign_at(instant.lower) != Sign::kZero) return "the rational is no root of the polynomial";
  } else {
    if (!instant.lower.is_dyadic() || !instant.upper.is_dyadic())
      return "the interval is not dyadic";
    if (p.sign_at(instant.lower) == Sign::kZero || p.sign_at(instant.upper) == Sign::kZero) {
      return "an end of the interval is a root itself";
    }
    const int roots = sturm.count_between(instant.lower, instant.upper);
    if (roots != 1) return "the interval holds " + std::to_string(roots) + " roots, not one";
  }
  const int index = sturm.count_all() - sturm.count_above(instant.upper);
  if (index == instant.root) return "";
  return "the interval holds root " + std::to_string(index) + ", not root " +
         std::to_string(instant.root);
}

RealRoot root_of(const LogInstant& instant) {
  if (instant.lower == instant.upper) return RealRoot(instant.lower);
  return RealRoot(instant.polynomial, instant.lower, instant.upper);
}

class Checker {
 public:
  explicit Checker(LogVerdict& verdict) : verdict_(verdict) {}

  void check(const LogEvent& event) {
    ++verdict_.events;
    if (event.external) ++verdict_.external;
    if (event.sequence != verdict_.events) {
      complain(event.line, "sequence number " + std::to_string(event.sequence) + " where " +
                               std::to_string(verdict_.events) + " is due");
    }
    check_names(event);
    digest_.add(digest_line(event.structure, event.kind, {event.ids.begin(), event.ids.end()}));
    if (verdict_.header.exact) check_time(event);
  }

  void finish(const std::optional<LogEnd>& end, std::size_t line) {
    verdict_.digest = digest_.hex();
    if (!end) {
      complain(line, "the log has no last line: it was cut off");
      return;
    }
    verdict_.status = end->status;
    if (end->events != verdict_.events) {
      complain(line, "the last line says " + std::to_string(end->events) + " events, there are " +
                         std::to_string(verdict_.events));
    }
    if (end->digest != verdict_.digest) {
      complain(line, "the last line's digest is " + end->digest + ", that of the events is " +
                         verdict_.digest);
    }
  }

 private:
  void complain(std::size_t line, const std::string& what) {
    if (verdict_.problems.size() < LogVerdict::kMaxProblems) {
      verdict_.problems.push_back("line " + std::to_string(line) + ": " + what);
    }
  }

  void check_names(const LogEvent& event) {
    for (const LogStructure& structure : verdict_.header.structures) {
      if (structure.label != event.structure) continue;
      const std::vector<std::string>& kinds = structure.kinds;
      if (std::find(kinds.begin(), kinds.end(), event.kind) == kinds.end()) {
        complain(event.line, "\"" + event.kind + "\" is no kind of event of " + event.structure);
      }
      return;
    }
    complain(event.line, "the header knows no structure \"" + event.structure + "\"");
  }

  void check_time(const LogEvent& event) {
    if (last_ && same_instant(*last_, event.time)) return;
    const std::string problem = instant_problem(event.time);
    if (!problem.empty()) {
      complain(event.line, problem);
      return;  // it says nothing, so it cannot be compared
    }
    RealRoot root = root_of(event.time);
    const int order = last_root_ ? compare(*last_root_, root, counters_) : -1;
    if (order > 0) complain(event.line, "the time is before that of the event before it");
    if (order < 0) ++verdict_.instants;
    last_ = event.time;
    last_root_ = std::move(root);
  }

  LogVerdict& verdict_;
  Sha256 digest_;
  std::optional<LogInstant> last_;
  std::optional<RealRoot> last_root_;
  RootCounters counters_;
};

}  // namespace

LogVerdict check_log(std::string_view text, const std::string& file) {
  LogReader reader(text, file);
  LogVerdict verdict;
  verdict.header = reader.header();
  Checker checker(verdict);
  LogEvent event;
  while (reader.next(event)) checker.check(event);
  checker.finish(reader.end(), reader.line());
  return verdict;
}

}  // namespace kinex
