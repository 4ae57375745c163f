// SPDX-License-Identifier: GPL-3.0-or-later
// From a contact to the separation and to the next contact: every structure against the witness, on
// ways through vertices and through the middle, along sides, and through changes of flight plans.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_overlap_test {

using Axes = std::vector<std::vector<Rational>>;
const Axes kRest{{0}, {0}, {1}, {0}};

// The numbers of contacts and separations.
using Turns = std::pair<std::size_t, std::size_t>;

Turns run(SceneObject a, SceneObject b, const Rational& from, const Rational& to) {
  const MeetingCounts counts =
      check_meetings(scene_of_bodies({std::move(a), std::move(b)}, from, to));
  return {counts.contacts, counts.separations};
}

Turns run_pair(const formats::Polygon2& p, const Axes& a, const formats::Polygon2& q, const Axes& b,
               const Rational& to) {
  return run(body("a", p, a), body("b", q, b), 0, to);
}

// 0, 1 or 2 of both, by hand: unit squares, b comes, turns back inside or beyond, or goes through.
TEST(CollisionOverlap, SquaresComeAndGo) {
  const formats::Polygon2 p = box(0, 0, 1, 1);
  EXPECT_EQ(run_pair(p, kRest, p, {{6, -6, 1}, {0}, {1}, {0}}, 6), (Turns{2, 2}));
  EXPECT_EQ(run_pair(p, kRest, p, {{6, -6, 1}, {0}, {1}, {0}}, 3), (Turns{1, 1}));
  EXPECT_EQ(run_pair(p, kRest, p, {{5, -5, ratio(5, 4)}, {0}, {1}, {0}}, 6), (Turns{1, 1}));
  EXPECT_EQ(run_pair(p, kRest, p, {{5, -4, 1}, {0}, {1}, {0}}, 6), (Turns{0, 0}));  // graze
  EXPECT_EQ(run_pair(p, kRest, p, {{5, -1}, {ratio(1, 3)}, {1}, {0}}, 5), (Turns{1, 0}));
  // The last instant belongs to the run.
  EXPECT_EQ(run_pair(p, kRest, p, {{5, -1}, {0}, {1}, {0}}, 6), (Turns{1, 1}));
  EXPECT_EQ(run_pair(p, kRest, p, {{5, -1}, {0}, {1}, {0}}, 4), (Turns{1, 0}));
}

// Through vertices of the sum, along its diagonals, and through the point that rays come from.
TEST(CollisionOverlap, ThroughTheMiddleAndTheCorners) {
  const formats::Polygon2 square = square_of(1), triangle{{-1, -1}, {2, -1}, {-1, 2}};
  for (const formats::Polygon2& p : {square, triangle}) {
    for (const int dx : {1, 2, 0, -1}) {
      for (const int dy : {1, 0, -2}) {
        if ((dx == 0 && dy == 0) || (kSanitized && dx * dy != 1)) continue;
        SCOPED_TRACE(std::to_string(dx) + " " + std::to_string(dy));
        for (const int quarter : {0, 1}) {  // not turned, or by a quarter
          const Axes line{{-9 * dx, dx}, {-9 * dy, dy}, {1}, {quarter}};
          EXPECT_EQ(run_pair(p, kRest, p, line, 20), (Turns{1, 1}));
        }
        const Axes turning{{-9 * dx, dx}, {-9 * dy, dy}, {9, -1}, {1}};
        const Turns turns = run_pair(p, kRest, p, turning, 20);
        EXPECT_EQ(turns.first, turns.second);
        if (HasFailure()) return;
      }
    }
  }
}

