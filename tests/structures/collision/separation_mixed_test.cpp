// SPDX-License-Identifier: GPL-3.0-or-later
// The tile of a run, at rational times, against all tiles at that time.
#include "structures/collision/separation_mixed.h"

#include <gtest/gtest.h>

#include "structures/collision/collision_pairs.h"
#include "tests/sanitized.h"
#include "tests/structures/collision/scene_of_bodies.h"
#include "tests/structures/collision/tile_bench.h"
#include "tests/structures/test_run.h"

namespace kinex::test {
namespace separation_mixed_test {

using Axes = std::vector<std::vector<Rational>>;

Polygon negated(Polygon polygon) {
  for (Vertex2& v : polygon) v = {-v[0], -v[1]};
  return polygon;
}

// B as seen from A at t: its place and the rotor.
struct Pose {
  Pose(const Scene& scene, const Rational& t) {
    const Trajectory& a = scene.objects[0].motion.pieces[0].trajectory;
    const Trajectory& b = scene.objects[1].motion.pieces[0].trajectory;
    const Rational p = a.position(2, t), q = a.position(3, t);
    const Rational r = b.position(2, t), s = b.position(3, t);
    rotor = {p * r + q * s, p * s - q * r};
    const Polygon way{{b.position(0, t) - a.position(0, t), b.position(1, t) - a.position(1, t)}};
    at = turned(way, p, -q)[0];
  }
  Vertex2 at, rotor;
};

struct Seen {
  int inside = 0, beyond = 0, on_side = 0, flips = 0, sides = 0, contacts = 0;
};

void follow(const Scene& scene, int steps, Seen& seen) {
  const Bench bench(scene.objects[0].polygon, negated(scene.objects[1].polygon),
                    CutPolicy::kBalancedDudley);
  Trial trial(scene, "separation_mixed");
  const auto& structure = proof_of<SeparationMixed>(trial.simulator.structure(0));
  for (int k = 0; k <= steps; ++k) {
    const Rational t = scene.start + (*scene.end - scene.start) * over(k, steps);
    trial.run_until(t);
    const auto tile = structure.tile(0, 1);
    if (!tile) break;
    const Pose pose(scene, t);
    const TileGeometry geometry = bench.geometry(pose.rotor);
    if (tile->kind == Tile::Kind::kHalf) {
      ++seen.beyond;
      EXPECT_LE(where(pose.at, geometry.sum(0)), 0);
      continue;
    }
    const Polygon outline = convex_hull(geometry.placed(*tile).outline);
    EXPECT_GE(where(pose.at, outline), 0);
    const auto holder = geometry.holder(pose.at);
    if (!holder) {
      ++seen.on_side;
      continue;
    }
    ++seen.inside;
    EXPECT_EQ(outline, *holder);
  }
  trial.to_end();
  trial.expect_clean();
  for (const Recorded& event : trial.sink.recorder.events) {
    seen.sides += event.kind == SeparationMixed::kSide;
    seen.flips += event.kind == SeparationMixed::kFlip;
    seen.contacts += event.kind == CollisionEvent::kContact;
  }
}

TEST(SeparationMixed, IsInTheTileThatHoldsThePoint) {
  Random random(41);
  Seen seen;
  const int rounds = kSanitized ? 6 : 40;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const Polygon a = random_hull(random, random.between(3, 12), 9);
    const Polygon b = random_hull(random, random.between(3, 12), 9);
    // Near A and round about it, turning either way.
    const auto draw = [&](int most) { return over(random.between(-most, most), 8); };
    const Scene scene = scene_of_bodies(
        {rigid("a", a,
               {{0, draw(8)}, {draw(8)}, {1, draw(4)}, {0, over(random.between(1, 16), 8)}}),
         rigid("b", b,
               {{random.between(20, 24), draw(60), draw(40)},
                {draw(80), draw(60), draw(20)},
                {1, draw(4)},
                {0, over(random.between(-16, -1), 8)}})},
        0, Rational(2));
    follow(scene, 40, seen);
    if (HasFailure()) return;
  }
  EXPECT_GT(seen.beyond, rounds);
  if (kSanitized) return;  // fewer rounds
  EXPECT_GT(seen.inside, 0);
  EXPECT_GT(seen.sides, rounds);
  EXPECT_GT(seen.flips, 0);
  EXPECT_GT(seen.contacts, 0);
}

// Close by, while the body turns about itself: flips, and sides that pass to and fro.
TEST(SeparationMixed, TurnsCloseBy) {
  Random random(43);
  Seen seen;
  for (int round = 0; round < (kSanitized ? 2 : 8); ++round) {
    SCOPED_TRACE(round);
    const int n = random.between(5, 8), m = random.between(5, 8);
    const Scene scene =
        scene_of_bodies({rigid("a", regular(n, 0.1 * round), {{0}, {0}, {1}, {0}}),
                    rigid("b", regular(m, 0.3), {{over(101, 50)}, {over(round, 9)}, {1}, {0, 1}})},
                   -3, Rational(3));
    follow(scene, 60, seen);
    if (HasFailure()) return;
  }
  EXPECT_GT(seen.inside, kSanitized ? 20 : 100);
  EXPECT_GT(seen.flips, kSanitized ? 5 : 30);
}

std::int64_t signs_of(const Trial& trial) {
  std::int64_t sum = 0;
  for (const auto& predicate : trial.simulator.arithmetic().counters().by_predicate) {
    for (const std::uint64_t count : predicate.signs) sum += static_cast<std::int64_t>(count);
  }
  return sum;
}

BoundCheck signs_check(const Trial& trial) {
  for (const BoundCheck& check : trial.simulator.bounds(0)) {
    if (check.id == "separation_mixed.signs") return check;
  }
  return {};
}

// After the first failure its signs are the recorded ones; a later failure replaces it only if it
// comes nearer to its bound.
TEST(SeparationMixed, CountsTheSignsOfAFailure) {
  int alone = 0;
  for (int round = 0; round < 8; ++round) {
    SCOPED_TRACE(round);
    const Scene scene =
        scene_of_bodies({rigid("a", regular(9, 0.2), {{0}, {0}, {1}, {0}}),
                    rigid("b", regular(7, 0.1),
                          {{over(51, 25), over(round, 10)}, {over(-1, 9), 1}, {1}, {0, 1}})},
                   -3, Rational(3));
    Trial trial(scene, "separation_mixed", "exact", AuditLevel::kNone);
    trial.without_twin();
    EXPECT_EQ(signs_check(trial).observed, Integer(0));
    std::int64_t before = signs_of(trial);
    int k = 1;
    for (; k <= 6000 && trial.ledger().failures == 0; ++k) {
      before = signs_of(trial);
      trial.run_until(over(k, 1000) - Rational(3));
    }
    if (trial.ledger().failures != 1) continue;  // two together
    ++alone;
    EXPECT_GT(signs_of(trial), before);
    EXPECT_EQ(signs_check(trial).observed, Integer(signs_of(trial) - before));
    trial.to_end();
    EXPECT_GT(trial.ledger().failures, 4u);
    const BoundCheck check = signs_check(trial);
    EXPECT_TRUE(check.holds);
    // The bound is not far from the observed value.
    EXPECT_GE(Integer(10) * check.observed, check.bound);
  }
  EXPECT_GE(alone, 3);
}

}  // namespace separation_mixed_test
}  // namespace kinex::test
