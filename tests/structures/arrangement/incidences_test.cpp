// SPDX-License-Identifier: GPL-3.0-or-later
// Which points are above which lines: counts by hand and by brute force, ties, touches, flight plans.
// Structures for one attribute run together: they report the same changes.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/arrangement/line_scenes.h"
#include "tests/structures/arrangement/replayed_run.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/fresh_runs.h"

namespace kinex::test {
namespace incidences_test {

using Ids = std::vector<ObjectId>;

// Cuttings of the usual size, of one line, and of so many that few others or none are left.
std::vector<Request> incidences() {
  return {ask("incidences_all"), ask("incidences_cutting"), ask("incidences_cutting", "r", 1),
          ask("incidences_cutting", "r", 3)};
}

// The hard bound: every point is on every line twice.
TEST(Incidences, EveryPointIsOnEveryLineTwice) {
  for (const auto& [n, m] : {std::pair(2, 2), {3, 4}, {1, 5}, {5, 1}}) {
    SCOPED_TRACE(std::to_string(n) + " points, " + std::to_string(m) + " lines");
    const Scene scene = points_through_lines(n, m);
    const TwinRun run(scene, incidences()), twin(scene, incidences(), "sturm");
    EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(2 * n * m));
    EXPECT_EQ(run.ledger().failures, static_cast<std::uint64_t>(2 * n * m));  // none in vain
    EXPECT_EQ(run.begins_with, Ids{});
    EXPECT_EQ(run.attribute(), Ids{});
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

struct Counted {
  int n;
  std::uint64_t seed;
  std::uint64_t external;
  std::size_t at_start;
};

// Roots of the polynomials of all pairs in 0 < t < 10, found by another program. Of scene 10, 2 one
// point is on a line at t = 0.
TEST(Incidences, ReferenceCounts) {
  for (const Counted& one : {Counted{6, 1, 6, 0}, {8, 1, 12, 0}, {10, 2, 18, 2}, {12, 3, 30, 0}}) {
    SCOPED_TRACE(one.n);
    const Scene scene = line_reference(one.n, one.seed, LineUse::kWithPoints);
    const TwinRun run(scene, incidences()), twin(scene, incidences(), "sturm");
    EXPECT_EQ(run.ledger().external, one.external);
    if (one.n != 10) {
      EXPECT_EQ(run.begins_with.size(), 2 * one.at_start);
    }
    EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
  }
}

void on_lattices(std::uint64_t seeds) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 3 + static_cast<int>(seed % 6);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kWithPoints);
    external += TwinRun(scene, incidences()).ledger().external;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(seeds));
}

TEST(Incidences, TinyLattices) { on_lattices(200); }

// More lines than in the samples, and structures that are rebuilt instead of repaired now and then.
void on_larger_lattices(std::uint64_t seeds) {
  std::uint64_t cells = 0, external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(seeds); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 8 + static_cast<int>(seed % 9);
    const Scene scene = lined(lattice_scene(seed, n, 2), LineUse::kWithPoints);
    const TwinRun run(scene, incidences());
    external += run.ledger().external;
    ReplayedRun replayed(scene, "incidences_cutting", seed % 4 == 0 ? seed : 0);
    cells += replayed.count("cell");
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(external, 10 * test::seen_in_fewer(seeds));
  EXPECT_GT(cells, 10 * test::seen_in_fewer(seeds));
}

TEST(Incidences, LargerLattices) { on_larger_lattices(60); }

TEST(SlowIncidences, LargerLattices) { on_larger_lattices(200); }

TEST(SlowIncidences, TinyLattices) { on_lattices(1200); }

// Lines and points come, go and change their motions; exact and sturm agree line by line.
TEST(Incidences, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3, 4}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 12u : 4u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = lined(random_flights(seed, 8, 2, degree, seed % 2 == 0),
                                LineUse::kWithPoints);
      const TwinRun run(scene, incidences()), twin(scene, incidences(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(60u));
  EXPECT_GT(updates, test::seen_in_fewer(60u));
}

// From any rational instant on, a run goes on as a fresh one does whose scene begins there.
TEST(Incidences, AFreshRunFromTheMiddle) {
  FreshRuns runs;
  for (std::uint64_t seed = 1; seed <= test::fewer(8u); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene =
        lined(random_flights(seed, 8, 2, 2, true, plan_instants(seed)), LineUse::kWithPoints);
    runs.expect_to_go_on(scene, incidences(), seed);
  }
  runs.expect_changes();
}

