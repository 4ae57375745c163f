// SPDX-License-Identifier: GPL-3.0-or-later
// The pair of discs of the smallest gap: counts by hand and by brute force, ties, touches, discs that
// meet, show and hide, flight plans. Every run is audited against all pairs after every instant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structures/proximity/closest_pair_discs.h"
#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/planes_in_space.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/meetings_support.h"
#include "tests/structures/special_scenes.h"

namespace kinex::test {
namespace closest_pair_discs_test {

using Ids = std::vector<ObjectId>;

const std::vector<Request> kAsked{ask("closest_pair_discs")};

std::uint64_t count(const TwinRun& run, const std::string& kind) {
  const auto& kinds = run.ledger().by_kind;
  const auto found = kinds.find(kind);
  return found == kinds.end() ? 0 : found->second;
}

Trajectory disc(std::vector<Rational> x, std::vector<Rational> y, std::vector<Rational> r) {
  return path({std::move(x), std::move(y), std::move(r)});
}

Scene discs(const std::vector<Trajectory>& paths, int start, int end) {
  return extended_scene(paths, Extents::kRadius, start, Rational(end));
}

// The changes of the attribute, "instant -gone +came" each.
std::vector<std::string> changes(const Scene& scene) {
  return TwinRun(scene, kAsked).changes(0);
}

// Discs at rest in a row, of radius 4 and 2 in turn, 16 apart; others of radius 1 pass over them.
Scene gaps_along_row(int m, int n) {
  std::vector<Trajectory> paths;
  for (int j = 0; j < m; ++j) paths.push_back(disc({16 * j}, {0}, {j % 2 == 0 ? 4 : 2}));
  for (int i = 0; i < n; ++i) paths.push_back(disc({-16 * m * i, 16}, {8}, {1}));
  Scene scene = discs(paths, 0, 1);
  scene.end = Rational(Integer(2 * n * m - 1), Integer(2));
  return scene;
}

// After the scene's end a radius may become negative: audits at the end ask for no such time.
TEST(ClosestPairDiscs, RadiiBecomeNegativeAfterTheEnd) {
  const Scene scene = discs({disc({0}, {0}, {0}), disc({0}, {0}, {1, 1, -1})}, 0, 1);
  const TwinRun run(scene, kAsked);
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(ClosestPairDiscs, GapsAlongARow) {
  for (const auto& [m, n] : {std::pair{2, 2}, {3, 2}, {4, 2}, {3, 3}, {5, 4}}) {
    SCOPED_TRACE(std::to_string(m) + " and " + std::to_string(n));
    const Scene scene = gaps_along_row(m, n);
    const TwinRun run(scene, kAsked), twin(scene, kAsked, "sturm");
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * m - 1));
    EXPECT_EQ(run.begins_with.size(), 2u);
    EXPECT_GT(count(run, "case"), 0u);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

// Small discs of equal radii: the closest pair of their centres, as often as counted by brute force.
TEST(ClosestPairDiscs, EqualRadiiAreTheClosestPair) {
  struct Counted {
    int n, dimension;
    std::uint64_t seed, changes;
  };
  for (const Counted& one : {Counted{6, 2, 1, 4}, {8, 2, 1, 5}, {10, 2, 2, 8}, {12, 2, 3, 7},
                             {6, 3, 1, 4}, {7, 3, 2, 7}, {8, 3, 1, 5}}) {
    if (kSanitized && one.n > 7) continue;
    SCOPED_TRACE(std::to_string(one.n) + " in " + std::to_string(one.dimension));
    Scene scene = reference_scene(one.n, one.dimension, one.seed);
    const TwinRun points(scene, {ask("closest_pair_all")});
    for (SceneObject& object : scene.objects) {
      object.motion.pieces[0].trajectory.coordinates.push_back({Rational(Integer(1), Integer(1000))});
    }
    scene.extents = Extents::kRadius;
    const TwinRun run(scene, kAsked), twin(scene, kAsked, "sturm");
    EXPECT_EQ(run.ledger().external, one.changes);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    EXPECT_EQ(run.begins_with, points.begins_with);
    EXPECT_EQ(run.attribute(), points.attribute());
    EXPECT_EQ(count(run, "contact"), 0u);
  }
}

// As lattice_scene, with radii 0, 1/8, 1/4 or 3/8, a third of which grow or shrink.
Scene lattice_of_discs(std::uint64_t seed, int n, int dimension) {
  Scene scene = lattice_scene(seed, n, dimension);
  Random random(seed + 4000);
  scene.extents = Extents::kRadius;
  for (SceneObject& object : scene.objects) {
    const int size = random.between(0, 3), grows = random.between(-1, 1);
    std::vector<Rational> radius{Rational(Integer(size), Integer(8))};
    if (size > 1 && random.chance(33)) radius.emplace_back(Integer(grows), Integer(16));
    object.motion.pieces[0].trajectory.coordinates.push_back(std::move(radius));
    object.motion.pieces[0].trajectory.normalise();
  }
  return scene;
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0, contacts = 0, ties = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int dimension = seed % 4 == 0 ? 3 : 2;
    const int n = 2 + static_cast<int>(seed % (dimension == 3 ? 5 : 7));
    const Scene scene = lattice_of_discs(seed, n, dimension);
    const TwinRun run(scene, kAsked);
    external += run.ledger().external;
    contacts += count(run, "contact");
    ties += run.begins_with.size() + run.attribute().size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 3 * test::seen_in_fewer(seeds));
  EXPECT_GT(contacts, test::seen_in_fewer(seeds) / 2);
  EXPECT_GT(ties, test::seen_in_fewer(seeds) / 2);
}

TEST(ClosestPairDiscs, TinyLattices) { on_lattices(kSanitized ? 120 : 300); }

TEST(SlowClosestPairDiscs, TinyLattices) { on_lattices(600); }

TEST(SlowClosestPairDiscs, FiveToNineBalls) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const int n =
        seed % 9 < 2 ? 7 + static_cast<int>(seed / 9 % 3) : 5 + static_cast<int>(seed % 2);
    const TwinRun run(lattice_of_discs(seed, n, 3), kAsked);
    if (HasFailure()) return;
  }
}

