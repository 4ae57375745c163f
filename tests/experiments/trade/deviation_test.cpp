// SPDX-License-Identifier: GPL-3.0-or-later
// Deviation and traces: answers known by hand, and brute force over small random cases.
#include "experiments/trade/deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

#include "experiments/formats/scene_reader.h"
#include "experiments/lab/binary_scale.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "experiments/trade/checkpoints.h"

namespace kinex {
namespace deviation_test {

Rational q(const char* text) { return *Rational::parse(text); }

// Events as letters; "|" ends an instant. Instants are at 1, 2, 3, ..
trade::ExactTrace exact_trace(const std::string& text) {
  trade::ExactTrace trace;
  bool begun = false;
  for (const char c : text) {
    if (c == '|') {
      begun = false;
      continue;
    }
    if (!begun) trace.times.emplace_back(Rational(static_cast<int>(trace.times.size()) + 1));
    begun = true;
    trace.names.push_back(static_cast<std::uint32_t>(c - 'a'));
    trace.instants.push_back(static_cast<std::uint32_t>(trace.times.size() - 1));
  }
  return trace;
}

trade::InexactTrace inexact_trace(const std::string& names, const std::vector<const char*>& times) {
  trade::InexactTrace trace;
  for (std::size_t i = 0; i < names.size(); ++i) {
    trace.names.push_back(static_cast<std::uint32_t>(names[i] - 'a'));
    trace.times.push_back(i < times.size() ? Rational::parse(times[i]) : Rational(1));
  }
  return trace;
}

trade::Deviation deviation(const std::string& exact, const std::string& inexact,
                    const std::vector<const char*>& times = {}) {
  trade::ExactTrace a = exact_trace(exact);
  return trade::deviation_of(a, inexact_trace(inexact, times));
}

TEST(Deviation, SameEventsAtTheSameTimes) {
  const trade::Deviation d = deviation("a|b|c", "abc", {"1", "2", "3"});
  EXPECT_TRUE(d.same_events());
  EXPECT_EQ(d.matched, 3u);
  EXPECT_EQ(d.error, 0);
  EXPECT_EQ(d.error_ulps, 0);
  EXPECT_TRUE(deviation("", "").same_events());
}

TEST(Deviation, MissedInventedAndFirst) {
  trade::Deviation d = deviation("a|b|c", "ac", {"1", "3"});
  EXPECT_EQ(d.missed, 1u);
  EXPECT_EQ(d.invented, 0u);
  EXPECT_EQ(d.first, 2u);
  EXPECT_EQ(d.first_time, Rational(2));
  d = deviation("a|b", "axb", {"1", "3/2", "2"});
  EXPECT_EQ(d.missed, 0u);
  EXPECT_EQ(d.invented, 1u);
  EXPECT_EQ(d.first, 2u);
  EXPECT_EQ(d.first_time, Rational(2));  // when b is due
  d = deviation("a|b", "a", {"1"});       // ended too early
  EXPECT_EQ(d.first, 2u);
  d = deviation("a", "ab", {"1", "7/2"});  // went on too long
  EXPECT_EQ(d.first, 2u);
  EXPECT_EQ(d.first_time, q("7/2"));
}

// The decimals are those of the instant, whatever interval it is known by.
TEST(RationalNear, HasTheDecimalsOfTheInstant) {
  RootCounters counters;
  for (const char* polynomial : {"2", "3", "1/7", "200000000000000000001"}) {
    const Polynomial p = Polynomial::from_rationals({-q(polynomial), Rational(0), Rational(1)});
    for (RootWithMultiplicity& root : isolate_real_roots(p, counters)) {
      RealRoot other = root.root;
      const Rational near = trade::rational_near(root.root, counters);
      EXPECT_EQ(trade::time_decimal(near), decimal(other, 17, counters));
    }
  }
  // Exactly a number of so many decimals, known as a root.
  const Polynomial square = Polynomial::from_rationals({-q("1/4"), Rational(0), Rational(1)});
  for (RootWithMultiplicity& root : isolate_real_roots(square, counters)) {
    EXPECT_EQ(trade::rational_near(root.root, counters) * trade::rational_near(root.root, counters), q("1/4"));
  }
  RealRoot third(q("1/3"));
  EXPECT_EQ(trade::rational_near(third, counters), q("1/3"));
}

TEST(Deviation, InversionsAgainstTheExactOrder) {
  EXPECT_EQ(deviation("a|b|c|d", "dcba").inversions, 6u);
  EXPECT_EQ(deviation("a|b|c|d", "abdc").inversions, 1u);
  EXPECT_EQ(deviation("a|b|c|d", "bcda").inversions, 3u);
  EXPECT_EQ(deviation("a|b|c|d", "abdc").first, 3u);
  // Those that are missed or invented are in no pair.
  EXPECT_EQ(deviation("a|b|c|d", "dxa").inversions, 1u);
}

TEST(Deviation, EventsAtOneInstantAreInNoOrder) {
  const trade::Deviation d = deviation("a|bcd|e", "adbce", {"1", "2", "2", "2", "3"});
  EXPECT_TRUE(d.same_events());
  EXPECT_EQ(d.first, 0u);
  EXPECT_FALSE(deviation("a|bcd|e", "abced").same_events());
  EXPECT_EQ(deviation("a|bcd|e", "abced").first, 4u);
  EXPECT_EQ(deviation("a|bcd|e", "abced").inversions, 1u);
}

TEST(Deviation, ErrorsInSecondsAndUlps) {
  const trade::Deviation d = deviation("a|b|c", "abc", {"1", "2.0000000001", "3"});
  EXPECT_NEAR(d.error, 1e-10, 1e-15);
  EXPECT_GE(d.error, 1e-10);  // rounded up
  EXPECT_NEAR(d.error_ulps, 1e-10 / std::ldexp(1, -51), 1);
  EXPECT_TRUE(d.same_events());
  const trade::Deviation nan = deviation("a", "a", {"nan"});
  EXPECT_EQ(nan.error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(nan.error_ulps, std::numeric_limits<double>::infinity());
}

// sqrt(2) as a double: what is wrong is below half an ulp, and known to 20 bits.
TEST(Deviation, ErrorAtAnAlgebraicInstant) {
  trade::ExactTrace exact;
  exact.names = {0};
  exact.instants = {0};
  exact.times.emplace_back(Polynomial({Integer(-2), Integer(0), Integer(1)}), Rational(1),
                           Rational(2));
  trade::InexactTrace inexact;
  inexact.names = {0};
  inexact.times = {Rational::from_double(1.4142135623730951)};
  const trade::Deviation d = trade::deviation_of(exact, inexact);
  EXPECT_NEAR(d.error, 9.667293313452913e-17, 1e-21);  // sqrt(2) to 30 digits, by hand
  EXPECT_NEAR(d.error_ulps, 0.43537678, 1e-6);
}

// An event that comes more often in one run is matched where its times fit best.
TEST(Deviation, RepeatedEventsAreMatchedByTime) {
  trade::Deviation d = deviation("a|a|a", "aa", {"2.25", "3"});
  EXPECT_EQ(d.missed, 1u);
  EXPECT_EQ(d.error, 0.25);
  d = deviation("a|b|a", "aaba", {"0.5", "1", "2", "3"});
  EXPECT_EQ(d.invented, 1u);
  EXPECT_EQ(d.error, 0);
  EXPECT_EQ(d.first, 2u);
}

// Brute force for everything but which of several equal events is matched: names are distinct.
TEST(Deviation, AgreesWithBruteForce) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 300; ++round) {
    trade::ExactTrace exact;
    const int length = static_cast<int>(random() % 9);
    for (int i = 0; i < length; ++i) {
      if (exact.times.empty() || random() % 3 != 0) {
        exact.times.emplace_back(Rational(static_cast<int>(exact.times.size()) + 1));
      }
      exact.names.push_back(static_cast<std::uint32_t>(i));
      exact.instants.push_back(static_cast<std::uint32_t>(exact.times.size() - 1));
    }
    trade::InexactTrace inexact;
    for (std::uint32_t name = 0; name < 10; ++name) {
      if (random() % 4 == 0) continue;
      inexact.names.push_back(name);
      inexact.times.emplace_back(
          Rational(Integer(static_cast<std::int64_t>(random() % 100)), Integer(16)));
    }
    std::shuffle(inexact.names.begin(), inexact.names.end(), random);

    const auto instant_of = [&](std::uint32_t name) {
      return name < exact.size() ? static_cast<int>(exact.instants[name]) : -1;
    };
    std::uint64_t invented = 0, inversions = 0;
    double error = 0;
    for (std::size_t i = 0; i < inexact.size(); ++i) {
      const int instant = instant_of(inexact.names[i]);
      invented += instant < 0 ? 1 : 0;
      if (instant < 0) continue;
      error = std::max(error, std::fabs(inexact.times[i]->to_double() - (instant + 1)));
      for (std::size_t j = 0; j < i; ++j) {
        if (instant_of(inexact.names[j]) > instant) ++inversions;
      }
    }
    // Prefixes agree as long as each is a prefix of the exact events, reordered inside instants.
    std::uint64_t first = 0;
    for (std::size_t k = 0; k < std::max(exact.size(), inexact.size()) && first == 0; ++k) {
      bool good = k < exact.size() && k < inexact.size() &&
                  instant_of(inexact.names[k]) == static_cast<int>(exact.instants[k]);
      if (!good) first = k + 1;
    }
    const trade::Deviation d = trade::deviation_of(exact, inexact);
    EXPECT_EQ(d.invented, invented);
    EXPECT_EQ(d.missed, exact.size() - (inexact.size() - invented));
    EXPECT_EQ(d.inversions, inversions);
    EXPECT_EQ(d.first, first);
    EXPECT_EQ(d.error, error);  // sixteenths: exact
  }
}

// For equal names: the smallest sum of distances over all ways to choose, in order.
TEST(MatchEvents, AgreesWithBruteForce) {
  std::mt19937_64 random(9);
  for (int round = 0; round < 300; ++round) {
    trade::ExactTrace exact;
    trade::InexactTrace inexact;
    const std::size_t a = random() % 6, b = random() % 6;
    int t = 0;
    for (std::size_t i = 0; i < a; ++i) {
      t += static_cast<int>(random() % 5) + 1;
      exact.names.push_back(0);
      exact.instants.push_back(static_cast<std::uint32_t>(i));
      exact.times.emplace_back(Rational(t));
    }
    std::vector<int> times;
    for (std::size_t i = 0; i < b; ++i) times.push_back(static_cast<int>(random() % 25));
    std::sort(times.begin(), times.end());
    for (const int time : times) {
      inexact.names.push_back(0);
      inexact.times.emplace_back(Rational(time));
    }
    const auto exact_time = [&](std::size_t i) { return exact.times[i].value().to_double(); };
    double sum = 0;
    std::size_t count = 0;
    const std::vector<std::size_t> matched = trade::match_events(exact, inexact);
    for (std::size_t i = 0; i < matched.size(); ++i) {
      if (matched[i] == trade::kUnmatched) continue;
      ++count;
      sum += std::fabs(exact_time(i) - times[matched[i]]);
    }
    EXPECT_EQ(count, std::min(a, b));
    double best = std::numeric_limits<double>::infinity();
    for (unsigned mask = 0; mask < 1u << std::max(a, b); ++mask) {
      std::vector<std::size_t> chosen;
      for (std::size_t i = 0; i < std::max(a, b); ++i) {
        if ((mask >> i & 1u) != 0) chosen.push_back(i);
      }
      if (chosen.size() != std::min(a, b)) continue;
      double cost = 0;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        cost += a <= b ? std::fabs(exact_time(i) - times[chosen[i]])
                       : std::fabs(exact_time(chosen[i]) - times[i]);
      }
      best = std::min(best, cost);
    }
    EXPECT_EQ(sum, best);
  }
}

