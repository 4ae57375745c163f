// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate and extreme scenes of bodies, every structure against the witness: parallel edges,
// paths along sides and through corners of tiles, touches, changes of motion, huge and tiny
// numbers.
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/formats/scene_reader.h"
#include "experiments/lab/workload.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/places.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_degenerate_test {

using Axes = std::vector<std::vector<Rational>>;

formats::Polygon2 negated(formats::Polygon2 polygon) {
  for (Vertex2& v : polygon) v = {-v[0], -v[1]};
  return polygon;
}

std::size_t check_pair(formats::Polygon2 a, const Axes& motion_a, formats::Polygon2 b, const Axes& motion_b,
                       const Rational& from, const Rational& to) {
  return check_runs(scene_of_bodies(
      {body("a", std::move(a), motion_a), body("b", std::move(b), motion_b)}, from, to));
}

const Axes kRest{{0}, {0}, {1}, {0}};

TEST(CollisionDegenerate, ScenesOfTheCorpus) {
  const std::string folder = KINEX_SOURCE_DIR "/tests/corpus/scenes/good";
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (name.rfind("bodies", 0) != 0) continue;
    SCOPED_TRACE(name);
    ++scenes;
    check_runs(formats::read_scene(file.path().string()));
  }
  EXPECT_GE(scenes, 26);
}

// A jump from one contact to another is refused, whatever names the instant.
TEST(CollisionDegenerate, JumpsFromContactToContact) {
  const formats::Polygon2 square = square_of(1);
  SceneObject b = body("b", square, {{4, -1}, {0}, {1}, {0}});
  b.motion.pieces[0].to = Rational(2);
  b.motion.pieces.push_back({Rational(2), std::nullopt, trajectory({{0}, {1}, {1}, {0}})});
  Scene scene = scene_of_bodies({body("a", square, kRest), b}, 0, 4);
  scene.jumps = true;
  for (const char* arithmetic : {"exact", "sturm"}) {
    for (const std::string& name : collision_structures(false)) {
      Trial trial(scene, name, arithmetic, AuditLevel::kNone);
      EXPECT_THROW(trial.to_end(), std::invalid_argument) << name;
    }
  }
}

// A square meets a square: side by side, corner to corner, corner to side; and only touches.
TEST(CollisionDegenerate, Squares) {
  const formats::Polygon2 square = square_of(1);
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {0}, {1}, {0}}, 0, 9), 1u);
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {5, -1}, {1}, {0}}, 0, 9), 1u);
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {ratio(1, 3)}, {1}, {1}}, 0, 9), 1u);
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {2}, {1}, {0}}, 0, 9), 0u);  // slides by
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {-1, 1}, {1}, {0}}, 0, 9), 0u);  // corners
  EXPECT_EQ(check_pair(square, kRest, square, {{5, -1}, {3, -1, 1}, {1}, {0}}, 0, 9), 0u);
  EXPECT_EQ(check_pair(square, kRest, square, {{3, -2, 1}, {0}, {1}, {0}}, 0, 9), 0u);  // comes up
  EXPECT_EQ(check_pair(square, kRest, square, {{3, -3, 3, -1}, {0}, {1}, {0}}, 0, 9), 1u);
  // A triple root: the corners pass with the speed zero.
  EXPECT_EQ(check_pair(square, kRest, square, {{3, -3, 3, -1}, {3, -3, 3, -1}, {1}, {0}}, 0, 9),
            1u);
}