// Object 0 is a line, object 1 a point.
Scene two(const Trajectory& line, const Trajectory& point, int end = 4) {
  Scene scene = scene_of({line, point}, 0, Rational(end));
  scene.objects[0].line = true;
  return scene;
}

// The external events of a run, "above 0 1" or "below 0 1" each.
std::vector<std::string> changes(const Scene& scene) {
  const TwinRun run(scene, incidences());
  std::vector<std::string> result;
  const std::string first = incidences()[0].structure;
  for (const std::string& line : run.sink.log.lines) {
    if (line.ends_with(" !") && line.starts_with(first + " ")) {
      result.push_back(line.substr(first.size() + 1, line.size() - first.size() - 3));
    }
  }
  return result;
}

using Changes = std::vector<std::string>;

TEST(Incidences, TouchesAreNothing) {
  // The point's parabola touches the line y = 1 from above, and from below.
  EXPECT_EQ(changes(two(path({{0}, {1}}), path({{0}, {5, -4, 1}}))), Changes{});
  EXPECT_EQ(changes(two(path({{0}, {1}}), path({{0}, {-3, 4, -1}}))), Changes{});
  // A line turns about a point on it: y = (t - 2) (x - 3) + 1, the point at (3, 1).
  const Scene pivot = two(path({{-2, 1}, {7, -3}}), path({{3}, {1}}));
  EXPECT_EQ(changes(pivot), Changes{});
  EXPECT_EQ(TwinRun(pivot, incidences()).begins_with, Ids{});
}

// A point that is identically on a line is below it, also from a new flight plan on.
TEST(Incidences, IdenticalIncidences) {
  Scene scene = two(path({{1}, {0}}), path({{0}, {2, -1}}), 6);
  auto& pieces = scene.objects[1].motion.pieces;
  pieces[0].to = Rational(2);  // it comes down to the line y = x
  pieces.push_back({Rational(2), Rational(4), path({{-2, 1}, {-2, 1}})});  // goes along it
  pieces.push_back({Rational(4), std::nullopt, path({{2}, {-2, 1}})});     // and up again
  EXPECT_EQ(TwinRun(scene, incidences()).begins_with, (Ids{0, 1}));
  EXPECT_EQ(changes(scene), (Changes{"below 0 1", "above 0 1"}));
  // Down instead: it was below already.
  Scene down = scene;
  down.objects[1].motion.pieces[2].trajectory = path({{2}, {6, -1}});
  EXPECT_EQ(changes(down), (Changes{"below 0 1"}));
}

// One event for each point and line that changes at the instant, those below first.
TEST(Incidences, ManyAtOneInstant) {
  // Two points cross two coinciding lines at t = 2, one upwards and one downwards.
  Scene scene = scene_of({path({{0}, {0}}), path({{0}, {0}}), path({{1}, {-2, 1}}),
                          path({{5}, {2, -1}})},
                         0, Rational(4));
  scene.objects[0].line = scene.objects[1].line = true;
  EXPECT_EQ(changes(scene), (Changes{"below 0 3", "below 1 3", "above 0 2", "above 1 2"}));
  const TwinRun run(scene, incidences());
  EXPECT_EQ(run.ledger().simultaneous_groups, 1u);
  EXPECT_EQ(run.begins_with, (Ids{0, 3, 1, 3}));
  EXPECT_EQ(run.attribute(), (Ids{0, 2, 1, 2}));
}

// The triangle below y = t^2 - |x| and above y = 0 collapses at t = 0 and is there again. A point stays in
// it; the line y = x / 2 + t passes from below it to above it. All of that through the origin.
TEST(Incidences, ATriangleThatCollapsesForAnInstant) {
  const Rational half(Integer(1), Integer(2));
  const std::vector<Trajectory> paths{path({{-1}, {0, 0, 1}}), path({{1}, {0, 0, 1}}), path({{0}, {0}}),
                                      path({{half}, {0, 1}}), path({{0}, {0, 0, half}})};
  for (std::size_t first = 0; first < 4; ++first) {
    SCOPED_TRACE(first);
    std::vector<Trajectory> turned;
    for (std::size_t i = 0; i < 4; ++i) turned.push_back(paths[(first + i) % 4]);
    turned.push_back(paths[4]);
    Scene scene = scene_of(turned, -1, 1);
    for (std::size_t i = 0; i < 4; ++i) scene.objects[i].line = true;
    std::vector<Request> requests = incidences();
    requests.push_back(ask("incidences_cutting", "r", 4));
    EXPECT_EQ(TwinRun(scene, requests).ledger().external, 1u);
  }
}

