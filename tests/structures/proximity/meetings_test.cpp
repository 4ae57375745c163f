// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of boxes, and of discs, that meet: counts by hand and by brute force, ties, touches, flight
// plans. Structures for one attribute run together: they report the same changes.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/fresh_runs.h"
#include "tests/structures/proximity/meetings_support.h"

namespace kinex::test {
namespace meetings_test {

using Ids = std::vector<ObjectId>;

std::uint64_t count(const TwinRun& run, const std::string& kind) {
  const auto& kinds = run.ledger().by_kind;
  const auto found = kinds.find(kind);
  return found == kinds.end() ? 0 : found->second;
}

struct Counted {
  int n, dimension;
  std::uint64_t seed;
  Extents extents;
  std::uint64_t at_start, meet, part;  // 0 < t < 10
  std::uint64_t at_end = 0;            // meetings at t = 10
};

const Counted kCounted[] = {{8, 2, 1, Extents::kRadius, 2, 4, 6},
                            {10, 2, 2, Extents::kRadius, 3, 5, 8},
                            {16, 2, 4, Extents::kRadius, 7, 15, 21},
                            {10, 3, 2, Extents::kRadius, 1, 3, 4},
                            {8, 2, 1, Extents::kHalfExtents, 2, 8, 10},
                            {10, 2, 2, Extents::kHalfExtents, 1, 12, 13},
                            {16, 2, 4, Extents::kHalfExtents, 6, 19, 25, 1},
                            {10, 3, 2, Extents::kHalfExtents, 0, 1, 1}};

TEST(Meetings, ReferenceCounts) {
  for (const Counted& one : kCounted) {
    const bool discs = one.extents == Extents::kRadius;
    SCOPED_TRACE(std::to_string(one.n) + (discs ? " discs" : " boxes") + " in " +
                 std::to_string(one.dimension) + " axes");
    const Scene scene = extended_reference(one.n, one.dimension, one.seed, one.extents);
    const TwinRun run(scene, meetings_in(scene));
    EXPECT_EQ(run.begins_with.size(), 2 * one.at_start);
    EXPECT_EQ(count(run, "meet"), one.meet + one.at_end);
    EXPECT_EQ(count(run, "part"), one.part);
    EXPECT_EQ(run.ledger().external, one.meet + one.part + one.at_end);
    if (discs) {
      EXPECT_EQ(run.ledger().failures, one.meet + one.part);  // none in vain
    }
    if (one.n > 8 && (discs || one.n > 10)) continue;
    const TwinRun twin(scene, meetings_in(scene), "sturm");
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

TEST(SlowMeetings, ReferenceCountsInSturm) {
  for (const Counted& one : kCounted) {
    SCOPED_TRACE(one.n);
    const Scene scene = extended_reference(one.n, one.dimension, one.seed, one.extents);
    EXPECT_EQ(TwinRun(scene, meetings_in(scene)).sink.log.lines,
              TwinRun(scene, meetings_in(scene), "sturm").sink.log.lines);
  }
}

// The hard bound; at 0 all centres coincide.
TEST(Meetings, EachTwoMeetOnce) {
  for (const Extents extents : kBothExtents) {
    for (int dimension = 1; dimension <= 3; ++dimension) {
      for (int n = 3; n <= 6; ++n) {
        SCOPED_TRACE(std::to_string(n) + " in " + std::to_string(dimension) + " axes");
        const Scene scene = fan(n, dimension, extents);
        const TwinRun run(scene, meetings_in(scene));
        EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * (n - 1)));
        EXPECT_EQ(run.begins_with, Ids{});
        EXPECT_EQ(run.attribute(), Ids{});
        EXPECT_EQ(run.sink.log.lines, TwinRun(scene, meetings_in(scene), "sturm").sink.log.lines);
      }
    }
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 5 + static_cast<int>(seed % 5), dimension = 1 + static_cast<int>(seed % 3);
    for (const Extents extents : kBothExtents) {
      const Scene scene = extended_lattice(seed, n, dimension, extents);
      external += TwinRun(scene, meetings_in(scene)).ledger().external;
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 3 * test::seen_in_fewer(seeds));
}

TEST(Meetings, TinyLattices) { on_lattices(90); }

TEST(SlowMeetings, TinyLattices) { on_lattices(1200); }

// Objects come, go and change their motions; exact and sturm agree line by line.
TEST(Meetings, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 8u : 3u); ++seed) {
      for (const Extents extents : kBothExtents) {
        SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
        const int dimension = 1 + static_cast<int>(seed % 3);
        const Scene scene =
            extended_flights(seed, 7, dimension, degree, seed % 2 == 0, extents);
        const TwinRun run(scene, meetings_in(scene)), twin(scene, meetings_in(scene), "sturm");
        EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
        external += run.ledger().external;
        updates += run.ledger().motion_updates;
      }
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(60u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(Meetings, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (const Extents extents : kBothExtents) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SCOPED_TRACE(seed);
      const int dimension = 1 + static_cast<int>(seed % 3);
      const Scene scene =
          extended_flights(seed, 7, dimension, 2, true, extents, plan_instants(seed));
      runs.expect_to_go_on(scene, meetings_in(scene), seed);
    }
  }
  runs.expect_changes();
}

Scene two(const Trajectory& a, const Trajectory& b, Extents extents, int end = 4) {
  return extended_scene({a, b}, extents, 0, Rational(end));
}

// Events of a run, "meet 0 1" or "part 0 1" each.
std::vector<std::string> changes(const Scene& scene) {
  const TwinRun run(scene, meetings_in(scene));
  std::vector<std::string> result;
  const std::string first = meetings_in(scene)[0].structure;
  for (const std::string& line : run.sink.log.lines) {
    if (line.ends_with(" !") && line.starts_with(first + " ")) {
      result.push_back(line.substr(first.size() + 1, line.size() - first.size() - 3));
    }
  }
  return result;
}

TEST(Meetings, TouchesAtAnInstantAreNothing) {
  // A disc passes another at the distance of the sum of their radii, and a corner a corner.
  const Scene pass = two(path({{-4, 2}, {3}, {2}}), path({{0}, {0}, {1}}), Extents::kRadius);
  EXPECT_EQ(changes(pass), std::vector<std::string>{});
  // A radius that touches and shrinks again: r = 3 - (t - 2)^2 at the distance 3 from a point.
  const Scene breath = two(path({{0}, {0}, {-1, 4, -1}}), path({{3}, {0}, {0}}), Extents::kRadius);
  Scene shorter = breath;
  shorter.start = 1;
  shorter.end = Rational(3);
  EXPECT_EQ(changes(shorter), std::vector<std::string>{});
  // The corner of a box passes the corner of another: x apart before, y apart after.
  const Scene corner = two(path({{-4, 2}, {0, -1}, {1}, {1}}), path({{0}, {0}, {1}, {1}}),
                           Extents::kHalfExtents);
  EXPECT_EQ(changes(corner), (std::vector<std::string>{"meet 0 1", "part 0 1"}));
  const Scene exact_corner = two(path({{-4, 1}, {0, 1}, {1}, {1}}), path({{0}, {0}, {1}, {1}}),
                                 Extents::kHalfExtents, 9);
  EXPECT_EQ(changes(exact_corner), std::vector<std::string>{});  // at t = 2 alone
}

// Discs and boxes that touch identically meet, also from a new flight plan on.
TEST(Meetings, IdenticalTouches) {
  for (const Extents extents : kBothExtents) {
    const auto still = [&](int x, Rational v) {
      std::vector<std::vector<Rational>> axes{{x, v}, {0}, {1}};
      if (extents == Extents::kHalfExtents) axes.push_back({1});
      return path(std::move(axes));
    };
    const TwinRun touch(two(still(0, 1), still(2, 1), extents), meetings_in(two(still(0, 1), still(2, 1), extents)));
    EXPECT_EQ(touch.begins_with, (Ids{0, 1}));
    EXPECT_EQ(touch.ledger().external, 0u);
    // They come near until 1, go on side by side until 2, and part.
    Scene scene = two(still(0, 1), still(3, 0), extents);
    const auto shifted = [&](Rational x) {
      Trajectory t = still(0, 0);
      t.coordinates[0] = {std::move(x)};
      return t;
    };
    auto& pieces = scene.objects[0].motion.pieces;
    pieces[0].to = Rational(1);
    pieces.push_back({Rational(1), Rational(2), shifted(1)});
    pieces.push_back({Rational(2), std::nullopt, path([&] {
                        Trajectory t = shifted(3);
                        t.coordinates[0] = {3, -1};
                        return t.coordinates;
                      }())});
    EXPECT_EQ(changes(scene), (std::vector<std::string>{"meet 0 1", "part 0 1"}));
    // The same, then into each other: one meeting.
    Scene on = scene;
    on.objects[0].motion.pieces[2].trajectory.coordinates[0] = {-1, 1};
    EXPECT_EQ(changes(on), (std::vector<std::string>{"meet 0 1"}));
  }
}

// A grid whose cells could be just as wide as the discs: a centre that comes to rest on a line stays
// in its cell, and touches a disc on the next line, two cells away.
TEST(Meetings, TouchesAcrossACell) {
  std::vector<Trajectory> t{path({{1, 1}, {1}}), path({{4}, {1}}), path({{0}, {0}})};
  for (const int x : {8, 9, 10, 11, 12, 14, 16, 18, 20, 22, 24}) t.push_back(path({{x}, {0}}));
  Scene scene = extended_scene(t, Extents::kRadius, 0, Rational(3));
  auto& pieces = scene.objects[0].motion.pieces;
  pieces[0].to = Rational(1);
  pieces.push_back({Rational(1), std::nullopt, path({{2}, {1}})});
  EXPECT_EQ(changes(scene), std::vector<std::string>{"meet 0 1"});
}

// Extents that move: discs at rest meet and part as their radii do.
TEST(Meetings, RadiiThatMove) {
  // r = 2 - (t - 1)(t - 3) (t - 5) / 8 at the distance 4 from a disc of radius 2.
  const Rational eighth(Integer(1), Integer(8));
  const std::vector<Rational> radius{Rational(2) + Rational(15) * eighth, Rational(-23) * eighth,
                                     Rational(9) * eighth, -eighth};
  const Scene discs = two(path({{0}, {0}, radius}), path({{4}, {0}, {2}}), Extents::kRadius, 6);
  EXPECT_EQ(changes(discs),
            (std::vector<std::string>{"part 0 1", "meet 0 1", "part 0 1"}));
  // A point is a disc of radius 0: it meets a point only where they stay together.
  const Scene points = two(path({{0, 1}, {0}, {0}}), path({{2}, {0}, {0}}), Extents::kRadius);
  EXPECT_EQ(changes(points), std::vector<std::string>{});
  const Scene equal = two(path({{0, 1}, {0}, {0}}), path({{0, 1}, {0}, {0}}), Extents::kRadius);
  EXPECT_EQ(TwinRun(equal, meetings_in(equal)).begins_with, (Ids{0, 1}));
}

// Jumps of positions and of extents.
TEST(Meetings, Jumps) {
  for (const Extents extents : kBothExtents) {
    const auto at = [&](int x, int size) {
      std::vector<std::vector<Rational>> axes{{x}, {0}, {size}};
      if (extents == Extents::kHalfExtents) axes.push_back({size});
      return path(std::move(axes));
    };
    Scene scene = two(at(0, 1), at(5, 1), extents);
    scene.jumps = true;
    auto& pieces = scene.objects[0].motion.pieces;
    pieces[0].to = Rational(1);
    pieces.push_back({Rational(1), Rational(2), at(0, 4)});
    pieces.push_back({Rational(2), Rational(3), at(0, 1)});
    pieces.push_back({Rational(3), std::nullopt, at(4, 1)});
    const TwinRun run(scene, meetings_in(scene));
    EXPECT_EQ(run.begins_with, Ids{});
    EXPECT_EQ(run.attribute(), (Ids{0, 1}));
    EXPECT_EQ(run.ledger().external, 0u);  // jumps are insertions
    EXPECT_EQ(run.ledger().insertions, 3u);
  }
}

TEST(Meetings, NoneToThree) {
  for (const Extents extents : kBothExtents) {
    for (int n = 1; n <= 3; ++n) {
      const Scene scene = fan(n, 2, extents);
      EXPECT_EQ(TwinRun(scene, meetings_in(scene)).ledger().external,
                static_cast<std::uint64_t>(n * (n - 1)));
    }
    Scene none = fan(1, 2, extents);
    none.objects.clear();
    EXPECT_EQ(TwinRun(none, meetings_in(none)).attribute(), Ids{});
  }
}

// All 2n ends at one place at one instant, identically equal boxes, zero extents.
TEST(Meetings, ManyEndsAtOnce) {
  for (const Extents extents : kBothExtents) {
    std::vector<Trajectory> t;
    for (int i = 0; i < 7; ++i) {
      std::vector<std::vector<Rational>> axes{{0, i / 2 - 1}, {0, i % 3 - 1}};
      for (int k = 0; k < (extents == Extents::kRadius ? 1 : 2); ++k) axes.push_back({i % 2});
      t.push_back(path(std::move(axes)));
    }
    const Scene scene = extended_scene(t, extents, -3, Rational(3));
    const TwinRun run(scene, meetings_in(scene)), twin(scene, meetings_in(scene), "sturm");
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
    EXPECT_GT(run.ledger().external, 5u);
  }
}

// ---- metamorphic

std::vector<Moment> moments(const Image& image, const std::string& structure) {
  Trial run(image.scene, structure, "exact", AuditLevel::kEvents);
  run.without_twin();
  run.sink.recorder.instants = 1000000;
  run.to_end().expect_clean();
  return moments_of(run.sink.recorder.events, image,
                    [&](const Recorded& event) -> std::optional<std::string> {
                      if (!event.external) return std::nullopt;
                      const ObjectId a = image.old_id(event.ids[0]), b = image.old_id(event.ids[1]);
                      const bool meets = (event.kind == 0) != image.reverses_time();
                      return (meets ? "meet " : "part ") + std::to_string(std::min(a, b)) + " " +
                             std::to_string(std::max(a, b));
                    });
}

// Time reversed and stretched, mirrored, carried along, permuted, enlarged, in the plane and in space: the
// same meetings.
TEST(Meetings, Metamorphic) {
  std::size_t seen = 0, seen_in_space = 0;
  for (const auto& [dimension, degree] : {std::pair(2, 1), {2, 2}, {3, 1}}) {
    if (kSanitized && degree > 1) continue;
    for (const Extents extents : kBothExtents) {
      Random random(static_cast<std::uint64_t>(degree) + 3);
      std::vector<Trajectory> paths;
      const int more = extents == Extents::kRadius ? 1 : dimension;
      for (int i = 0; i < 8; ++i) {
        Trajectory t = random.small_path(dimension, degree, 3000);
        for (int k = 0; k < more; ++k) {
          t.coordinates.push_back({random.between(700, 1500), random.between(-300, 300)});
        }
        paths.push_back(std::move(t));
      }
      const Scene scene = extended_scene(paths, extents, -2, Rational(2));
      const Rational third(Integer(1), Integer(3));
      Trajectory along = path({{1000, -third}, {5, third, -7}});
      if (dimension == 3) along.coordinates.push_back({-third, 11, 2});
      for (int k = 0; k < more; ++k) along.coordinates.push_back({0});
      std::vector<ObjectId> name;
      for (ObjectId i = 0; i < 8; ++i) name.push_back((3 * i + 2) % 8);
      std::vector<std::string> structures{"box_pairs"};
      if (extents == Extents::kRadius) {
        structures = {"disc_pairs_all", "disc_pairs_boxes", "disc_pairs_grid", "box_pairs"};
      }
      for (const std::string& structure : structures) {
        SCOPED_TRACE(structure + " in " + std::to_string(dimension) + " axes");
        const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"}, structure);
        (dimension == 3 ? seen_in_space : seen) += expected.size();
        std::vector<Image> images{in_time(scene, {}, -1, 0),
                                  in_time(scene, {}, Rational(-2) * third, third),
                                  mirrored(scene, {}, 0),
                                  mirrored(scene, {}, 1),
                                  scaled(scene, {}, Rational(7) * third),
                                  carried(scene, {}, along),
                                  permuted(scene, {}, name)};
        if (dimension == 3) images.push_back(mirrored(scene, {}, 2));
        if (structure != "box_pairs") images.push_back(turned(scene, {}));
        for (const Image& image : images) {
          SCOPED_TRACE(image.how);
          expect_same_moments(expected, moments(image, structure));
        }
      }
    }
  }
  EXPECT_GT(seen, kSanitized ? 40u : 100u);
  EXPECT_GT(seen_in_space, 20u);
}

}  // namespace meetings_test
}  // namespace kinex::test