// B' = A: all normals coincide at once as the body turns through the pose, at rest and in passing,
// with the point on corners and sides of tiles at that instant.
TEST(CollisionDegenerate, TwinsTurnThroughParallelity) {
  std::mt19937_64 random(3);
  std::vector<formats::Polygon2> polygons{square_of(1), box(-2, -1, 2, 1), {{0, 0}, {5, 1}, {2, 7}}};
  for (int i = 0; i < (kSanitized ? 1 : 4); ++i) polygons.push_back(random_polygon(random, 9, 4));
  for (const formats::Polygon2& p : polygons) {
    const formats::Polygon2 q = negated(p);
    for (const int x : {11, 14, 17}) {
      SCOPED_TRACE(x);
      check_pair(p, kRest, q, {{x}, {0}, {1}, {0, 1}}, -2, 2);
      check_pair(p, kRest, q, {{x}, {0, 1}, {1}, {0, 1}}, -2, 2);
      check_pair(p, kRest, q, {{x, -3}, {x, -3}, {1}, {0, 1}}, -1, 5);
      check_pair(p, {{0}, {0}, {1}, {0, 1}}, q, {{x, -2}, {1}, {1}, {0, 1}}, -1, 9);
      if (HasFailure()) return;
    }
  }
}

// Integer polygons that do not turn, or are turned by quarters, on lines of the grid: along sides,
// through corners.
TEST(CollisionDegenerate, LinesOfTheGrid) {
  std::mt19937_64 random(8);
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  std::size_t contacts = 0;
  const int rounds = kSanitized ? 6 : 40;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const formats::Polygon2 p = random_polygon(random, draw(3, 9), 3);
    const formats::Polygon2 q = random_polygon(random, draw(3, 9), 3);
    const std::array<std::array<int, 2>, 5> ways{{{1, 0}, {1, 1}, {1, -1}, {2, 1}, {1, -2}}};
    const auto& way = ways[static_cast<std::size_t>(draw(0, 4))];
    const int quarter = draw(0, 1), offset = draw(-7, 7);
    const Axes motion{{-12 * way[0], way[0]}, {offset - 12 * way[1], way[1]}, {1}, {quarter}};
    contacts += check_pair(p, {{0}, {0}, {1}, {quarter}}, q, motion, 0, 24);
    if (HasFailure()) return;
  }
  EXPECT_GE(contacts, static_cast<std::size_t>(rounds / 5));
  EXPECT_LT(contacts, static_cast<std::size_t>(rounds));
}

// Touches without penetration, by the witness too: what touches, when, for how long.
TEST(CollisionDegenerate, Grazes) {
  const formats::Polygon2 square = square_of(1), wedge{{0, 0}, {1, 2}, {-1, 2}};
  int scene = 0;
  const auto expect = [&](const formats::Polygon2& a, const formats::Polygon2& b, const Axes& motion, int end,
                          std::size_t contacts, std::size_t grazes) {
    SCOPED_TRACE(++scene);
    const MeetingCounts found =
        check_meetings(scene_of_bodies({body("a", a, kRest), body("b", b, motion)}, 0, end));
    EXPECT_EQ(found.contacts, contacts);
    EXPECT_EQ(found.grazes, grazes);
  };
  // A corner slides past a corner: an instant at which certificates fail.
  expect(square, square, {{5, -1}, {-1, 1}, {1}, {0}}, 9, 0, 1);
  // A parabola comes down on an edge, and on a corner; a double root.
  expect(square, wedge, {{0}, {2, -2, 1}, {1}, {0}}, 9, 0, 1);
  expect(square, wedge, {{1}, {2, -2, 1}, {1}, {0}}, 9, 0, 1);
  expect(square, square, {{3, -2, 1}, {3, -2, 1}, {1}, {0}}, 9, 0, 1);
  expect(square, square, {{3, -2, 1}, {ratio(1, 3)}, {1}, {0}}, 9, 0, 1);
  // Twice at the same place, by (t - 1)^2 (t - 3)^2; a root of multiplicity 4.
  expect(square, wedge, {{0}, {10, -24, 22, -8, 1}, {1}, {0}}, 9, 0, 2);
  expect(square, wedge, {{0}, {2, -4, 6, -4, 1}, {1}, {0}}, 9, 0, 1);
  // A graze, and then a contact: 1 + (t - 1)^2 (3 - t).
  expect(square, wedge, {{0}, {4, -7, 5, -1}, {1}, {0}}, 9, 1, 1);
  // A bar of half-length 5 that turns beside a wall: its ends touch it, a quarter of a turn after
  // the start and three quarters.
  const formats::Polygon2 bar{{-5, 0}, {0, ratio(-1, 4)}, {5, 0}}, wall = box(-1, 5, 1, 7);
  expect(wall, bar, {{0}, {0}, {1, -1}, {0, 1}}, 1, 0, 1);
  // A square of half-diagonal 5 turns beside it.
  const formats::Polygon2 diamond{{-3, -4}, {4, -3}, {3, 4}, {-4, 3}};
  expect(wall, diamond, {{0}, {0}, {1, -1}, {0, 1}}, 1, 0, 2);
  // And lands flush, side on side, at the instant at which it comes up to it.
  expect(box(-1, 1, 1, 2), square, {{0}, {-1, 2, -1}, {1}, {-1, 1}}, 3, 1, 0);
  // A slide along a side is one graze, over two collinear sides and from a corner on; and it may
  // end in the other body.
  expect(square, square, {{5, -1}, {2}, {1}, {0}}, 9, 0, 1);
  expect(square, wedge, {{-3, 1}, {1}, {1}, {0}}, 9, 0, 1);
  // To and fro on the line of a side: it comes, goes, and comes again; or only to the corner.
  expect(square, wedge, {{-2, 3, -1}, {1}, {1}, {0}}, 3, 0, 1);
  expect(square, wedge, {{-5, 9, -6, 1}, {1}, {1}, {0}}, 9, 0, 2);
  expect(square, wedge, {{-2, 2, -1}, {1}, {1}, {0}}, 3, 0, 1);
  // A triangle turns about a corner that is on the floor from the start.
  expect(box(-9, -1, 9, 0), {{0, 0}, {4, 0}, {4, 3}}, {{0}, {0}, {1}, {2, -1}}, 1, 0, 0);
}