// Five parallel lines pass through each other at t = 0: two of them, with a point between them, go from
// above the other three to below them.
TEST(Incidences, AStripThatPassesThreeLines) {
  const std::vector<Trajectory> paths{path({{0}, {0, -10, 1}}), path({{0}, {0, -10, -1}}),
                                      path({{0}, {0, 0, 1}}),   path({{0}, {0, 0, -1}}),
                                      path({{0}, {0}}),         path({{0}, {0, -10}})};
  for (const int r : {1, 2, 3, 4, 5}) {
    for (std::size_t first = 0; first < 5; ++first) {
      SCOPED_TRACE(std::to_string(r) + " of five lines from " + std::to_string(first));
      std::vector<Trajectory> turned;
      for (std::size_t i = 0; i < 5; ++i) turned.push_back(paths[(first + i) % 5]);
      turned.push_back(paths[5]);
      Scene scene = scene_of(turned, -1, 1);
      for (std::size_t i = 0; i < 5; ++i) scene.objects[i].line = true;
      const TwinRun run(scene, {ask("incidences_all"), ask("incidences_cutting", "r", r)});
      EXPECT_EQ(run.ledger().external, 3u);
    }
  }
}

// The same with more objects than sample lines.
TEST(Incidences, ManyFlights) {
  std::uint64_t external = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(degree == 1 ? 8u : 3u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = lined(random_flights(100 + seed, 16, 2, degree, seed % 2 == 0),
                                LineUse::kWithPoints);
      const TwinRun run(scene, incidences()), twin(scene, incidences(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(200u));
}

// Runs in inexact arithmetics end, in double with the pairs of the exact run or in corruption.
TEST(Incidences, InexactRunsEnd) {
  int agree = 0, corrupt = 0;
  for (const char* const arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(12u); ++seed) {
      SCOPED_TRACE(std::string(arithmetic) + ", seed " + std::to_string(seed));
      const Scene given = seed % 3 == 0 ? random_flights(seed, 12, 2, 2, true) : lattice_scene(seed, 12, 2);
      const Scene scene = lined(given, LineUse::kWithPoints);
      const std::vector<Request> cutting{ask("incidences_cutting", "r", 3)};
      TwinRun run(scene, cutting, arithmetic);
      EXPECT_EQ(run.simulator.run_until(std::nullopt), RunStatus::kDone);
      if (arithmetic != std::string("double")) continue;
      ++(run.ledger().corrupt ? corrupt : agree);
      if (run.ledger().corrupt) continue;
      EXPECT_EQ(run.attribute(), TwinRun(scene, cutting).attribute());
    }
  }
  EXPECT_GT(agree, 2 * corrupt);
}

TEST(Incidences, JumpsAreInsertions) {
  Scene scene = two(path({{0}, {0}}), path({{0}, {1}}));
  scene.jumps = true;
  auto& point = scene.objects[1].motion.pieces;
  point[0].to = Rational(1);
  point.push_back({Rational(1), std::nullopt, path({{0}, {-1}})});
  auto& line = scene.objects[0].motion.pieces;
  line[0].to = Rational(2);
  line.push_back({Rational(2), std::nullopt, path({{7}, {-3}})});
  const TwinRun run(scene, incidences());
  EXPECT_EQ(run.begins_with, (Ids{0, 1}));
  EXPECT_EQ(run.attribute(), (Ids{0, 1}));
  EXPECT_EQ(run.ledger().external, 0u);
  EXPECT_EQ(run.ledger().insertions, 2u);
}

TEST(Incidences, NoneToThree) {
  Scene scene = points_through_lines(1, 2);
  EXPECT_EQ(TwinRun(scene, incidences()).ledger().external, 4u);
  scene.objects.pop_back();  // lines alone
  EXPECT_EQ(TwinRun(scene, incidences()).ledger().external, 0u);
  scene.objects.pop_back();
  EXPECT_EQ(TwinRun(scene, incidences()).attribute(), Ids{});
  scene.objects.clear();
  EXPECT_EQ(TwinRun(scene, incidences()).attribute(), Ids{});
}

// ---- metamorphic: maps of lines and points that keep "above", each with its own image of (a, b)

std::vector<Moment> moments(const Image& image, bool upside_down = false) {
  Trial run(image.scene, "incidences_all", "exact", AuditLevel::kEvents);
  run.without_twin();
  run.sink.recorder.instants = 1000000;
  run.to_end().expect_clean();
  return moments_of(run.sink.recorder.events, image,
                    [&](const Recorded& event) -> std::optional<std::string> {
                      if (!event.external) return std::nullopt;
                      const ObjectId a = image.old_id(event.ids[0]), b = image.old_id(event.ids[1]);
                      const bool up = (event.kind == 0) != (image.reverses_time() != upside_down);
                      return (up ? "above " : "below ") + std::to_string(std::min(a, b)) + " " +
                             std::to_string(std::max(a, b));
                    });
}

using Axes = std::vector<std::vector<Rational>>;

// The scene with the coordinates of every object replaced.
template <class Map>
Image mapped(Scene scene, std::string how, const Map& map) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      Axes& c = piece.trajectory.coordinates;
      for (auto& axis : c) axis.resize(3);
      c = map(c, object.line);
      piece.trajectory.normalise();
    }
  }
  return {std::move(scene), {}, 1, 0, false, {}, std::move(how)};
}

