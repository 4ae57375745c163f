// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2 under insertions, erasures and new motions.
#include <algorithm>
#include <optional>

#include "tests/sanitized.h"
#include "tests/structures/triangulation/delaunay_2_support.h"

namespace kinex::delaunay_2_test {
namespace delaunay_2_dynamic_test {

struct Life {
  std::vector<MotionPiece> pieces;
};

Scene scene_of_lives(const std::vector<Life>& lives, const Rational& start, const Rational& end) {
  Scene scene = scene_of(std::vector<Trajectory>(lives.size()), start, end);
  for (std::size_t i = 0; i < lives.size(); ++i) scene.objects[i].motion.pieces = lives[i].pieces;
  return scene;
}

// The same scene started at t, independent of what happened before.
Scene started_at(Scene scene, const Rational& t) {
  scene.start = t;
  scene.end = t + Rational(1);
  for (SceneObject& object : scene.objects) {
    const MotionPiece* piece = object.motion.piece_after(t);
    std::vector<MotionPiece> pieces;
    if (piece != nullptr) pieces.push_back({std::nullopt, std::nullopt, piece->trajectory});
    object.motion.pieces = std::move(pieces);
  }
  return scene;
}

void expect_same_as_static(const Scene& scene, const std::vector<Rational>& times) {
  World kinetic(scene);
  kinetic.start();
  for (const Rational& t : times) {
    kinetic.run_until(t);
    World fresh(started_at(scene, t));
    fresh.start();
    EXPECT_EQ(kinetic.structure().attribute(), fresh.structure().attribute())
        << "at t = " << t.to_string();
    EXPECT_EQ(kinetic.structure().hull(), fresh.structure().hull()) << "at t = " << t.to_string();
  }
  kinetic.expect_clean();
}

std::vector<Rational> steps(std::int64_t last, std::int64_t parts) {
  std::vector<Rational> times;
  for (std::int64_t i = 1; i <= last; ++i) times.push_back(fraction(i, parts));
  return times;
}

// A life with new velocities at some multiples of 1/parts; position continuous.
Life wandering(Random& random, std::int64_t from, std::int64_t to, std::int64_t parts,
               std::int64_t size, std::int64_t speed) {
  Life life;
  Rational at[2] = {Rational(random.between(0, size)), Rational(random.between(0, size))};
  std::int64_t now = from;
  while (now < to) {
    const std::int64_t next = std::min(to, now + random.between(1, 3));
    Trajectory motion;
    for (Rational& p : at) {
      const Rational v(random.between(-speed, speed));
      motion.coordinates.push_back({p - v * fraction(now, parts), v});
      p += v * fraction(next - now, parts);
    }
    motion.normalise();
    life.pieces.push_back({fraction(now, parts), fraction(next, parts), motion});
    now = next;
  }
  return life;
}

std::vector<Life> random_lives(int n, std::uint64_t seed, std::int64_t size, std::int64_t speed) {
  Random random(seed);
  std::vector<Life> lives;
  for (int i = 0; i < n; ++i) {
    const std::int64_t from = random.between(0, 1) == 0 ? 0 : random.between(0, 6);
    lives.push_back(wandering(random, from, random.between(from + 1, 9), 4, size, speed));
  }
  return lives;
}

TEST(Delaunay2Dynamic, InsertionsErasuresAndNewMotions) {
  for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
    const Scene scene = scene_of_lives(random_lives(24, seed, 100000, 100000), 0, 3);
    World world(scene);
    world.run().expect_clean();
    EXPECT_GT(world.ledger().insertions + world.ledger().erasures, test::seen_in_fewer(5u));
    EXPECT_GT(world.ledger().motion_updates, test::seen_in_fewer(5u));
    expect_same_as_static(scene, steps(20, 8));
  }
}

TEST(Delaunay2Dynamic, TheSameOnASmallGrid) {
  for (std::uint64_t seed = 0; seed < test::fewer(16u); ++seed) {
    const int n = 4 + 2 * static_cast<int>(seed);
    const Scene scene = scene_of_lives(random_lives(n, 100 + seed, 4, 4), 0, 3);
    expect_same_as_static(scene, steps(20, 8));
  }
}

TEST(Delaunay2Dynamic, ComesFromNothingAndGoesBack) {
  Random random(2);
  std::vector<Life> lives;
  for (int i = 0; i < 12; ++i) lives.push_back(wandering(random, 1 + i, 30 - i, 8, 50, 20));
  const Scene scene = scene_of_lives(lives, 0, 4);
  World world(scene);
  world.run().expect_clean();
  EXPECT_TRUE(world.structure().on_line());
  EXPECT_TRUE(world.structure().attribute().ids.empty());
  expect_same_as_static(scene, steps(64, 16));
}

TEST(Delaunay2Dynamic, ErasesEveryKindOfVertex) {
  for (std::uint64_t seed = 0; seed < test::fewer(4u); ++seed) {
    Random random(seed);
    std::vector<Trajectory> motions;
    for (int i = 0; i < 40; ++i) {
      motions.push_back(seed < 2 ? integers(random.between(0, 5), 0, random.between(0, 5), 0)
                                 : integers(random.between(0, 999), random.between(-99, 99),
                                            random.between(0, 999), random.between(-99, 99)));
    }
    World world(scene_of(motions, 0, 41));
    world.start();
    std::vector<ObjectId> order;
    for (ObjectId i = 0; i < 40; ++i) order.push_back(i);
    random.shuffle(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
      world.erase(Rational(static_cast<int>(i) + 1), order[i]);
    }
    world.run_until(41);
    world.expect_clean();
    EXPECT_EQ(world.ledger().erasures, 40u);
    EXPECT_TRUE(world.structure().attribute().ids.empty());
  }
}

// A wheel: the hub has every other point as a neighbour.
TEST(Delaunay2Dynamic, ErasesAHubOfHighDegree) {
  std::vector<Trajectory> motions{integers(0, 0, 0, 0)};
  const int n = 120;
  for (int i = 0; i < n; ++i) {  // rational points of the unit circle, moved off it a little
    const Rational u = fraction(2 * i - n, n / 4);
    const Rational w = Rational(1) + u * u;
    const Rational r = Rational(1) + fraction((i * 37) % 11, 100000);
    motions.push_back(moving({r * (Rational(1) - u * u) / w}, {r * Rational(2) * u / w}));
  }
  World world(scene_of(motions, 0, 2));
  world.start();
  EXPECT_GE(world.structure().attribute().ids.size(), 2u * n);
  world.erase(1, 0);
  world.run_until(2);
  world.expect_clean();
  EXPECT_EQ(world.ledger().rebuilds, 0u);
}

TEST(Delaunay2Dynamic, EqualPointsComeAndGo) {
  const Trajectory there = integers(1, 1, 2, 0);
  std::vector<Trajectory> motions{
      there, there, integers(9, 0, 0, 0), there, integers(0, 0, 9, 0), integers(-5, 0, -5, 1),
      there};
  World world(scene_of(motions, 0, 10));
  world.start();
  EXPECT_EQ(world.structure().representative(6), 0u);
  world.erase(1, 1);                         // hidden
  world.erase(2, 0);                         // the vertex
  world.insert(3, 0, there);                 // a smaller id takes over
  world.update(4, 3, integers(5, 0, 2, 0));  // parts from the others: x = 5 at t = 4
  world.update(5, 0, moving({Rational(-9), Rational(3)}, {Rational(2)}));  // the vertex parts
  world.run_until(Rational(1));
  EXPECT_EQ(world.structure().representative(1), kNoObject);
  world.run_until(fraction(5, 2));
  EXPECT_EQ(world.structure().representative(6), 3u);
  world.run_until(fraction(7, 2));
  EXPECT_EQ(world.structure().representative(6), 0u);
  EXPECT_EQ(world.structure().representative(3), 0u);
  world.run_until(fraction(9, 2));
  EXPECT_EQ(world.structure().representative(3), 3u);
  world.run_until(10);
  EXPECT_EQ(world.structure().representative(6), 6u);
  world.expect_clean();
}

TEST(Delaunay2Dynamic, PointsMeetAndStayTogether) {
  std::vector<Life> lives;
  Random random(3);
  for (int i = 0; i < 8; ++i) lives.push_back(wandering(random, 0, 16, 4, 60, 9));
  // Both reach (30, 30) at t = 2, go on together, and part at t = 3.
  const auto piece = [](std::int64_t from, std::int64_t to, const Trajectory& m) {
    return MotionPiece{Rational(from), Rational(to), m};
  };
  Life a, b;
  a.pieces = {piece(0, 2, integers(10, 10, 30, 0)), piece(2, 3, integers(30, 0, 10, 10)),
              piece(3, 4, integers(60, -10, 40, 0))};
  b.pieces = {piece(0, 2, integers(30, 0, 50, -10)), piece(2, 3, integers(30, 0, 10, 10)),
              piece(3, 4, integers(30, 0, 10, 10))};
  lives.push_back(a);
  lives.insert(lives.begin(), b);
  const Scene scene = scene_of_lives(lives, 0, 4);
  World world(scene);
  world.start();
  world.run_until(fraction(5, 2));
  EXPECT_EQ(world.structure().representative(9), 0u);
  expect_same_as_static(scene, steps(31, 8));
}

TEST(Delaunay2Dynamic, FallsOntoALineAndLeavesIt) {
  // Points that reach y = 0 at t = 1, stay there until 2, and leave again.
  std::vector<Life> lives;
  for (int i = 0; i < 7; ++i) {
    const std::int64_t y = (i * i) % 5 + 1, w = (i * i) % 7 - 2;
    Life life;
    life.pieces = {{Rational(0), Rational(1), integers(3 * i, 1, y, -y)},
                   {Rational(1), Rational(2), integers(3 * i + 1, 0, 0, 0)},
                   {Rational(2), Rational(4), integers(3 * i + 1, 0, -2 * w, w)}};
    lives.push_back(life);
  }
  const Scene scene = scene_of_lives(lives, 0, 4);
  World world(scene);
  world.start();
  world.run_until(fraction(3, 2));
  EXPECT_TRUE(world.structure().on_line());
  world.run_until(fraction(5, 2));
  EXPECT_FALSE(world.structure().on_line());
  world.expect_clean();
  expect_same_as_static(scene, steps(15, 4));
}

TEST(Delaunay2Dynamic, InexactArithmeticsNeverFallOver) {
  for (const std::string_view arithmetic : {"double", "gsl", "mpfr:6", "mpfr:30"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(6u); ++seed) {
      const std::int64_t size = seed % 2 == 0 ? 4 : 1000;
      World world(scene_of_lives(random_lives(20, seed, size, size), 0, 2), arithmetic,
                  AuditLevel::kNone);
      world.run();
      EXPECT_EQ(world.status, RunStatus::kDone) << arithmetic;
    }
  }
}

}  // namespace delaunay_2_dynamic_test
}  // namespace kinex::delaunay_2_test