// A touch at the seam of two flight plans; and a rest, with what follows it.
TEST(CollisionDegenerate, GrazesAtSeams) {
  const auto with = [](std::vector<MotionPiece> pieces, const Rational& end) {
    SceneObject b{"b", {std::move(pieces)}, square_of(1)};
    return check_meetings(scene_of_bodies({body("a", square_of(1), kRest), std::move(b)}, 0, end));
  };
  const auto part = [](const Rational& from, const Rational& to, Axes axes) {
    return MotionPiece{from, to, trajectory(std::move(axes))};
  };
  EXPECT_EQ(with({part(0, ratio(3, 2), {{5, -2}, {0}, {1}, {0}}),
                  part(ratio(3, 2), 4, {{-1, 2}, {0}, {1}, {0}})},
                 4)
                .grazes,
            1u);
  // It stops at the touch and rests; then it slides off, and comes back.
  const MeetingCounts rest =
      with({part(0, 3, {{5, -1}, {0}, {1}, {0}}), part(3, 4, {{2}, {0}, {1}, {0}}),
            part(4, 8, {{2}, {-4, 1}, {1}, {0}}), part(8, 16, {{2}, {12, -1}, {1}, {0}})},
           16);
  EXPECT_EQ(rest.contacts, 0u);
  EXPECT_EQ(rest.grazes, 2u);
}

// Both move as one: nothing ever changes.
TEST(CollisionDegenerate, MoveAsOne) {
  const formats::Polygon2 p{{0, 0}, {5, 1}, {2, 7}};
  Scene scene = scene_of_bodies(
      {body("a", p, {{0, 1, 3}, {0, -2}, {1}, {0}}), body("b", p, {{6, 1, 3}, {1, -2}, {1}, {0}})},
      0, 9);
  EXPECT_EQ(check_runs(scene), 0u);
  for (const std::string& name : collision_structures(false)) {
    Trial trial(scene, name);
    trial.to_end();
    EXPECT_EQ(trial.ledger().processed, 0u) << name;
  }
}