// ---- traces of real runs --------------------------------------------------------------------

Scene small_scene(const char* workload, int n, int degree, const char* structure) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.degree = degree;
  Scene scene = lab::generate_scene(*lab::find_workload(workload), parameters);
  formats::set_maintain(scene, {structure});
  return scene;
}

template <class Recorder>
void record(const Scene& scene, const std::string& arithmetic, Recorder& recorder) {
  const auto simulator = lab::make_simulator(scene, arithmetic, {});
  simulator->set_sink(&recorder);
  simulator->start();
  simulator->run_until(std::nullopt);
}

TEST(Trace, ExactAndSturmAreEqual) {
  for (const char* workload : {"uniform-square", "grid", "meet"}) {
    const Scene scene = small_scene(workload, 7, 1, "delaunay_2");
    trade::EventNames names;
    trade::ExactRecorder exact(names), sturm(names);
    record(scene, "exact", exact);
    record(scene, "sturm", sturm);
    EXPECT_GT(exact.trace.size(), 5u) << workload;
    EXPECT_TRUE(trade::equal(exact.trace, sturm.trace)) << workload;
    ASSERT_FALSE(sturm.trace.names.empty());
    sturm.trace.names.back() += 1;
    EXPECT_FALSE(trade::equal(exact.trace, sturm.trace)) << workload;
    sturm.trace.names.back() -= 1;
    sturm.trace.times.back() = RealRoot(Rational(100));
    EXPECT_FALSE(trade::equal(exact.trace, sturm.trace)) << workload;
  }
}