// b comes to rest in a's place and stays, leaves it, turns on the spot, slides out along a side.
TEST(CollisionOverlap, FlightPlansInside) {
  const formats::Polygon2 p = box(0, 0, 1, 1), triangle{{0, 0}, {4, 0}, {0, 4}};
  const auto with = [](const formats::Polygon2& polygon, const std::vector<Axes>& plans) {
    SceneObject result = body("b", polygon, plans[0]);
    for (std::size_t i = 1; i < plans.size(); ++i) {
      const Rational seam(static_cast<int>(i));
      result.motion.pieces.back().to = seam;
      result.motion.pieces.push_back({seam, std::nullopt, trajectory(plans[i])});
    }
    return result;
  };
  const SceneObject a = body("a", p, kRest);
  const Axes come{{2, -2}, {0}, {1}, {0}}, rest{{0}, {0}, {1}, {0}};
  EXPECT_EQ(run(a, with(p, {come, rest}), 0, 5), (Turns{1, 0}));
  EXPECT_EQ(run(a, with(p, {come, rest, {{0}, {-4, 2}, {1}, {0}}}), 0, 5), (Turns{1, 1}));
  EXPECT_EQ(run(a, with(p, {come, {{0}, {0}, {2, -1}, {-1, 1}}, {{-4, 2}, {0}, {0}, {1}}}), 0, 5),
            (Turns{1, 1}));
  // To the boundary from inside, and then along it, out and back, back at once, out at once.
  const Axes out{{-2, 2}, {0}, {1}, {0}};  // from 0 at 1 to 2 at 2; at the boundary at 3/2
  const Axes to_edge{{-1, 1}, {0}, {1}, {0}};
  EXPECT_EQ(run(a, with(p, {come, out}), 0, 5), (Turns{1, 1}));
  EXPECT_EQ(run(a, with(p, {come, to_edge, {{1}, {-2, 1}, {1}, {0}}}), 0, 5), (Turns{1, 1}));
  EXPECT_EQ(run(a, with(p, {come, to_edge, {{5, -2}, {0}, {1}, {0}}}), 0, 4), (Turns{1, 1}));
  EXPECT_EQ(run(a, with(p, {come, to_edge, {{1}, {0}, {1}, {0}}, {{-2, 1}, {0}, {1}, {0}}}), 0, 5),
            (Turns{1, 1}));
  // Slides out along a side and back in over it: one separation, one contact more.
  EXPECT_EQ(run(a,
                with(p, {come,
                         to_edge,
                         {{1}, {-1, ratio(1, 2)}, {1}, {0}},
                         {{4, -1}, {ratio(1, 2)}, {1}, {0}}}),
                0, 4),
            (Turns{2, 1}));
  // Touches the boundary from inside and goes back: no event.
  EXPECT_EQ(run(a, with(p, {come, {{-3, 4, -1}, {0}, {1}, {0}}}), 0, 3), (Turns{1, 0}));
  EXPECT_EQ(run(body("a", triangle, kRest), with(triangle, {{{9, -9}, {0}, {1}, {0}}, rest}), 0, 4),
            (Turns{1, 0}));
}

// Bodies that overlap when they appear are in contact from there on, in a scene made by hand; the
// separation is an event.
TEST(CollisionOverlap, FromTheStart) {
  std::mt19937_64 random(21);
  for (int round = 0; round < (kSanitized ? 3 : 12); ++round) {
    const formats::Polygon2 p = random_polygon(random, 12, 4), q = random_polygon(random, 7, 4);
    const SceneObject a = body("a", p, {{0}, {0}, {1}, {0, round % 3}});
    const SceneObject b = body("b", q, {{0, 1}, {0, round % 2}, {1, 1}, {0, 1}});
    EXPECT_EQ(run(a, b, 0, 40), (Turns{0, 1}));
  }
}

// A long bar that turns about its middle in a ring of posts: each is hit twice a turn by each end.
TEST(CollisionOverlap, BarAmongPosts) {
  std::vector<SceneObject> bodies;
  const formats::Polygon2 bar{{-4, ratio(-1, 4)}, {4, ratio(-1, 4)}, {4, ratio(1, 4)}, {-4, ratio(1, 4)}};
  // Half a turn of the rotor is a turn of the body: two turns of the bar's ends past every post.
  SceneObject turning = body("bar", bar, {{0}, {0}, {1, -1}, {0, 1}});
  turning.motion.pieces[0].to = Rational(1);
  turning.motion.pieces.push_back(
      {Rational(1), std::nullopt, trajectory({{0}, {0}, {1, -1}, {2, -1}})});
  bodies.push_back(turning);
  const int posts[5][2] = {{2, 2}, {-2, 3}, {-3, -1}, {0, -3}, {3, -2}};
  for (int i = 0; i < 5; ++i) {
    const formats::Polygon2 post{{0, 0}, {ratio(1, 3), 0}, {0, ratio(1, 2)}};
    bodies.push_back(
        body("post " + std::to_string(i), post, {{posts[i][0]}, {posts[i][1]}, {1}, {0}}));
  }
  const MeetingCounts counts = check_meetings(scene_of_bodies(std::move(bodies), 0, 2));
  EXPECT_EQ(counts.contacts, 10u);
  EXPECT_EQ(counts.separations, 10u);
}