// Radii become so small that most of the time no two discs meet.
void shrink(Scene& scene) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      for (Rational& c : piece.trajectory.coordinates.back())
        c *= Rational(Integer(1), Integer(32));
    }
  }
}

// Discs come, go and change their motions and radii; exact and sturm agree line by line.
TEST(ClosestPairDiscs, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1   ? 8u
                                                     : degree == 2 ? 4u
                                                                   : 2u);
         ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const int dimension = degree == 1 && seed % 4 == 3 ? 3 : 2;
      Scene scene = extended_flights(seed, 6, dimension, degree, seed % 2 == 0, Extents::kRadius);
      shrink(scene);
      const TwinRun run(scene, kAsked), twin(scene, kAsked, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(25u));
  EXPECT_GT(updates, test::seen_in_fewer(40u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(ClosestPairDiscs, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = extended_flights(seed, 6, 2, 1, true, Extents::kRadius, plan_instants(seed));
    if (seed % 4 < 2) shrink(scene);
    runs.expect_to_go_on(scene, kAsked, seed);
  }
  runs.expect_changes();
}

// While two discs meet there is no pair; a touch at an instant is nothing.
TEST(ClosestPairDiscs, ContactAndApart) {
  const Trajectory other = disc({0}, {20}, {1});
  const Scene through = discs({disc({-6, 2}, {0}, {1}), disc({0}, {0}, {1}), other}, 0, 6);
  const TwinRun run(through, kAsked);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(count(run, "contact"), 1u);
  EXPECT_EQ(count(run, "apart"), 1u);
  EXPECT_EQ(run.ledger().external, 2u);
  const Scene touch = discs({disc({-6, 2}, {2}, {1}), disc({0}, {0}, {1}), other}, 0, 6);
  EXPECT_EQ(changes(touch), std::vector<std::string>{});
  // Two meet while two others, which were the closest, part: other pairs before and after.
  const Scene in_turn = discs({disc({-10, 1}, {0}, {1}), disc({0}, {0}, {1}), disc({0}, {20}, {1}),
                               disc({4, 2}, {20}, {1})}, 0, 12);
  const TwinRun pairs(in_turn, kAsked);
  EXPECT_EQ(pairs.begins_with, (Ids{2, 3}));
  EXPECT_EQ(pairs.ledger().external, 3u);
}

// A disc that passes through two others is hidden between their centres; it comes out again.
TEST(ClosestPairDiscs, HiddenDiscs) {
  const Rational near(Integer(41), Integer(2));
  const Scene scene = discs({disc({0}, {0}, {10}), disc({-30, 3}, {1}, {1}), disc({near}, {0}, {10}),
                             disc({10}, {60}, {2}), disc({10}, {-60}, {3})}, 0, 25);
  const TwinRun run(scene, kAsked);
  EXPECT_EQ(count(run, "contact"), 1u);
  EXPECT_EQ(count(run, "apart"), 1u);
  bool hidden = false;
  for (const std::string& line : run.sink.log.lines) {
    hidden = hidden || line.find(" hide ") != std::string::npos;
  }
  EXPECT_TRUE(hidden);
}

// Discs that are all on one line.
TEST(ClosestPairDiscs, OnALine) {
  const Scene scene = discs({disc({0, 1}, {0, 2}, {1}), disc({10, 1}, {20, 2}, {2}),
                             disc({30, -1}, {60, -2}, {1, 1}), disc({-50, 2}, {-100, 4}, {1})}, 0, 8);
  const TwinRun run(scene, kAsked);
  EXPECT_GT(run.ledger().external, 1u);
}

// The scene of the plane, in space: lengths are `factor` times as large there.
Scene balls_of_plane(const Scene& flat, const Turn& turn, int factor) {
  Scene scene = in_space(flat, turn);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto& pieces = scene.objects[i].motion.pieces;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      auto axes = pieces[p].trajectory.coordinates;
      axes.push_back(flat.objects[i].motion.pieces[p].trajectory.coordinates[2]);
      for (Rational& c : axes.back()) c *= Rational(factor);
      pieces[p].trajectory = path(axes);
    }
  }
  return scene;
}

