// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/bounding_box.h"

#include <string>
#include <utility>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace bounding_box_test {

// A run and its scene, which the run refers to.
struct BoxRun {
  explicit BoxRun(Scene given) : scene(std::move(given)), trial(scene, "bounding_box") {}
  Scene scene;
  Trial trial;
};

std::vector<std::string> external_lines(const Trial& run) {
  std::vector<std::string> result;
  for (const std::string& line : run.sink.lines) {
    if (line.back() == '!') result.push_back(line.substr(line.find(' ') + 1));
  }
  return result;
}

// All n dual points of an axis are on a circle, so n changes an axis: `turn` turns the circles of
// different axes, so that no two changes are at one instant.
Scene circles(int n, int dimension) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<std::vector<Rational>> axes;
    for (int axis = 0; axis < dimension; ++axis) {
      const Rational a =
          Rational(Integer(6 - axis), Integer(n)) * (Rational(Integer(2 * i - n + 1), Integer(2)) +
                                                     Rational(Integer(1), Integer(7 - 2 * axis)));
      const Rational all = Rational(1) + a * a;
      const Rational x = (Rational(1) - a * a) / all, y = Rational(2) * a / all;
      axes.push_back(axis % 2 == 0 ? std::vector<Rational>{x, y} : std::vector<Rational>{y, x});
    }
    t.push_back(path(std::move(axes)));
  }
  return scene_of(t, -1000000, Rational(1000000));
}

TEST(BoundingBox, EveryPointOfACircleOfLinesIsOnTheBoxOnce) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (const int n : {3, 4, 5, 8, 12}) {
      SCOPED_TRACE(std::to_string(n) + " points in " + std::to_string(dimension) + " axes");
      BoxRun run_scene(circles(n, dimension));
      Trial& run = run_scene.trial;
      run.to_end().expect_clean();
      EXPECT_EQ(run.ledger().external, static_cast<std::uint64_t>(n * dimension));
    }
  }
}

TEST(BoundingBox, RandomFlights) {
  std::uint64_t external = 0;
  for (const int dimension : {1, 2, 3}) {
    for (const int degree : {1, 2, 3}) {
      for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
        SCOPED_TRACE(std::to_string(dimension) + " axes, degree " + std::to_string(degree) +
                     ", seed " + std::to_string(seed));
        BoxRun run_scene(random_flights(seed, 10, dimension, degree, seed != 1));
        Trial& run = run_scene.trial;
        run.to_end().expect_clean();
        external += run.ledger().external;
      }
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(150u));
}

// 3 to 8 points with tiny coordinates and velocities, in 1 to 3 axes: ties and meetings everywhere.
// Each run is audited after every event, and compared with `sturm`.
void run_lattices(std::uint64_t first, std::uint64_t last) {
  std::uint64_t external = 0, shared = 0;
  for (std::uint64_t seed = first; seed <= first + test::fewer(last - first); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int n = random.between(3, 8), size = random.between(1, 4);
    const int dimension = random.between(1, 3), degree = seed % 4 == 0 ? random.between(2, 3) : 1;
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(random.small_path(dimension, degree, size));
    BoxRun run_scene(scene_of(t, -3, Rational(3)));
    Trial& run = run_scene.trial;
    run.to_end().expect_clean();
    external += run.ledger().external;
    shared += run.ledger().simultaneous_groups;
  }
  EXPECT_GT(external, 2 * test::seen_in_fewer(last - first));
  EXPECT_GT(shared, test::seen_in_fewer(last - first) / 2);
}

TEST(BoundingBox, RandomLattices) { run_lattices(1, 80); }
TEST(SlowBoundingBox, RandomLattices) { run_lattices(81, 800); }

TEST(BoundingBox, FewPoints) {
  Scene none = scene_of({path({{0}, {0}})}, 0, Rational(9));
  none.objects[0].motion.pieces[0].from = Rational(3);
  none.objects[0].motion.pieces[0].to = Rational(5);
  BoxRun run_scene(none);
  Trial& run = run_scene.trial;
  EXPECT_EQ(run.ids(), std::vector<ObjectId>{});
  run.run_until(Rational(4));
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 0, 0, 0}));
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), std::vector<ObjectId>{});
  // Two that pass: each is on two sides, and both change at one instant.
  BoxRun two_scene(scene_of({path({{0, 1}, {0}}), path({{1}, {0, 1}})}, -1, Rational(3)));
  Trial& two = two_scene.trial;
  EXPECT_EQ(two.ids(), (std::vector<ObjectId>{0, 1, 1, 0}));
  two.to_end().expect_clean();
  EXPECT_EQ(two.ids(), (std::vector<ObjectId>{1, 0, 0, 1}));
  EXPECT_EQ(two.ledger().external, 2u);  // y at 0, x at 1
  EXPECT_EQ(two.ledger().failures, 4u);
  BoxRun three_scene(scene_of({path({{0}}), path({{1}}), path({{2}})}, 0, Rational(1)));
  Trial& three = three_scene.trial;
  three.to_end().expect_clean();
  EXPECT_EQ(three.ids(), (std::vector<ObjectId>{0, 2}));
}