// Instants ascend strictly, and events at one of them share it.
TEST(Trace, InstantsAreDistinct) {
  const Scene scene = small_scene("through-one-point", 6, 1, "sorted_list");
  trade::EventNames names;
  trade::ExactRecorder recorder(names);
  record(scene, "exact", recorder);
  trade::ExactTrace& trace = recorder.trace;
  EXPECT_EQ(trace.size(), 15u);  // every pair swaps at t = 1/2
  ASSERT_EQ(trace.times.size(), 1u);
  RootCounters counters;
  EXPECT_EQ(compare(trace.times[0], q("1/2"), counters), 0);
  EXPECT_EQ(names.size(), 15u);
}

// The times of an inexact run are its numbers, bit by bit.
TEST(Trace, InexactTimesAreThoseOfTheRun) {
  const Scene scene = small_scene("uniform-square", 8, 2, "delaunay_2");
  class Doubles final : public EventSink {
   public:
    void event(const Event&, Arithmetic& arithmetic) override {
      times.push_back(arithmetic.now_approximate());
    }
    std::vector<double> times;
  } doubles;
  record(scene, "double", doubles);
  trade::EventNames names;
  trade::InexactRecorder recorder(names);
  record(scene, "double", recorder);
  ASSERT_EQ(recorder.trace.times.size(), doubles.times.size());
  EXPECT_GT(doubles.times.size(), 10u);
  for (std::size_t i = 0; i < doubles.times.size(); ++i) {
    EXPECT_EQ(*recorder.trace.times[i], *Rational::from_double(doubles.times[i]));
  }
  // A number of 100 bits is dyadic with 100 significant bits at most.
  trade::InexactRecorder precise(names);
  record(scene, "mpfr:100", precise);
  for (const std::optional<Rational>& t : precise.trace.times) {
    EXPECT_TRUE(t->is_dyadic());
    EXPECT_EQ(lab::round_to_bits(*t, 100), *t);
  }
}

