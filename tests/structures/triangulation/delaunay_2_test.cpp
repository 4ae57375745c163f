// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2 in general position: audits between all events, known counts, metamorphic relations.
#include "structures/triangulation/delaunay_2.h"

#include <algorithm>
#include <set>

#include "tests/sanitized.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/triangulation/delaunay_2_support.h"

namespace kinex::delaunay_2_test {
namespace delaunay_2_test {

TEST(Delaunay2, RandomLinearMotion) {
  for (const int n : {3, 4, 5, 6, 8, 12, 30}) {
    for (std::uint64_t seed = 0; seed < test::fewer(n < 20 ? 4u : 1u); ++seed) {
      World world(scene_of(random_motions(n, 100 * seed + static_cast<unsigned>(n)), 0, 1));
      world.run().expect_clean();
      if (n > 3) {
        EXPECT_EQ(world.ledger().processed, world.ledger().external);
      }
      EXPECT_LE(world.ledger().rebuilds, n == 3 ? 2u : 0u) << world.reasons();
    }
  }
}

TEST(Delaunay2, RandomMotionOfHigherDegree) {
  for (const int degree : {2, 3}) {
    for (std::uint64_t seed = 0; seed < test::fewer(3u); ++seed) {
      World world(scene_of(random_motions(15, 7 * seed, degree), 0, 1));
      world.run().expect_clean();
      EXPECT_EQ(world.ledger().rebuilds, 0u) << world.reasons();
    }
  }
}

TEST(Delaunay2, StaticPoints) {
  Random random(5);
  for (const int n : {0, 1, 2, 3, 4, 7, 30, 200}) {
    std::vector<Trajectory> motions;
    for (int i = 0; i < n; ++i) {
      motions.push_back(integers(random.between(0, 40), 0, random.between(0, 40), 0));
    }
    World world(scene_of(motions, 0, 1));
    world.run().expect_clean();
    EXPECT_EQ(world.ledger().processed, 0u);
  }
}

// The family with many hull changes: q_j = (j, -j^2 + jt), p_i = (t - g_i, -g_i^2 + g_i t - 1/8).
std::vector<Trajectory> hull_family(int m, int n) {
  std::vector<Trajectory> motions;
  for (int j = 0; j < m; ++j) motions.push_back(integers(j, 0, -j * j, j));
  for (int i = 0; i < n; ++i) {
    const Rational g = Rational(i) * (Rational(1) + fraction(1, n + 1));
    motions.push_back(moving({-g, 1}, {-(g * g) - fraction(1, 8), g}));
  }
  return motions;
}

TEST(Delaunay2, CountsOfTheHullFamily) {
  const struct {
    int m, n;
    std::uint64_t flips, hull;
  } rows[] = {{3, 3, 15, 17}, {4, 4, 38, 31}, {5, 5, 68, 49}, {6, 6, 107, 71}};
  for (const auto& row : rows) {
    const Rational last = Rational(row.n - 1) * (Rational(1) + fraction(1, row.n + 1));
    // An open window: the first instant is left out by starting right after it.
    World world(scene_of(hull_family(row.m, row.n), 0, last + Rational(row.m + 2)));
    world.run().expect_clean();
    EXPECT_EQ(world.count("flip"), row.flips) << row.m;
    EXPECT_EQ(world.count("enter") + world.count("leave"), row.hull) << row.m;
    EXPECT_EQ(world.count("reinsert"), 0u);
  }
}

TEST(Delaunay2, HullChangesOfTheHullFamily) {
  for (const auto& [m, n] : {std::pair{2, 2}, std::pair{2, 6}, std::pair{6, 2}, std::pair{3, 5},
                             std::pair{5, 3}, std::pair{6, 5}, std::pair{5, 6}}) {
    const Rational last = Rational(n - 1) * (Rational(1) + fraction(1, n + 1));
    World world(scene_of(hull_family(m, n), 0, last + Rational(m + 2)));
    world.run().expect_clean();
    EXPECT_EQ(world.count("enter") + world.count("leave"), 2u * static_cast<unsigned>(m * n) - 1)
        << m << " " << n;
    EXPECT_EQ(world.ledger().external, world.ledger().processed);
  }
}

TEST(Delaunay2, NumberOfEdgesFollowsTheHull) {
  World world(scene_of(random_motions(60, 11), 0, 1), "exact", AuditLevel::kEnd);
  world.start();
  const std::size_t before = world.structure().hull().size();
  world.run_until(1);
  const std::size_t after = world.structure().hull().size();
  EXPECT_EQ(after + world.count("leave"), before + world.count("enter"));
  EXPECT_EQ(world.structure().attribute().ids.size() / 2, 3 * 60 - 3 - after);
  world.expect_clean();
}

TEST(Delaunay2, ExactAndReferenceArithmeticAgree) {
  for (std::uint64_t seed = 0; seed < test::fewer(3u); ++seed) {
    const Scene scene = scene_of(random_motions(9, 1000 + seed, 1 + static_cast<int>(seed)), 0, 1);
    World exact(scene, "exact", AuditLevel::kEnd), sturm(scene, "sturm", AuditLevel::kEnd);
    sturm.recorder.instants = exact.recorder.instants;
    exact.run().expect_clean();
    sturm.run().expect_clean();
    EXPECT_EQ(exact.recorder.events, sturm.recorder.events);
    EXPECT_FALSE(exact.recorder.events.empty());
  }
}

std::vector<std::vector<ObjectId>> sorted_ids(const std::vector<Recorded>& events,
                                              const std::vector<ObjectId>& name) {
  std::vector<std::vector<ObjectId>> all;
  for (const Recorded& e : events) {
    std::vector<ObjectId> ids;
    for (const ObjectId id : e.ids) ids.push_back(name[id]);
    std::sort(ids.begin(), ids.end());
    all.push_back(ids);
  }
  return all;
}

std::vector<ObjectId> same_names(std::size_t n) {
  std::vector<ObjectId> name(n);
  for (std::size_t i = 0; i < n; ++i) name[i] = static_cast<ObjectId>(i);
  return name;
}

// As many as another program counts.
TEST(Delaunay2, ReferenceCounts) {
  struct Row {
    int n;
    std::uint64_t seed, inner, hull;
  };
  for (const Row& row :
       {Row{6, 1, 10, 8}, Row{8, 1, 17, 8}, Row{10, 2, 34, 12}, Row{12, 3, 29, 5}}) {
    SCOPED_TRACE(row.n);
    World world(test::reference_scene(row.n, 2, row.seed));
    world.run().expect_clean();
    EXPECT_EQ(world.count("flip"), row.inner);
    EXPECT_EQ(world.count("enter") + world.count("leave"), row.hull);
    EXPECT_EQ(world.ledger().external, row.inner + row.hull);
  }
}

TEST(Delaunay2, TimeReversedGivesTheEventsBackwards) {
  const std::vector<Trajectory> motions = random_motions(25, 77);
  std::vector<Trajectory> reversed;
  for (const Trajectory& m : motions) {  // t -> 1 - t
    Trajectory r = m;
    for (Coefficients& c : r.coordinates) {
      c.resize(2);
      c[0] += c[1];
      c[1] = -c[1];
    }
    reversed.push_back(r);
  }
  World there(scene_of(motions, 0, 1)), back(scene_of(reversed, 0, 1));
  there.run().expect_clean();
  back.run().expect_clean();
  auto a = sorted_ids(there.recorder.events, same_names(25));
  const auto b = sorted_ids(back.recorder.events, same_names(25));
  std::reverse(a.begin(), a.end());
  EXPECT_EQ(a, b);
  EXPECT_EQ(there.count("enter"), back.count("leave"));
  EXPECT_EQ(there.count("flip"), back.count("flip"));
}

TEST(Delaunay2, PermutedIdsGiveTheSameEvents) {
  const int n = 25;
  const std::vector<Trajectory> motions = random_motions(n, 78);
  std::vector<ObjectId> name = same_names(n);
  Random(3).shuffle(name);
  std::vector<Trajectory> permuted;  // object i is the old object name[i]
  for (const ObjectId old : name) permuted.push_back(motions[old]);
  World a(scene_of(motions, 0, 1)), b(scene_of(permuted, 0, 1));
  a.run().expect_clean();
  b.run().expect_clean();
  EXPECT_EQ(sorted_ids(a.recorder.events, same_names(n)), sorted_ids(b.recorder.events, name));
}

TEST(Delaunay2, MirroredAndCarriedAlongGiveTheSameEvents) {
  const int n = 25;
  const std::vector<Trajectory> motions = random_motions(n, 79);
  std::vector<Trajectory> mirrored, carried;
  for (const Trajectory& m : motions) {
    Trajectory r = m;
    for (Rational& c : r.coordinates[0]) c = -c;
    mirrored.push_back(r);
    Trajectory s = m;
    for (Coefficients& c : s.coordinates) c.resize(3);
    s.coordinates[0][0] += Rational(1000);
    s.coordinates[0][1] += fraction(-17, 3);
    s.coordinates[1][2] += fraction(9, 7);
    carried.push_back(s);
  }
  World a(scene_of(motions, 0, 1)), b(scene_of(mirrored, 0, 1)), c(scene_of(carried, 0, 1));
  a.run().expect_clean();
  b.run().expect_clean();
  c.run().expect_clean();
  const auto expected = sorted_ids(a.recorder.events, same_names(n));
  EXPECT_EQ(expected, sorted_ids(b.recorder.events, same_names(n)));
  EXPECT_EQ(expected, sorted_ids(c.recorder.events, same_names(n)));
}

TEST(Delaunay2, SameAsStaticAtManyTimes) {
  std::vector<Rational> times;
  for (int i = 1; i <= 20; ++i) times.push_back(fraction(i, 20));
  expect_same_as_static(random_motions(30, 80), 0, times);
}

TEST(Delaunay2, OneMovesThroughManyThatStand) {
  Random random(9);
  std::vector<Trajectory> motions;
  for (int i = 0; i < 150; ++i) {
    motions.push_back(integers(random.between(0, 100000), 0, random.between(0, 100000), 0));
  }
  motions.push_back(integers(-20000, 140001, 47011, 11003));
  World world(scene_of(motions, 0, 1));
  world.run().expect_clean();
  EXPECT_GT(world.count("flip"), 50u);
  EXPECT_EQ(world.ledger().rebuilds, 0u) << world.reasons();
}

TEST(Delaunay2, LargeAndSmallNumbersTogether) {
  const Rational large = *Rational::parse("1e150"), small = *Rational::parse("1e-150");
  Random random(10);
  std::vector<Trajectory> motions;
  for (int i = 0; i < 16; ++i) {
    const Rational& scale = i % 2 == 0 ? large : small;
    const auto draw = [&] { return scale * Rational(random.between(-1000, 1000)); };
    motions.push_back(moving({draw(), draw()}, {draw(), draw()}));
  }
  World world(scene_of(motions, 0, 2));
  world.run().expect_clean();
  EXPECT_GT(world.ledger().processed, 0u);
}

TEST(Delaunay2, InexactArithmeticsNeverFallOver) {
  for (const std::string_view arithmetic : {"double", "gsl", "mpfr:5", "mpfr:20"}) {
    for (std::uint64_t seed = 0; seed < test::fewer(3u); ++seed) {
      World world(scene_of(random_motions(14, seed), 0, 1), arithmetic, AuditLevel::kNone);
      world.run();
      EXPECT_NE(world.status, RunStatus::kInterrupted) << arithmetic;
    }
  }
}

}  // namespace delaunay_2_test
}  // namespace kinex::delaunay_2_test
