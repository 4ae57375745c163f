// SPDX-License-Identifier: GPL-3.0-or-later
// What `kinex view` records of a run: the run's own states, after every event.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/numbers/polynomial_gcd.h"
#include "core/numbers/real_root.h"
#include "experiments/formats/input_error.h"
#include "tests/experiments/view/fixture.h"

namespace kinex {
namespace record_test {

using test::busy_scene;
using test::plain_run;
using test::record;
using test::workload;

// Irrational-looking times, so that no event is at one of them.
std::vector<Rational> times_between(const Rational& start, const Rational& end, int count) {
  std::vector<Rational> times;
  for (int i = 1; i < count; ++i) {
    times.push_back(start + (end - start) * Rational(Integer(1009 * i + 1), Integer(1009 * count)));
  }
  return times;
}

void expect_states_of_a_plain_run(const Scene& scene, const std::string& arithmetic) {
  const view::RecordedRun recorded = record(scene, arithmetic);
  const auto plain = plain_run(scene, arithmetic, times_between(scene.start, *scene.end, 40));
  EXPECT_EQ(recorded.digest, plain.digest) << scene.name << " " << arithmetic;
  EXPECT_TRUE(recorded.complete);
  ASSERT_EQ(recorded.all.size(), recorded.events.size());
  for (const auto& sample : plain.samples) {
    for (std::size_t i = 0; i < recorded.structures.size(); ++i) {
      const auto value = view::attribute_after(recorded.structures[i], sample.events);
      if (!value) continue;  // corrupt: nothing to compare
      EXPECT_EQ(*value, sample.values[i])
          << scene.name << " " << arithmetic << " after event " << sample.events;
    }
  }
}

TEST(ViewRecord, StatesAreThoseOfARunWithoutARecorder) {
  for (const char* arithmetic : {"exact", "sturm", "double", "gsl", "mpfr:80"}) {
    expect_states_of_a_plain_run(
        workload("uniform-square", 12, "sorted_list,delaunay_2,maximum_tournament,minimum_heap"),
        arithmetic);
    expect_states_of_a_plain_run(
        workload("uniform-square", 9, "maximum_sorted_list,minimum_sorted_list", 1, 2), arithmetic);
  }
}

TEST(ViewRecord, DegenerateScenes) {
  for (const char* family : {"grid", "lattice", "meet", "through-one-point", "collinear-instant",
                             "expanding-circle", "rotating-circle"}) {
    for (const char* arithmetic : {"exact", "double"}) {
      expect_states_of_a_plain_run(workload(family, 9, "delaunay_2,sorted_list,maximum_heap"),
                                   arithmetic);
    }
  }
}

TEST(ViewRecord, ObjectsThatComeGoAndJump) {
  for (const char* maintain :
       {"sorted_list,delaunay_2", "maximum_tournament,maximum_heap", "maximum_sorted_list"}) {
    for (const char* arithmetic : {"exact", "double"}) {
      expect_states_of_a_plain_run(busy_scene(maintain), arithmetic);
    }
  }
  // An insertion is in the state after its own event.
  const view::RecordedRun run = record(busy_scene("sorted_list"));
  bool seen = false;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const view::RecordedStructure& list = run.structures[0];
    if (list.kinds[run.events[i].event.kind] != "insert") continue;
    seen = true;
    const ObjectId object = run.events[i].event.ids[0];
    const auto before = view::attribute_after(list, i), after = view::attribute_after(list, i + 1);
    EXPECT_EQ(std::count(before->ids.begin(), before->ids.end(), object), 0);
    EXPECT_EQ(std::count(after->ids.begin(), after->ids.end(), object), 1);
  }
  EXPECT_TRUE(seen);
}

// A replay by what the events say, and nothing else.
TEST(ViewRecord, EventsLeadFromStateToState) {
  const view::RecordedRun run = record(workload("uniform-square", 16, "sorted_list,delaunay_2"));
  const view::RecordedStructure& list = run.structures[0];
  const view::RecordedStructure& triangulation = run.structures[1];
  std::vector<ObjectId> order = list.initial.ids;
  Attribute edges = triangulation.initial;
  std::size_t swaps = 0, flips = 0;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const Event& event = run.events[i].event;
    if (event.structure == 0) {
      ASSERT_EQ(list.kinds[event.kind], "swap");
      const auto a = std::find(order.begin(), order.end(), event.ids[0]);
      ASSERT_NE(a, order.end());
      ASSERT_NE(a + 1, order.end());
      ASSERT_EQ(*(a + 1), event.ids[1]);
      std::iter_swap(a, a + 1);
      ++swaps;
    } else if (triangulation.kinds[event.kind] == "flip") {
      view::AttributeChange change;
      change.removed = {event.ids[0], event.ids[1]};
      change.added = {event.ids[2], event.ids[3]};
      view::apply(change, edges);
      ++flips;
    } else {
      edges = *view::attribute_after(triangulation, i + 1);  // hull events name points
    }
    ASSERT_EQ(view::attribute_after(list, i + 1)->ids, order) << i + 1;
    ASSERT_EQ(*view::attribute_after(triangulation, i + 1), edges) << i + 1;
  }
  EXPECT_GT(swaps, 20u);
  EXPECT_GT(flips, 20u);
}