// Without the numbers of instants.
std::vector<std::string> told(const TwinRun& run) {
  std::vector<std::string> result;
  for (const std::string& line : run.changes(0)) result.push_back(line.substr(line.find(' ')));
  return result;
}

// Balls whose centres are all in one plane: the same pairs as of the discs there, among as many edges.
TEST(ClosestPairDiscs, BallsOfOnePlane) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
    SCOPED_TRACE(seed);
    Scene flat = seed % 3 == 0 ? extended_flights(seed, 6, 2, 1, seed % 2 == 0, Extents::kRadius)
                               : lattice_of_discs(seed, 4 + static_cast<int>(seed % 4), 2);
    const bool tilted = seed % 2 == 0;
    const Scene scene = balls_of_plane(flat, tilted ? kOblique : kUpright, tilted ? 3 : 1);
    const TwinRun run(scene, kAsked), plane(flat, kAsked);
    EXPECT_EQ(told(run), told(plane));
    EXPECT_EQ(run.begins_with, plane.begins_with);
    EXPECT_EQ(run.attribute(), plane.attribute());
    external += run.ledger().external;
  }
  EXPECT_GT(external, test::seen_in_fewer(6u));
  Scene many = reference_scene(10, 2, 1);
  many.extents = Extents::kRadius;
  for (SceneObject& object : many.objects) {
    object.motion.pieces[0].trajectory.coordinates.push_back({Rational(1)});
    object.motion.pieces[0].trajectory.normalise();
  }
  const TwinRun run(balls_of_plane(many, kOblique, 3), kAsked);
  EXPECT_GT(run.ledger().external, 3u);
  EXPECT_LE(run.ledger().max_live, 9u * 10 - 20);
}