// The certificates that failed while bodies overlapped, by predicate.
std::map<std::string, int> failed_inside(const Scene& scene) {
  Trial trial(scene, "separation_mixed", "exact", AuditLevel::kEvents);
  trial.to_end();
  trial.expect_clean();
  std::map<std::string, int> failed;
  const Recorder& seen = trial.sink.recorder;
  for (std::size_t i = 0; i < seen.events.size(); ++i) {
    if (seen.events[i].kind == CollisionEvent::kInside) ++failed[seen.predicates[i]];
  }
  return failed;
}

// Squares of side 2 that pass through each other. Among three bodies discs within them are the
// proof in between, which fails once, before they part; between two there are none. Nor are there
// where an origin is outside its body or on its boundary.
TEST(CollisionOverlap, DiscsWithin) {
  const formats::Polygon2 square = square_of(1), outside = box(5, 0, 6, 1), on{{0, 0}, {2, 0}, {0, 2}};
  const Axes through{{-6, 1}, {ratio(1, 8)}, {1}, {0}};
  const SceneObject far = body("far", square, {{50}, {0}, {1}, {0}});
  const SceneObject still = body("still", square, kRest);
  EXPECT_EQ(failed_inside(scene_of_bodies({still, body("b", square, through)}, 0, 12))
                .count("discs_overlap"),
            0u);
  EXPECT_EQ(failed_inside(scene_of_bodies({still, body("b", square, through), far}, 0, 12))
                .at("discs_overlap"),
            1);
  for (const formats::Polygon2& polygon : {outside, on}) {
    const Scene scene =
        scene_of_bodies({still, body("b", polygon, {{-9, 1}, {0, 0}, {1}, {0}}), far}, 0, 20);
    EXPECT_EQ(failed_inside(scene).count("discs_overlap"), 0u);
    const MeetingCounts counts = check_meetings(scene);
    EXPECT_EQ(counts.contacts, 1u);
    EXPECT_EQ(counts.separations, 1u);
  }
}

// Bodies that cross one another's places all the time, some after a change of their flight plans
// deep inside; slivers and round ones, large and small.
TEST(CollisionOverlap, Crowds) {
  std::size_t contacts = 0;
  int discs = 0;
  for (int round = 0; round < (kSanitized ? 1 : 4); ++round) {
    SCOPED_TRACE(round);
    std::mt19937_64 random(static_cast<std::uint64_t>(40 + round));
    const auto few = [&](int from, int to) {
      return from + static_cast<int>(random() % static_cast<std::uint64_t>(to - from + 1));
    };
    std::vector<SceneObject> bodies;
    for (int i = 0; i < 4 + round % 2; ++i) {
      const formats::Polygon2 polygon = random_polygon(random, few(3, 9), i == 0 ? 8 : 3);
      const int dx = few(-2, 2), dy = dx == 0 ? 1 : few(-2, 2);
      const int x = 12 * i + 9 * dx, y = 9 * dy;
      // In the middle of all at 6, and from there on its way, back, or aside.
      const Axes come{{x, ratio(-x, 6)}, {y, ratio(-y, 6)}, {1}, {0, ratio(few(0, 2), 4)}};
      const int turn = few(0, 2);
      const Rational vx = turn == 0 ? ratio(-x, 6) : turn == 1 ? ratio(x, 6) : ratio(y, 6);
      const Rational vy = turn == 0 ? ratio(-y, 6) : turn == 1 ? ratio(y, 6) : ratio(-x, 6);
      const Axes go{{Rational(-6) * vx, vx}, {Rational(-6) * vy, vy}, come[2], come[3]};
      SceneObject object = body("b" + std::to_string(i), polygon, come);
      object.motion.pieces[0].to = Rational(6);
      object.motion.pieces.push_back({Rational(6), std::nullopt, trajectory(go)});
      bodies.push_back(std::move(object));
    }
    const Scene scene = scene_of_bodies(std::move(bodies), 0, 14);
    contacts += check_meetings(scene).contacts;
    const auto failed = failed_inside(scene);
    if (failed.count("discs_overlap") != 0) discs += failed.at("discs_overlap");
    if (HasFailure()) return;
  }
  EXPECT_GT(contacts, kSanitized ? 3u : 15u);
  EXPECT_GT(discs, kSanitized ? 0 : 8);
}

}  // namespace collision_overlap_test
}  // namespace kinex::test
