// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that overlap when they are first seen, in scenes that allow it: every structure against
// the witness, the events against the attribute, and all structures against each other.
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/engine/refused_change.h"
#include "experiments/formats/placed_body.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "structures/plan.h"
#include "tests/experiments/expect_input_error.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/structures/event_replay.h"

namespace kinex::test {
namespace overlapping_starts_test {

using Axes = std::vector<std::vector<Rational>>;
const Axes kRest{{0}, {0}, {1}, {0}};

Scene allowing(Scene scene) {
  scene.overlapping_starts = OverlappingStarts::kContact;
  return scene;
}

// "overlap a b @ t !", or another kind.
std::vector<std::string> told(const Trial& trial, std::uint8_t kind) {
  std::vector<std::string> lines;
  for (const Recorded& event : trial.sink.recorder.events) {
    if (event.kind != kind) continue;
    lines.push_back(trial.simulator.object_name(event.ids[0]) + " " +
                    trial.simulator.object_name(event.ids[1]) + " @ " + event.lower +
                    (event.external ? " !" : ""));
  }
  return lines;
}

// Events lead to the attribute at every instant.
void replay(const Scene& given, const std::string& name, const std::string& arithmetic) {
  Scene scene = given;
  scene.maintain = {{name, name, {}}};
  SimulatorOptions options;
  options.audit = AuditLevel::kEvents;
  Simulator simulator(scene, planned_arithmetic(arithmetic, scene), options);
  EventReplay replay(simulator);
  replay.add_structures(scene);
  simulator.set_sink(&replay);
  simulator.start();
  simulator.run_until(std::nullopt);
  for (const std::string& what : simulator.violations()) {
    if (simulator.kernel().is_exact() || what.find("replay: ") != std::string::npos) {
      ADD_FAILURE() << what;
    }
  }
}

// All checks of check_meetings; all structures tell the same overlaps, at the same instants.
std::vector<std::string> check(const Scene& scene, bool against_witness = true) {
  if (against_witness) check_meetings(scene);
  std::optional<std::vector<std::string>> all, met;
  for (const std::string& name : collision_structures(turns(scene))) {
    SCOPED_TRACE(name);
    Trial trial(scene, name, "exact", AuditLevel::kEvents);
    trial.sink.recorder.instants = 1u << 20;
    trial.without_twin().to_end();
    trial.expect_clean();
    const std::vector<std::string> overlaps = told(trial, CollisionEvent::kOverlap);
    if (!all) all = overlaps;
    EXPECT_EQ(*all, overlaps);
    const std::vector<std::string> meetings = features_named(trial);
    if (!met) met = meetings;
    EXPECT_EQ(*met, meetings);
    replay(scene, name, "exact");
    replay(scene, name, "double");
    if (testing::Test::HasFailure()) break;
  }
  return all.value_or(std::vector<std::string>{});
}

SceneObject from_to(SceneObject object, std::optional<Rational> from, std::optional<Rational> to) {
  object.motion.pieces[0].from = std::move(from);
  object.motion.pieces[0].to = std::move(to);
  return object;
}

Scene pair_of(const Axes& a, const Axes& b, const Rational& end) {
  return allowing(
      scene_of_bodies({body("a", square_of(1), a), body("b", square_of(1), b)}, 0, end));
}

using Lines = std::vector<std::string>;

TEST(OverlappingStarts, AtTheStart) {
  // b leaves a, inside which it starts: a separation at 2.
  const Scene leaves = pair_of(kRest, {{0, 1}, {0}, {1}, {0}}, 4);
  EXPECT_EQ(check(leaves), Lines{"a b @ 0 !"});
  for (const std::string& name : collision_structures(false)) {
    Trial trial(leaves, name);
    trial.sink.recorder.instants = 100;
    trial.to_end();
    EXPECT_EQ(told(trial, CollisionEvent::kSeparation), Lines{"a b @ 2 !"}) << name;
    EXPECT_EQ(trial.ledger().external, 2u) << name;
  }
  // Equal and at rest for all time; one inside the other, turning; they come back.
  EXPECT_EQ(check(pair_of(kRest, kRest, 2)), Lines{"a b @ 0 !"});
  EXPECT_EQ(check(pair_of(kRest, {{0}, {0}, {1}, {0, 1}}, 2)), Lines{"a b @ 0 !"});
  EXPECT_EQ(check(pair_of(kRest, {{0, 4, -1}, {0}, {1}, {0}}, 6)), Lines{"a b @ 0 !"});
}

TEST(OverlappingStarts, TouchAndGo) {
  // They touch along a side or at a corner; from there b penetrates, leaves or stays.
  EXPECT_EQ(check(pair_of(kRest, {{2, -1}, {0}, {1}, {0}}, 5)), Lines{"a b @ 0 !"});
  EXPECT_EQ(check(pair_of(kRest, {{2, 1}, {0}, {1}, {0}}, 2)), Lines{});
  EXPECT_EQ(check(pair_of(kRest, {{2}, {0}, {1}, {0}}, 2)), Lines{});
  EXPECT_EQ(check(pair_of(kRest, {{2, -1}, {2, -1}, {1}, {0}}, 5)), Lines{"a b @ 0 !"});
  EXPECT_EQ(check(pair_of(kRest, {{2, 0, -1}, {0}, {1}, {0}}, 5)), Lines{"a b @ 0 !"});
}

TEST(OverlappingStarts, WhenABodyAppearsOrJumps) {
  const formats::Polygon2 p = square_of(1);
  const SceneObject a = body("a", p, kRest), far = body("far", p, {{20}, {0}, {1}, {0}});
  for (const bool crowd : {false, true}) {  // with a grid, or without
    const auto scene = [&](SceneObject b) {
      std::vector<SceneObject> bodies{a, std::move(b)};
      if (crowd) bodies.push_back(far);
      Scene result = allowing(scene_of_bodies(std::move(bodies), 0, 9));
      result.jumps = true;
      return result;
    };
    // Appears inside and leaves; appears touching and penetrates; goes while it overlaps.
    EXPECT_EQ(check(scene(from_to(body("b", p, {{-2, 1}, {0}, {1}, {0}}), 1, std::nullopt))),
              Lines{"a b @ 1 !"});
    EXPECT_EQ(check(scene(from_to(body("b", p, {{3, -1}, {0}, {1}, {0}}), 1, std::nullopt))),
              Lines{"a b @ 1 !"});
    EXPECT_EQ(check(scene(from_to(body("b", p, {{0}, {0}, {1}, {0}}), 1, Rational(2)))),
              Lines{"a b @ 1 !"});
    // Jumps from the inside to the inside, and in from afar.
    SceneObject b = from_to(body("b", p, {{0}, {1}, {1}, {0}}), std::nullopt, Rational(2));
    b.motion.pieces.push_back({Rational(2), Rational(3), trajectory({{1}, {0}, {1}, {0}})});
    b.motion.pieces.push_back({Rational(3), Rational(4), trajectory({{9}, {0}, {1}, {0}})});
    b.motion.pieces.push_back({Rational(4), std::nullopt, trajectory({{-4, 1}, {0}, {1}, {0}})});
    EXPECT_EQ(check(scene(b)), (Lines{"a b @ 0 !", "a b @ 2 !", "a b @ 4 !"}));
    if (HasFailure()) return;
  }
}

// Several at one instant, in the order in which they come, and of the others.
TEST(OverlappingStarts, ManyAtOnce) {
  std::vector<SceneObject> bodies;
  for (int i = 0; i < 5; ++i) {
    SceneObject one = body("b" + std::to_string(i), square_of(1), {{i, i % 2}, {0}, {1}, {0}});
    if (i == 1 || i == 3) one = from_to(std::move(one), Rational(1), std::nullopt);
    bodies.push_back(std::move(one));
  }
  EXPECT_EQ(check(allowing(scene_of_bodies(std::move(bodies), 0, 3))),
            (Lines{"b1 b2 @ 1 !", "b1 b4 @ 1 !", "b3 b4 @ 1 !"}));
}

// Crowds of polygons that come and go and jump anywhere: after every instant the contacts are those
// that an exact look at the positions finds (the audit), and a body that appears reports all of its contacts.
// On a lattice a body may touch another at the instant at which it jumps, a graze that the witness
// does not tell from an appearance; otherwise places are multiples of 1/97.
Scene random_crowd(std::uint64_t seed, int n, bool turning, bool lattice) {
  std::mt19937_64 random(seed);
  const auto draw = [&random](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  std::vector<SceneObject> bodies;
  for (int i = 0; i < n; ++i) {
    SceneObject one{"b" + std::to_string(i), {}, random_polygon(random, 6, 2)};
    Rational at(draw(0, 1));
    while (at < Rational(6)) {
      Rational to = at + Rational(draw(1, 3));
      if (Rational(6) < to) to = Rational(6);
      const auto place = [&] {
        return lattice ? Rational(draw(-4, 4)) : Rational(Integer(draw(-388, 388)), Integer(97));
      };
      Axes axes{{place(), draw(-2, 2)}, {place(), draw(-2, 2)}, {1}, {0}};
      if (turning) axes[3] = {draw(-1, 1), Rational(Integer(draw(-2, 2)), Integer(7))};
      one.motion.pieces.push_back({at, to, trajectory(axes)});
      at = to + Rational(draw(0, 1));
    }
    bodies.push_back(std::move(one));
  }
  Scene scene = allowing(scene_of_bodies(std::move(bodies), 0, 6));
  scene.jumps = true;
  return scene;
}

void check_crowds(std::uint64_t seeds) {
  std::size_t overlaps = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool lattice = seed % 3 == 0;
    const int n = 2 + static_cast<int>(seed % 5) / 2;
    overlaps += check(random_crowd(seed, n, seed % 2 == 0, lattice), !lattice).size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(overlaps, seeds / 2);
}

TEST(OverlappingStarts, Crowds) { check_crowds(8); }

TEST(SlowOverlappingStarts, Crowds) { check_crowds(150); }

// ---- files

std::string scene_text(const std::string& starts, const std::string& from) {
  return R"({"kinex": 1, "dimension": 2, "time": {"start": 0, "end": 9}, )" + starts +
         R"("objects": [
    {"id": "a", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "motion": [[0], [0]]},
    {"id": "b", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
     "motion": [{"from": )" +
         from + R"(, "coordinates": [[1], [0]]}]}]})";
}

TEST(OverlappingStarts, ScenesSay) {
  const auto parse = [](const std::string& starts, const std::string& from) {
    return formats::parse_scene(scene_text(starts, from), "s.json");
  };
  const std::string contact = R"("overlapping_starts": "contact", )";
  for (const char* from : {"0", "1"}) {
    const Scene scene = parse(contact, from);
    EXPECT_EQ(scene.overlapping_starts, OverlappingStarts::kContact);
    const Scene again = formats::parse_scene(formats::write_scene(scene), "again.json");
    EXPECT_EQ(again.overlapping_starts, OverlappingStarts::kContact);
    for (const std::string& starts :
         {std::string(), std::string(R"("overlapping_starts": "refused", )")}) {
      try {
        parse(starts, from);
        ADD_FAILURE();
      } catch (const formats::InputError& error) {
        EXPECT_NE(error.remedy().find(R"(say "overlapping_starts": "contact" (not "refused")"),
                  std::string::npos)
            << error.remedy();
      }
    }
  }
  EXPECT_INPUT_ERROR(parse(R"("overlapping_starts": "merge", )", "0"),
                     "\"merge\" is no choice for bodies that start overlapping; write \"refused\"");
  EXPECT_INPUT_ERROR(parse(R"("overlapping_starts": true, )", "0"), "/overlapping_starts");
}

// A refusal at an instant inside the run names its time, shortly.
TEST(OverlappingStarts, ARefusalHasATime) {
  const Rational late = Rational(1) + Rational(Integer(1), Integer::power_of_two(200));
  const SceneObject b = from_to(body("b", square_of(1), {{Rational(2) + late, -1}, {0}, {1}, {0}}),
                                late, std::nullopt);
  const Scene scene = scene_of_bodies({body("a", square_of(1), kRest), b}, 0, 9);
  for (const std::string& name : collision_structures(false)) {
    Trial trial(scene, name);
    try {
      trial.to_end();
      ADD_FAILURE() << name;
    } catch (const RefusedChange& change) {
      EXPECT_EQ(change.time(), late);
      const std::string what = change.what();
      EXPECT_EQ(
          what.rfind("\"b\" appears at about 1 in contact with \"a\"; let it come, or jump, ", 0),
          0u)
          << what;
      EXPECT_NE(what.find("\"overlapping_starts\": \"contact\""), std::string::npos) << what;
    }
  }
}

}  // namespace overlapping_starts_test
}  // namespace kinex::test