TEST(ViewRecord, PolynomialsVanishAtTheirInstants) {
  for (const char* maintain : {"sorted_list", "delaunay_2"}) {
    const Scene scene = workload("uniform-square", 12, maintain);
    const view::RecordedRun exact = record(scene), rounded = record(scene, "double");
    ASSERT_EQ(exact.events.size(), rounded.events.size());
    RootCounters counters;
    for (std::size_t i = 0; i < exact.events.size(); ++i) {
      const view::RecordedEvent& event = exact.events[i];
      const InstantName& instant = exact.instants[event.instant].name;
      const Polynomial& name = instant.polynomial;
      const Polynomial own = event.sign == 0 ? event.polynomial : event.sign > 0 ? name : -name;
      ASSERT_TRUE(event.sign != 0 || event.polynomial.degree() > 0);
      RealRoot root = instant.lower == instant.upper ? RealRoot(instant.lower)
                                                     : RealRoot(name, instant.lower, instant.upper);
      EXPECT_EQ(sign_at(own, root, counters), Sign::kZero) << i + 1;
      // It fails: right after, the value is negative.
      root.refine_to(50, counters);
      const Rational after = root.upper() + Rational::from_double(0x1p-60).value();
      EXPECT_EQ(own.sign_at(after), Sign::kNegative) << i + 1;
      // Rounded arithmetics have no part in it: the same polynomial.
      EXPECT_EQ(rounded.events[i].polynomial, own) << i + 1;
    }
  }
}

// Motions change on the way: the polynomial is that of the motions in force.
TEST(ViewRecord, PolynomialsOfMotionsInForce) {
  const Scene scene = busy_scene("sorted_list,delaunay_2");
  const view::RecordedRun run = record(scene);
  const ObjectId changed = 3;  // at t = 2
  ASSERT_EQ(scene.objects[changed].id, "d");
  RootCounters counters;
  int after_the_change = 0;
  for (const view::RecordedEvent& event : run.events) {
    if (event.event.certificate.arity == 0) continue;
    const InstantName& name = run.instants[event.instant].name;
    RealRoot root = name.lower == name.upper ? RealRoot(name.lower)
                                             : RealRoot(name.polynomial, name.lower, name.upper);
    const Polynomial& own = event.sign != 0 ? name.polynomial : event.polynomial;
    EXPECT_EQ(sign_at(own, root, counters), Sign::kZero) << name.decimal;
    const auto& ids = event.event.certificate.ids;
    const bool has = std::count(ids.begin(), ids.end(), changed) > 0;
    if (has && compare(root, Rational(2), counters) > 0) ++after_the_change;
  }
  EXPECT_GT(after_the_change, 0);
}

TEST(ViewRecord, StagesSayWhoAnswered) {
  const auto stages = [](const Scene& scene, const char* arithmetic) {
    std::vector<view::StagesUsed> used;
    for (const view::RecordedEvent& event : record(scene, arithmetic).events) {
      EXPECT_EQ(event.stages.has_value(), event.event.certificate.arity > 0);
      if (event.stages) used.push_back(*event.stages);
    }
    EXPECT_FALSE(used.empty());
    return used;
  };
  const Scene easy = workload("uniform-square", 12, "sorted_list");
  const Scene hard = workload("near-one-point", 12, "sorted_list", 1);
  for (const view::StagesUsed& used : stages(easy, "sturm")) EXPECT_EQ(used.found, Stage::kExact);
  for (const view::StagesUsed& used : stages(hard, "double")) EXPECT_EQ(used.found, Stage::kDouble);
  for (const view::StagesUsed& used : stages(easy, "mpfr:90")) {
    EXPECT_EQ(used.found, Stage::kMultiprecision);
  }
  for (const view::StagesUsed& used : stages(easy, "exact")) EXPECT_EQ(used.found, Stage::kDouble);
  const std::vector<view::StagesUsed> near = stages(hard, "exact");
  EXPECT_TRUE(std::any_of(near.begin(), near.end(),
                          [](const view::StagesUsed& used) { return used.ordered == Stage::kExact; }));
}