Scene with_pieces(std::vector<MotionPiece> pieces, const Rational& end) {
  SceneObject b{"b", {std::move(pieces)}, square_of(1)};
  return scene_of_bodies({body("a", square_of(1), kRest), std::move(b)}, 0, end);
}

MotionPiece piece(const Rational& from, const Rational& to, Axes axes) {
  return {from, to, trajectory(std::move(axes))};
}

// Turned back at the instant of the touch, after it, and then coming again.
TEST(CollisionDegenerate, Bounces) {
  EXPECT_EQ(check_runs(with_pieces({piece(0, ratio(3, 2), {{5, -2}, {0}, {1}, {0}}),
                                    piece(ratio(3, 2), 4, {{-1, 2}, {0}, {1}, {0}})},
                                   4)),
            0u);
  EXPECT_EQ(check_runs(with_pieces(
                {piece(0, 2, {{5, -2}, {0}, {1}, {0}}), piece(2, 4, {{-3, 2}, {0}, {1}, {0}}),
                 piece(4, 8, {{13, -2}, {0}, {1}, {0}})},
                8)),
            2u);
  // It stops at the touch, rests in touch, and then moves in, along, or away.
  const auto stop = [](Axes then) {
    return with_pieces({piece(0, 3, {{5, -1}, {0}, {1}, {0}}), piece(3, 4, {{2}, {0}, {1}, {0}}),
                        piece(4, 6, std::move(then))},
                       6);
  };
  EXPECT_EQ(check_runs(stop({{6, -1}, {0}, {1}, {0}})), 1u);
  EXPECT_EQ(check_runs(stop({{2}, {-4, 1}, {1}, {0}})), 0u);
  EXPECT_EQ(check_runs(stop({{-2, 1}, {0}, {1}, {0}})), 0u);
  EXPECT_EQ(check_runs(stop({{2}, {0}, {1}, {-4, 1}})), 1u);  // it turns, with a corner into a
}

// The ends of the bodies' lives, jumps, and changes from outside.
TEST(CollisionDegenerate, ComeAndGo) {
  for (const std::string& name : collision_structures(false)) {
    SCOPED_TRACE(name);
    const Scene scene = scene_of_bodies(
        {body("a", square_of(1), kRest), body("b", square_of(1), {{5, -1}, {0}, {1}, {0}}),
         body("c", square_of(1), {{0}, {9, -1}, {1}, {0}})},
        0, 20);
    Trial trial(scene, name);
    trial.run_until(4);  // a and b have met at 3
    EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 1}));
    trial.erase(4, 1);
    trial.run_until(5);
    EXPECT_TRUE(trial.ids().empty());
    trial.insert(6, 1, trajectory({{11, -1}, {20}, {1}, {0}}));  // far above
    trial.run_until(8);                                          // a and c have met at 7
    EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 2}));
    trial.erase(9, 0);
    trial.insert(10, 0, trajectory({{11, -1}, {12, ratio(1, 2)}, {1}, {0}}));  // below b, rising
    trial.run_until(10);
    EXPECT_TRUE(trial.ids().empty());
    trial.run_until(12);
    EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 1}));
    trial.to_end();
    trial.expect_clean();
  }
}

TEST(CollisionDegenerate, Jumps) {
  Scene scene =
      with_pieces({piece(0, 1, {{5}, {0}, {1}, {0}}), piece(1, 2, {{-5}, {0}, {1}, {0}}),
                   piece(2, 3, {{2}, {0}, {1}, {0}}), piece(3, 9, {{8, -1}, {0}, {1}, {1}})},
                  9);
  scene.jumps = true;
  for (const std::string& name : collision_structures(true)) {
    SCOPED_TRACE(name);
    Trial trial(scene, name);
    trial.run_until(ratio(5, 2));
    EXPECT_TRUE(trial.ids().empty());  // it touches the other
    trial.run_until(4);
    EXPECT_TRUE(trial.ids().empty());
    trial.to_end();
    EXPECT_EQ(trial.ids(), (std::vector<ObjectId>{0, 1}));
    trial.expect_clean();
  }
}