// Of identically equal gaps the smallest pair, also of different radii: 10 + t - 2 = 12 + t - 4.
TEST(ClosestPairDiscs, EqualGaps) {
  const std::vector<Trajectory> equal{disc({0}, {100}, {2}), disc({12, 1}, {100}, {2}),
                                      disc({0}, {0}, {1}), disc({10, 1}, {0}, {1})};
  const Scene scene = discs(equal, 0, 5);
  const TwinRun run(scene, kAsked);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.ledger().external, 0u);
  // The gaps become equal with a new motion, and differ again.
  Scene later = scene;
  auto& pieces = later.objects[1].motion.pieces;
  pieces[0] = {std::nullopt, Rational(2), disc({14}, {100}, {2})};
  pieces.push_back({Rational(2), Rational(4), disc({12, 1}, {100}, {2})});
  pieces.push_back({Rational(4), std::nullopt, disc({8, 2}, {100}, {2})});
  const TwinRun turn(later, kAsked);
  EXPECT_EQ(turn.begins_with, (Ids{2, 3}));
  EXPECT_EQ(turn.attribute(), (Ids{2, 3}));
  EXPECT_EQ(turn.ledger().external, 2u);
  EXPECT_EQ(count(turn, "tie"), 1u);
}

// Equal gaps from an instant on at which no polynomial of case II fails: two points pass through each
// other, and two discs touch, at 0. The gap of 2 and 3 is -t - 2 t^2, then t; that of 0 and 1 is |t|. On
// a line the triangulation names all pairs at all times; else it changes at that instant, too.
TEST(ClosestPairDiscs, EqualGapsAfterATouch) {
  const Rational half(Integer(1), Integer(2)), quarter(Integer(1), Integer(4));
  for (const int x : {0, 50}) {
    const int y = 50 - x;
    Scene scene = discs({disc({x}, {y}, {0}), disc({x, 1}, {y}, {0}), disc({0}, {0}, {0, 0, half}),
                         disc({0, 1, 1}, {0}, {0, 0, half})}, 0, 1);
    scene.start = -quarter;
    scene.end = quarter;
    const TwinRun run(scene, kAsked), twin(scene, kAsked, "sturm");
    EXPECT_EQ(run.begins_with, (Ids{2, 3}));
    EXPECT_EQ(run.attribute(), (Ids{0, 1}));
    EXPECT_EQ(run.ledger().external, 1u);
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

// Radii that move change the pair though no centre does.
TEST(ClosestPairDiscs, RadiiThatMove) {
  const Scene scene = discs({disc({0}, {0}, {1, 1}), disc({20}, {0}, {1}), disc({0}, {21}, {9, -1}),
                             disc({40}, {40}, {1})}, 0, 8);
  const TwinRun run(scene, kAsked), twin(scene, kAsked, "sturm");
  EXPECT_EQ(run.begins_with, (Ids{0, 2}));
  EXPECT_EQ(run.attribute(), (Ids{0, 1}));
  EXPECT_EQ(run.ledger().external, 1u);
  EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
}

TEST(ClosestPairDiscs, NoneToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> paths;
    for (int i = 0; i < n; ++i) paths.push_back(disc({10 * i, 1 - i}, {i * i, i}, {1}));
    Scene scene = scene_of(paths, 0, Rational(9));
    scene.extents = Extents::kRadius;
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, kAsked).begins_with.size(), n < 2 ? 0u : 2u);
  }
}