TEST(ViewRecord, AWindowOfARunIsAPartOfIt) {
  const Scene scene = workload("uniform-square", 14, "sorted_list,delaunay_2");
  const view::RecordedRun whole = record(scene);
  view::RecordOptions options;
  options.from = Rational(Integer(1), Integer(3));
  options.max_events = 17;
  const view::RecordedRun part = view::record_run(scene, options);
  ASSERT_EQ(part.events.size(), 17u);
  EXPECT_FALSE(part.complete);
  EXPECT_EQ(part.stopped, "it has more than 17 log records");
  ASSERT_GT(part.before, 0u);
  for (std::uint64_t k = part.before; k <= part.before + 17; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(view::attribute_after(part.structures[i], k), view::attribute_after(whole.structures[i], k))
          << k;
    }
  }
  for (std::size_t i = 0; i < 17; ++i) {
    const view::RecordedEvent& a = part.events[i];
    const view::RecordedEvent& b = whole.events[part.before + i];
    EXPECT_EQ(part.instants[a.instant].name.decimal, whole.instants[b.instant].name.decimal);
    EXPECT_EQ(a.event.ids, b.event.ids);
  }
}

TEST(ViewRecord, AnArithmeticThatLeadsAstrayLeavesNoState) {
  const Scene scene = workload("grid", 36, "delaunay_2");
  const view::RecordedRun run = record(scene, "double");
  const view::RecordedStructure& structure = run.structures[0];
  ASSERT_TRUE(structure.corrupt_after);
  EXPECT_FALSE(structure.corruption.empty());
  EXPECT_TRUE(view::attribute_after(structure, *structure.corrupt_after - 1));
  EXPECT_FALSE(view::attribute_after(structure, *structure.corrupt_after));
}

TEST(ViewRecord, RunsPartWhereTheirLogsDo) {
  const Scene scene = workload("near-one-point", 8, "sorted_list", 1);
  const view::RecordedRun exact = record(scene), sturm = record(scene, "sturm");
  const view::RecordedRun rounded = record(scene, "double");
  EXPECT_EQ(view::first_divergence(exact, sturm), 0u);
  const std::uint64_t first = view::first_divergence(exact, rounded);
  ASSERT_GT(first, 0u);
  EXPECT_EQ(view::first_divergence(rounded, exact), first);
  const auto name = [&](const view::RecordedRun& run, std::uint64_t k) {
    const Event& event = run.all[k - 1];
    return std::pair(event.kind, event.ids);
  };
  for (std::uint64_t k = 1; k < first; ++k) EXPECT_EQ(name(exact, k), name(rounded, k));
  EXPECT_NE(name(exact, first), name(rounded, first));
  // A run that was stopped does not part where it stops.
  view::RecordOptions options;
  options.max_events = 5;
  EXPECT_EQ(view::first_divergence(exact, view::record_run(scene, options)), 0u);
}

TEST(ViewRecord, AnUnknownArithmeticIsRefused) {
  EXPECT_THROW(record(workload("meet", 4, "sorted_list"), "exakt"), formats::InputError);
}

TEST(AttributeChange, LeadsThereAndBack) {
  std::mt19937_64 random(7);
  using Shape = Attribute::Shape;
  const std::pair<Shape, std::uint8_t> kinds[] = {{Shape::kSequence, 2},
                                                  {Shape::kCycle, 2},
                                                  {Shape::kObject, 2},
                                                  {Shape::kTuples, 2},
                                                  {Shape::kTuples, 3}};
  for (const auto& [shape, width] : kinds) {
    Attribute last{shape, {}, width};
    for (int i = 0; i < 300; ++i) {
      Attribute next{shape, {}, width};
      if (shape == Shape::kTuples) {
        for (ObjectId a = 0; a < 6; ++a) {
          for (ObjectId b = a + 1; b < 6; ++b) {
            if (random() % 3 != 0) continue;
            if (width == 2) next.ids.insert(next.ids.end(), {a, b});
            for (ObjectId c = b + 1; c < 6 && width == 3; ++c) {
              if (random() % 2 == 0) next.ids.insert(next.ids.end(), {a, b, c});
            }
          }
        }
      } else {
        const std::size_t most = shape == Attribute::Shape::kObject ? 2 : 7;
        next.ids.resize(random() % most);
        for (ObjectId& id : next.ids) id = static_cast<ObjectId>(random() % 4);
      }
      view::AttributeChange change = view::difference(last, next);
      EXPECT_EQ(change.empty(), last == next);
      Attribute value = last;
      view::apply(change, value);
      EXPECT_EQ(value, next);
      std::swap(change.removed, change.added);
      view::apply(change, value);
      EXPECT_EQ(value, last);
      last = next;
    }
  }
}

TEST(AttributeChange, ASwapIsASwap) {
  const Attribute before{Attribute::Shape::kSequence, {0, 1, 2, 3, 4}};
  const Attribute after{Attribute::Shape::kSequence, {0, 1, 3, 2, 4}};
  const view::AttributeChange change = view::difference(before, after);
  EXPECT_EQ(change.at, 2u);
  EXPECT_EQ(change.removed, (std::vector<ObjectId>{2, 3}));
  EXPECT_EQ(change.added, (std::vector<ObjectId>{3, 2}));
  Attribute other{Attribute::Shape::kSequence, {4, 3, 2, 1, 0}};
  EXPECT_THROW(view::apply(change, other), std::logic_error);
}

}  // namespace record_test
}  // namespace kinex