// A body cannot appear inside another, nor jump there, nor appear in touch and go on into it.
TEST(CollisionDegenerate, NobodyAppearsInContact) {
  const auto refused = [](const Scene& scene, const char* what) {
    for (const std::string& name : collision_structures(true)) {
      SCOPED_TRACE(name);
      Trial trial(scene, name);
      try {
        trial.to_end();
        ADD_FAILURE() << "not refused";
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).rfind(what, 0), 0u) << error.what();
      }
      if (testing::Test::HasFailure()) return;
    }
  };
  Scene jump = with_pieces({piece(0, ratio(2, 3), {{5}, {0}, {1}, {0}}),
                            piece(ratio(2, 3), 2, {{ratio(1, 2)}, {0}, {1}, {0}})},
                           2);
  jump.jumps = true;
  refused(jump, "\"b\" appears at 2/3 (0.6666666667) in contact with \"a\"; ");
  refused(with_pieces({piece(1, 2, {{-1}, {0}, {1}, {0}})}, 2),
          "\"b\" appears at 1 in contact with \"a\"; ");
  refused(with_pieces({piece(1, 2, {{3, -1}, {0}, {1}, {0}})}, 2), "\"b\" appears at 1 in ");
  Scene crowd = with_pieces({piece(1, 2, {{-1}, {0}, {1}, {0}})}, 2);
  crowd.objects.push_back(body("c", square_of(1), {{9}, {0}, {1}, {0}}));
  refused(crowd, "\"b\" appears at 1 in contact with \"a\"; ");
}

// The same scene in all sizes of space and of time.
TEST(CollisionDegenerate, HugeAndTiny) {
  const formats::Polygon2 p{{-3, -2}, {4, -1}, {2, 3}, {-1, 4}}, q{{0, -2}, {3, 0}, {1, 3}, {-2, 2}};
  for (const char* size : {"1e30", "1e-30", "1e-300", "7e150"}) {
    for (const char* speed : {"1", "1e25", "1e-25"}) {
      SCOPED_TRACE(std::string(size) + " " + speed);
      const Rational k = *Rational::parse(size), v = *Rational::parse(speed);
      const auto scaled = [&](formats::Polygon2 polygon) {
        for (Vertex2& vertex : polygon) vertex = {vertex[0] * k, vertex[1] * k};
        return polygon;
      };
      const std::size_t contacts = check_pair(
          scaled(p), {{0}, {0}, {1}, {0, v}}, scaled(q),
          {{Rational(12) * k, Rational(-5) * k * v}, {Rational(-2) * k, k * v}, {1, v}, {0, -v}}, 0,
          Rational(4) / v);
      EXPECT_EQ(contacts, 1u);
      if (HasFailure()) return;
    }
  }
  // A large body and a small one, far from the origin.
  const Rational far = *Rational::parse("1e20"), small = *Rational::parse("1e-15");
  formats::Polygon2 grain = q;
  for (Vertex2& vertex : grain) vertex = {vertex[0] * small, vertex[1] * small};
  EXPECT_EQ(check_pair(p, {{far}, {far}, {1}, {0, 1}}, grain,
                       {{far + Rational(9), -4}, {far, ratio(1, 3)}, {1}, {0, 1}}, 0, 4),
            1u);
}

// All pairs of a crowd.
TEST(CollisionDegenerate, Crowds) {
  std::size_t contacts = 0;
  for (const int n : {8, kSanitized ? 9 : 20}) {
    lab::WorkloadParameters parameters;
    parameters.n = n;
    parameters.m = n > 10 ? 4 : 6;
    parameters.seed = 3;
    const Scene scene = lab::generate_scene(*lab::find_workload("polygons-in-box"), parameters);
    contacts += check_runs(scene, n > 10 ? AuditLevel::kEnd : AuditLevel::kEvents);
  }
  EXPECT_GE(contacts, 3u);
}

}  // namespace collision_degenerate_test
}  // namespace kinex::test