TEST(BoundingBox, TiesGoToTheSmallestId) {
  // All equal; 2 and 1 alike, beside 0; a new motion that makes 3 equal to 1.
  BoxRun equal_scene(scene_of({path({{1, 1}}), path({{1, 1}}), path({{1, 1}})}, 0, Rational(4)));
  Trial& equal = equal_scene.trial;
  equal.to_end().expect_clean();
  EXPECT_EQ(equal.ids(), (std::vector<ObjectId>{0, 0}));
  Scene scene = scene_of({path({{0}}), path({{5}}), path({{5}}), path({{3, 1}})}, 0, Rational(4));
  scene.objects[3].motion.pieces[0].to = Rational(2);
  scene.objects[3].motion.pieces.push_back({Rational(2), std::nullopt, path({{5}})});
  BoxRun run_scene(scene);
  Trial& run = run_scene.trial;
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 1}));
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 1}));
  EXPECT_EQ(run.ledger().external, 0u);
}

// A pencil: all meet at one point of time and space, and every side changes.
TEST(BoundingBox, AnInstantIsOneChange) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) t.push_back(path({{0, i - 4}, {0, (i * 5) % 9 - 4}}));
  BoxRun run_scene(scene_of(t, -1, Rational(1)));
  Trial& run = run_scene.trial;
  run.to_end().expect_clean();
  EXPECT_EQ(external_lines(run), std::vector<std::string>{"settled !"});
}

TEST(BoundingBox, ASingleFailureIsTheChange) {
  BoxRun run_scene(scene_of({path({{0}}), path({{-2, 1}}), path({{5}})}, 0, Rational(3)));
  Trial& run = run_scene.trial;
  run.to_end().expect_clean();
  EXPECT_EQ(external_lines(run), std::vector<std::string>{"replace 1 0 !"});
}

TEST(BoundingBox, ExtremeNumbers) {
  for (const char* size : {"1e150", "1e-150", "1e400", "1e-400"}) {
    const Rational unit = *Rational::parse(size);
    std::vector<Trajectory> t;
    for (int i = 0; i < 8; ++i) {
      t.push_back(path({{unit * Rational((i * 5) % 8), unit * Rational(3 - i)},
                        {Rational((i * 3) % 8), Rational(i - 4)}}));
    }
    BoxRun run_scene(scene_of(t, 0, Rational(50)));
    Trial& run = run_scene.trial;
    run.to_end().expect_clean();
    EXPECT_GT(run.ledger().external, 2u) << size;
  }
}

TEST(BoundingBox, JumpsAreErasuresAndInsertions) {
  Scene scene = scene_of({path({{0}}), path({{4}}), path({{2}})}, 0, Rational(4));
  scene.objects[2].motion.pieces[0].to = Rational(1);
  scene.objects[2].motion.pieces.push_back({Rational(1), std::nullopt, path({{9}})});
  BoxRun run_scene(scene);
  Trial& run = run_scene.trial;
  run.to_end().expect_clean();
  EXPECT_EQ(run.ids(), (std::vector<ObjectId>{0, 2}));
  EXPECT_EQ(run.ledger().external, 0u);
  EXPECT_EQ(run.ledger().insertions, 1u);
}

TEST(BoundingBox, EverySideHasALineOfTheLedger) {
  BoxRun run_scene(circles(8, 2));
  Trial& run = run_scene.trial;
  run.to_end();
  const StructureLedger& ledger = run.ledger();
  ASSERT_EQ(ledger.parts.size(), 4u);
  EXPECT_EQ(ledger.parts[0].name, "minimum of axis 0");
  EXPECT_EQ(ledger.parts[3].name, "maximum of axis 1");
  PartLedger sum;
  for (const PartLedger& line : ledger.parts) {
    EXPECT_GT(line.failures, 0u) << line.name;
    EXPECT_EQ(line.max_live, 7u) << line.name;
    sum.failures += line.failures;
    sum.created += line.created;
    sum.retracted += line.retracted;
  }
  EXPECT_EQ(sum.failures, ledger.failures);
  EXPECT_EQ(sum.created, ledger.certificates_created);
  EXPECT_EQ(sum.retracted, ledger.certificates_retracted);
}

}  // namespace bounding_box_test
}  // namespace kinex::test