TEST(Checkpoints, AreBetweenInstants) {
  for (const char* workload : {"uniform-square", "through-one-point", "near-one-point", "grid"}) {
    const Scene scene = small_scene(workload, 9, 1, "sorted_list");
    trade::EventNames names;
    trade::ExactRecorder recorder(names);
    record(scene, "exact", recorder);
    const std::vector<Rational> checkpoints =
        trade::checkpoints_of(recorder.trace, scene.start, *scene.end);
    EXPECT_GE(checkpoints.size(), 2u) << workload;
    EXPECT_LE(checkpoints.size(), 10u) << workload;
    RootCounters counters;
    for (std::size_t i = 0; i < checkpoints.size(); ++i) {
      EXPECT_LT(scene.start, checkpoints[i]);
      EXPECT_LT(checkpoints[i], *scene.end);
      if (i > 0) {
        EXPECT_LT(checkpoints[i - 1], checkpoints[i]);
      }
      for (RealRoot& instant : recorder.trace.times) {
        EXPECT_NE(compare(instant, checkpoints[i], counters), 0);
      }
    }
  }
  trade::ExactTrace empty;
  EXPECT_EQ(trade::checkpoints_of(empty, Rational(0), Rational(1)).size(), 7u);
}

}  // namespace deviation_test
}  // namespace kinex