std::vector<Rational> plus(std::vector<Rational> a, const std::vector<Rational>& b, int factor = 1) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += Rational(factor) * b[k];
  return a;
}

TEST(Incidences, Metamorphic) {
  std::size_t seen = 0;
  for (const int degree : {1, 2}) {
    Random random(static_cast<std::uint64_t>(degree) + 3);
    std::vector<Trajectory> paths;
    for (int i = 0; i < 9; ++i) paths.push_back(random.small_path(2, degree, 3000));
    const Scene scene = lined(scene_of(paths, -2, Rational(2)), LineUse::kWithPoints);
    const Rational third(Integer(1), Integer(3));
    std::vector<ObjectId> name;
    for (ObjectId i = 0; i < 9; ++i) name.push_back((4 * i + 2) % 9);
    const auto expected = moments({scene, {}, 1, 0, false, {}, "the same"});
    seen += expected.size();
    std::vector<Image> images{in_time(scene, {}, -1, 0), in_time(scene, {}, Rational(-2) * third, third),
                              permuted(scene, {}, name)};
    const std::vector<Rational> rise{5, third, -7};
    images.push_back(mapped(scene, "risen", [&](const Axes& c, bool) {
      return Axes{c[0], plus(c[1], rise)};
    }));
    images.push_back(mapped(scene, "sheared: y + 2x", [](const Axes& c, bool line) {
      if (!line) return Axes{c[0], plus(c[1], c[0], 2)};
      return Axes{plus(c[0], {2, 0, 0}), c[1]};
    }));
    images.push_back(mapped(scene, "carried to the right by 3", [](const Axes& c, bool line) {
      if (!line) return Axes{plus(c[0], {3, 0, 0}), c[1]};
      return Axes{c[0], plus(c[1], c[0], -3)};
    }));
    images.push_back(mapped(scene, "mirrored: -x", [](const Axes& c, bool) {
      return Axes{plus({0, 0, 0}, c[0], -1), c[1]};
    }));
    for (const Image& image : images) {
      SCOPED_TRACE(image.how);
      expect_same_moments(expected, moments(image));
    }
    // Upside down, above becomes below; and so it does for lines as points and points as lines.
    const Image down = mapped(scene, "upside down", [](const Axes& c, bool line) {
      return Axes{line ? plus({0, 0, 0}, c[0], -1) : c[0], plus({0, 0, 0}, c[1], -1)};
    });
    expect_same_moments(expected, moments(down, true));
    Image dual = mapped(scene, "dual", [](const Axes& c, bool) {
      return Axes{c[0], plus({0, 0, 0}, c[1], -1)};
    });
    for (SceneObject& object : dual.scene.objects) object.line = !object.line;
    expect_same_moments(expected, moments(dual));
  }
  EXPECT_GT(seen, 20u);
}

}  // namespace incidences_test
}  // namespace kinex::test