// Jumps of positions and radii are insertions; what they change is no event of its own.
TEST(ClosestPairDiscs, Jumps) {
  Scene scene = discs({disc({0}, {0}, {1}), disc({5}, {0}, {1}), disc({0}, {9}, {1})}, 0, 4);
  scene.jumps = true;
  auto& pieces = scene.objects[0].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), Rational(2), disc({5}, {1}, {1})});  // onto the second
  pieces.push_back({Rational(2), std::nullopt, disc({0}, {6}, {1})});
  const TwinRun run(scene, kAsked);
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.attribute(), (Ids{0, 2}));
  EXPECT_EQ(run.ledger().external, 0u);
}

TEST(ClosestPairDiscs, EndsInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      const Scene scene = lattice_of_discs(seed, 7, 2);
      const TwinRun run(scene, {ask("closest_pair_discs")}, arithmetic);
      EXPECT_TRUE(run.ledger().corrupt || run.attribute().size() <= 2) << arithmetic;
    }
  }
}

// ---- metamorphic

std::vector<Moment> moments(const Image& image) {
  return moments_of(external_events(image.scene, ask("closest_pair_discs")), image,
                    [&](const Recorded& event) -> std::optional<std::string> {
                      std::vector<ObjectId> ids;
                      for (const ObjectId id : event.ids) ids.push_back(image.old_id(id));
                      for (std::size_t i = 0; i + 1 < ids.size(); i += 2) {
                        if (ids[i] > ids[i + 1]) std::swap(ids[i], ids[i + 1]);
                      }
                      std::uint8_t kind = event.kind;
                      if (image.reverses_time()) {
                        std::rotate(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 4 * 2),
                                    ids.end());
                        if (kind == ClosestPairDiscs::kContact) {
                          kind = ClosestPairDiscs::kApart;
                        } else if (kind == ClosestPairDiscs::kApart) {
                          kind = ClosestPairDiscs::kContact;
                        }
                      }
                      std::string text = std::to_string(kind);
                      for (const ObjectId id : ids) text += " " + std::to_string(id);
                      return text;
                    });
}

// Time reversed and stretched, mirrored, turned, carried along, permuted, enlarged: the same changes. In
// space not all of that.
TEST(ClosestPairDiscs, Metamorphic) {
  std::size_t seen = 0, seen_in_space = 0;
  for (const auto& [dimension, degree] : {std::pair(2, 1), {2, 2}, {3, 1}}) {
    if (kSanitized && degree > 1) continue;
    SCOPED_TRACE(std::to_string(dimension) + " axes, degree " + std::to_string(degree));
    Random random(static_cast<std::uint64_t>(degree) + 3);
    std::vector<Trajectory> paths;
    for (int i = 0; i < 7; ++i) {
      Trajectory t = random.small_path(dimension, degree, 3000);
      t.coordinates.push_back({random.between(70, 150), random.between(-30, 30)});
      paths.push_back(std::move(t));
    }
    const Scene scene = discs(paths, -2, 2);
    const Rational third(Integer(1), Integer(3));
    Trajectory along = path({{1000, -third}, {5, third, -7}});
    if (dimension == 3) along.coordinates.push_back({-third, 11, 2});
    along.coordinates.push_back({0});
    std::vector<ObjectId> name;
    for (ObjectId i = 0; i < 7; ++i) name.push_back((3 * i + 2) % 7);
    const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"});
    (dimension == 3 ? seen_in_space : seen) += expected.size();
    std::vector<Image> images{in_time(scene, {}, Rational(-2) * third, third),
                              carried(scene, {}, along), turned(scene, {}),
                              permuted(scene, {}, name)};
    if (dimension == 2) {
      images.push_back(in_time(scene, {}, -1, 0));
      images.push_back(mirrored(scene, {}, 0));
      images.push_back(mirrored(scene, {}, 1));
      images.push_back(scaled(scene, {}, Rational(7) * third));
    }
    for (const Image& image : images) {
      SCOPED_TRACE(image.how);
      expect_same_moments(expected, moments(image));
    }
  }
  EXPECT_GT(seen, kSanitized ? 2u : 6u);
  EXPECT_GT(seen_in_space, 0u);
}

}  // namespace closest_pair_discs_test
}  // namespace kinex::test
