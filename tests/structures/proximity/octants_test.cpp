// SPDX-License-Identifier: GPL-3.0-or-later
// The next points in octants: the structures that maintain them report the same changes, as many as
// another program has counted.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "structures/proximity/cone_neighbours.h"
#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/proximity/reference_scenes.h"
#include "tests/structures/proximity/twin_run.h"

namespace kinex::test {
namespace octants_test {

using Ids = std::vector<ObjectId>;

std::vector<Request> octants() { return {ask("octants_listed"), ask("octants_local")}; }

// Counts the pointers that differ from one instant to the next, of each wood, and the instants.
class PointerSink final : public EventSink {
 public:
  PointerSink(const Simulator& simulator, StructureId id) : simulator_(&simulator), id_(id) {}
  void event(const Event&, Arithmetic&) override {}
  void instant_ended() override {
    const std::vector<Ids> now = pointers();
    for (std::size_t wood = 0; wood < 2 && !before_.empty(); ++wood) {
      std::uint64_t differ = 0;
      for (std::size_t cone = 3 * wood; cone < 3 * wood + 3; ++cone) {
        for (std::size_t p = 0; p < now[cone].size(); ++p) {
          differ += now[cone][p] == before_[cone][p] ? 0 : 1;
        }
      }
      changes[wood] += differ;
      instants[wood] += differ == 0 ? 0 : 1;
    }
    before_ = now;
  }
  void begin() { before_ = pointers(); }
  std::uint64_t changes[2] = {0, 0}, instants[2] = {0, 0};

 private:
  std::vector<Ids> pointers() const {
    const auto& octants = dynamic_cast<const ConeNeighbours&>(simulator_->structure(id_));
    std::vector<Ids> result(6);
    for (std::size_t cone = 0; cone < 6; ++cone) {
      for (ObjectId p = 0; p < octants.objects(); ++p)
        result[cone].push_back(octants.next(cone, p));
    }
    return result;
  }

  const Simulator* simulator_;
  StructureId id_;
  std::vector<Ids> before_;
};

std::uint64_t of_kind(const StructureLedger& ledger, const std::string& kind) {
  const auto found = ledger.by_kind.find(kind);
  return found == ledger.by_kind.end() ? 0 : found->second;
}

struct Counted {
  int n;
  std::uint64_t seed;
  std::uint64_t swaps[4];  // by x, y, x + y, x - y
  std::uint64_t changes[2], instants[2];
};

TEST(Octants, ReferenceCounts) {
  for (const Counted& one : {Counted{6, 1, {8, 9, 3, 9}, {49, 37}, {22, 17}},
                             {8, 1, {14, 14, 6, 15}, {75, 62}, {33, 27}},
                             {10, 2, {20, 19, 19, 22}, {116, 126}, {48, 50}},
                             {12, 3, {12, 27, 17, 31}, {118, 82}, {45, 34}}}) {
    SCOPED_TRACE(std::to_string(one.n) + " points");
    Scene scene = reference_scene(one.n, 2, one.seed);
    scene.end = Rational(Integer(9999), Integer(1000));  // at 10 two points are level
    for (const Request& request : octants()) {
      const TwinRun run(scene, {request});
      EXPECT_EQ(of_kind(run.ledger(), "point"), one.changes[0] + one.changes[1]);
      const TwinRun twin(scene, {request}, "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      const Scene asked = TwinRun::asking(scene, {request});
      Simulator simulator(asked, planned_arithmetic("exact", asked), {});
      add_structures(simulator, asked);
      PointerSink sink(simulator, 0);
      simulator.set_sink(&sink);
      simulator.start();
      sink.begin();
      simulator.run_until(std::nullopt);
      for (const std::size_t wood : {0, 1}) {
        EXPECT_EQ(sink.changes[wood], one.changes[wood]);
        EXPECT_EQ(sink.instants[wood], one.instants[wood]);
      }
    }
    const TwinRun listed(scene, {ask("octants_listed")});
    ASSERT_EQ(listed.ledger().parts.size(), 4u);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      EXPECT_EQ(listed.ledger().parts[axis].failures, one.swaps[axis]) << "axis " << axis;
    }
  }
}

// The only failure of a wood at an instant changes two pointers: such failures are counted against a bound on
// the changes of pointers. On a lattice many share their instants.
TEST(Octants, AFailureChangesTwoPointers) {
  const auto alone = [](const TwinRun& run) {
    for (const BoundCheck& bound : run.simulator.bounds(run.ids[0])) {
      if (bound.id == "octants_local.failures") return bound;
    }
    return BoundCheck{};
  };
  for (const auto& [n, seed] : {std::pair(6, 1), {8, 1}, {10, 2}, {12, 3}}) {
    SCOPED_TRACE(n);
    const TwinRun run(reference_scene(n, 2, static_cast<std::uint64_t>(seed)),
                      {ask("octants_local")});
    const BoundCheck bound = alone(run);
    const Integer most = davenport_schinzel_bound(3, Integer(n)) - Integer(1);
    EXPECT_EQ(bound.bound, Integer(3 * n) * most);
    EXPECT_GT(bound.observed, Integer(0));
    EXPECT_LE(bound.observed + bound.observed, counted(of_kind(run.ledger(), "point")));
  }
  std::uint64_t shared = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(20u); ++seed) {
    SCOPED_TRACE(seed);
    const TwinRun run(lattice_scene(seed, 7, 2), {ask("octants_local")});
    const Integer observed = alone(run).observed;
    EXPECT_LE(observed + observed, counted(of_kind(run.ledger(), "point")));
    shared += observed < counted(run.ledger().failures);
  }
  EXPECT_GT(shared, test::seen_in_fewer(10u));
  // Two pairs far from each other, each with another order along y from t = 1 on: no failure is alone in its wood.
  const TwinRun twice(scene_of({path({{0}, {-1, 1}}), path({{3}, {0}}), path({{1000}, {499, 1}}),
                                path({{1003}, {500}})},
                               0, Rational(2)),
                      {ask("octants_local")});
  EXPECT_GE(twice.ledger().failures, 4u);
  EXPECT_EQ(alone(twice).observed, Integer(0));
  // Flight plans that change: no such bound.
  const TwinRun flights(random_flights(2, 8, 2, 1, true), {ask("octants_local")});
  EXPECT_EQ(alone(flights).id, "");
}

// All pairs change their order in all four lists: 4 C(n, 2) swaps.
TEST(Octants, EveryOrderIsReversed) {
  for (const int n : {2, 5, 9}) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{3 * i * i, -2 * i}, {i * i, -i}}));
    const TwinRun run(scene_of(t, 0, Rational(8 * n)), octants());
    const TwinRun listed(run.scene, {ask("octants_listed")});
    EXPECT_EQ(of_kind(listed.ledger(), "order"), static_cast<std::uint64_t>(2 * n * (n - 1)));
    EXPECT_EQ(listed.ledger().max_live, static_cast<std::uint64_t>(4 * (n - 1)));
    const TwinRun tree(run.scene, {ask("closest_pair_range_tree")});
    EXPECT_EQ(of_kind(tree.ledger(), "order"), static_cast<std::uint64_t>(2 * n * (n - 1)));
    if (n > 5) continue;
    for (const TwinRun* exact : {&run, &listed, &tree}) {
      const TwinRun twin(run.scene, exact->scene.maintain, "sturm");
      EXPECT_EQ(exact->sink.log.lines, twin.sink.log.lines);
    }
  }
}

TEST(Octants, TinyLattices) {
  std::uint64_t external = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(250u); ++seed) {
    SCOPED_TRACE(seed);
    const TwinRun run(lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2), octants());
    external += run.ledger().external;
    if (HasFailure()) return;
  }
  EXPECT_GT(external, test::seen_in_fewer(1000u));
}

TEST(SlowOctants, TinyLattices) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    const TwinRun run(lattice_scene(seed, 5 + static_cast<int>(seed % 5), 2), octants());
    if (HasFailure()) return;
  }
}

TEST(Octants, RandomFlights) {
  std::uint64_t external = 0, updates = 0;
  for (const int degree : {1, 2, 3}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(6u); ++seed) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", seed " + std::to_string(seed));
      const Scene scene = random_flights(seed, 8, 2, degree, seed % 2 == 0);
      const TwinRun run(scene, octants()), twin(scene, octants(), "sturm");
      EXPECT_EQ(run.sink.log.lines, twin.sink.log.lines);
      external += run.ledger().external;
      updates += run.ledger().motion_updates;
    }
  }
  EXPECT_GT(external, test::seen_in_fewer(100u));
  EXPECT_GT(updates, test::seen_in_fewer(20u));
}

// Equal points stand along (2, 1) by id: consecutive ones are next in an octant.
TEST(Octants, EqualPoints) {
  const Scene scene =
      scene_of({path({{1, 1}, {2}}), path({{1, 1}, {2}}), path({{1, 1}, {2}}), path({{7}, {2}})}, 0,
               Rational(20));
  const TwinRun run(scene, octants());
  EXPECT_EQ(run.begins_with, (Ids{0, 1, 1, 2, 2, 3}));
  EXPECT_EQ(run.attribute(), (Ids{0, 1, 0, 3, 1, 2}));
}

// Two points that pass through each other, in all directions at once; and many through one point.
TEST(Octants, PointsThatMeet) {
  for (const auto& [vx, vy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {-1, 3}}) {
    const TwinRun run(scene_of({path({{-2 * vx, vx}, {-2 * vy, vy}}),
                                path({{2 * vx, -vx}, {2 * vy, -vy}}), path({{1}, {5}})},
                               0, Rational(5)),
                      octants());
    EXPECT_GT(run.ledger().failures, 3u);
  }
  std::vector<Trajectory> t;
  for (int i = 0; i < 9; ++i) {
    const int vx = i % 3 - 1, vy = i / 3 - 1;
    t.push_back(path({{-3 * vx, vx}, {-3 * vy, vy}}));
  }
  const TwinRun run(scene_of(t, 0, Rational(6)), octants());
  EXPECT_EQ(run.begins_with.size(), run.attribute().size());
}

Integer remade(const Scene& scene, const std::string& structure) {
  const TwinRun run(scene, {ask(structure)});
  for (const BoundCheck& bound : run.simulator.bounds(0)) {
    EXPECT_TRUE(bound.holds) << bound.id;
    if (bound.id == structure + ".remade") return bound.observed;
  }
  return Integer(-1);
}

// Points that pass each other make no wood anew. Two that meet change their order in all four lists; one wood can follow
// the four swaps one by one, the other cannot. Without lists neither can. A new motion makes none.
TEST(Octants, WoodsMadeAnewAreCounted) {
  const Scene passing = random_flights(7, 12, 2, 1, false);
  const Trajectory still = path({{1}, {5}});
  const Scene meeting =
      scene_of({path({{-2, 1}, {-4, 2}}), path({{2, -1}, {4, -2}}), still}, 0, Rational(5));
  EXPECT_EQ(remade(passing, "octants_listed"), Integer(0));
  EXPECT_EQ(remade(meeting, "octants_listed"), Integer(1));
  EXPECT_EQ(remade(meeting, "octants_local"), Integer(2));
  Scene turning = meeting;
  turning.objects[2].motion.pieces = {{std::nullopt, Rational(4), still},
                                      {Rational(4), std::nullopt, path({{-3, 1}, {5}})}};
  EXPECT_EQ(remade(turning, "octants_listed"), Integer(1));
  EXPECT_EQ(remade(turning, "octants_local"), Integer(2));
}

// Before t = 1 the first point is level with the second one, and below it; from then on the two are equal,
// and in the order of their ids.
TEST(Octants, TwoPointsBecomeEqualByANewMotion) {
  const Trajectory first = path({{2, -1}, {2, 1}});
  Scene scene = scene_of({first, path({{2, -1}, {3}}), path({{1}, {5}})}, 0, Rational(2));
  scene.objects[1].motion.pieces[0].to = Rational(1);
  scene.objects[1].motion.pieces.push_back({Rational(1), std::nullopt, first});
  EXPECT_EQ(remade(scene, "octants_local"), Integer(2));
  const TwinRun run(scene, octants());
  const TwinRun cones(scene, {ask("cones_local")});
}

// Points of a lattice that come and go, and change their motions at multiples of 1/4: many are level, and
// many things happen at one instant.
TEST(Octants, PointsThatComeAndGoOnALattice) {
  for (std::uint64_t seed = 1; seed <= fewer(std::uint64_t{150}); ++seed) {
    SCOPED_TRACE(seed);
    const int n = 3 + static_cast<int>(seed % 9);
    const Scene scene = random_flights(seed, n, 2, 1 + static_cast<int>(seed % 2), true);
    const TwinRun run(scene, octants());
    if (seed % 3 == 0) const TwinRun cones(scene, {ask("cones_local")});
  }
}

// Points that stand still come and go: every pointer is right at once, so that no certificate fails.
TEST(Octants, NothingFailsWherePointsStandStill) {
  for (std::uint64_t seed = 1; seed <= fewer(std::uint64_t{60}); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Trajectory> t;
    for (std::uint64_t i = 0; i < 4 + seed % 12; ++i) t.push_back(random.small_path(2, 0, 4));
    Scene scene = scene_of(t, 0, Rational(9));
    for (SceneObject& object : scene.objects) {
      MotionPiece& piece = object.motion.pieces[0];
      const int from = random.between(0, 4);
      if (random.chance(50)) piece.from = Rational(from);
      if (random.chance(50)) piece.to = Rational(from + random.between(1, 4));
    }
    const TwinRun run(scene, octants());
    const TwinRun cones(scene, {ask("cones_local")});
    EXPECT_EQ(run.ledger(0).failures + run.ledger(1).failures + cones.ledger().failures, 0u);
  }
}

// A point in the middle of 40 others has more neighbours than are compared one by one.
TEST(Octants, APointOfManyNeighboursComesAndGoes) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 40; ++i) {
    const int x = i % 20 - 10, y = (i < 20 ? 1 : -1) * (100 - x * x);
    t.push_back(path({{x, i % 3 - 1}, {y, i % 2}}));
  }
  t.push_back(path({{Rational(Integer(1), Integer(3))}, {Rational(Integer(1), Integer(7))}}));
  for (const std::size_t one : {std::size_t{40}, std::size_t{7}}) {
    Scene scene = scene_of(t, 0, Rational(4));
    scene.objects[one].motion.pieces[0].from = Rational(1);
    scene.objects[one].motion.pieces[0].to = Rational(2);
    const TwinRun run(scene, octants());
    const TwinRun cones(scene, {ask("cones_local")});
  }
}

// Pairs of neighbours pass each other at t = 1, each along one axis. No wood is made anew for several of
// them, unless two share a point or are level with each other.
TEST(Octants, SeveralPairsAtOneInstant) {
  const auto along_x = [](int x, int y, int dx) {
    return std::pair(path({{x - dx, dx}, {y}}), path({{x}, {y + 2}}));
  };
  const auto along_y = [](int x, int y, int dy) {
    return std::pair(path({{x}, {y - dy, dy}}), path({{x + 2}, {y}}));
  };
  const auto scene = [](const std::vector<std::pair<Trajectory, Trajectory>>& pairs) {
    std::vector<Trajectory> t;
    for (const auto& [a, b] : pairs) {
      t.push_back(a);
      t.push_back(b);
    }
    return scene_of(t, 0, Rational(Integer(5), Integer(4)));
  };
  const auto pointers = [](const Scene& s) {
    return of_kind(TwinRun(s, octants()).ledger(), "point");
  };
  const Scene other_orders = scene({along_x(0, 0, 1), along_y(100, 37, 1), along_y(300, 1000, -1)});
  const Scene other_places = scene({along_x(0, 0, 1), along_x(100, 37, 1), along_x(300, 1000, -1)});
  const Scene level = scene({along_x(0, 0, 1), along_x(0, 1000, -1)});
  const Scene shared =
      scene_of({path({{-1, 1}, {0}}), path({{0}, {2}}), path({{1, -1}, {3}}), path({{40}, {90}})},
               0, Rational(Integer(5), Integer(4)));
  for (const Scene* one : {&other_orders, &other_places}) {
    EXPECT_GT(pointers(*one), 0u);
    EXPECT_EQ(remade(*one, "octants_local"), Integer(0));
  }
  for (const Scene* one : {&level, &shared}) {
    EXPECT_GT(pointers(*one), 0u);
    EXPECT_GT(remade(*one, "octants_local"), Integer(0));
  }
}

TEST(Octants, NoPointToThree) {
  for (int n = 0; n <= 3; ++n) {
    SCOPED_TRACE(n);
    std::vector<Trajectory> t;
    for (int i = 0; i < n; ++i) t.push_back(path({{4 * i, i == 1 ? -3 : 0}, {i * i, 1 - i}}));
    Scene scene = scene_of(t, 0, Rational(3));
    scene.dimension = 2;
    EXPECT_EQ(TwinRun(scene, octants()).attribute().empty(), n < 2);
  }
}

TEST(Octants, FromNothingToNothing) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 7; ++i) t.push_back(path({{(i * 3) % 7, i - 3}, {(i * 5) % 7, 1}}));
  Scene scene = scene_of(t, 0, Rational(20));
  for (int i = 0; i < 7; ++i) {
    auto& piece = scene.objects[static_cast<std::size_t>(i)].motion.pieces[0];
    piece.from = Rational(i + 1);
    piece.to = Rational(19 - 2 * ((i * 4) % 7));
  }
  const TwinRun run(scene, octants());
  EXPECT_EQ(run.begins_with, Ids{});
  EXPECT_EQ(run.attribute(), Ids{});
  EXPECT_EQ(run.ledger().insertions, 7u);
}

TEST(Octants, ExtremeNumbers) {
  for (const char* size : {"1e150", "1e400", "1e-400"}) {
    SCOPED_TRACE(size);
    const Rational unit = *Rational::parse(size);
    std::vector<Trajectory> t;
    for (int i = 0; i < 7; ++i) {
      t.push_back(path({{unit * Rational((i * 5) % 7), unit * Rational(3 - i)},
                        {unit * Rational((i * 3) % 7), unit * Rational((i * i) % 5)}}));
    }
    const TwinRun run(scene_of(t, 0, Rational(9)), octants());
    EXPECT_GT(run.ledger().external, 0u);
  }
}

TEST(Octants, EndInInexactArithmetics) {
  for (const char* arithmetic : {"double", "gsl", "mpfr:4", "mpfr:53"}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      const TwinRun flights(random_flights(seed, 9, 2, 1, seed % 2 == 0), octants(), arithmetic);
      const TwinRun lattice(lattice_scene(seed, 8, 2), octants(), arithmetic);
      EXPECT_GT(flights.ledger().failures, 0u);
    }
  }
}

// The pairs at the images of these times.
std::vector<Ids> pairs_at(const std::string& structure, const Image& image,
                          const std::vector<Rational>& times) {
  const Scene scene = TwinRun::asking(image.scene, {ask(structure)});
  std::vector<Rational> at;
  for (const Rational& t : times) at.push_back(image.new_time(t));
  if (image.reverses_time()) std::reverse(at.begin(), at.end());
  Simulator simulator(scene, planned_arithmetic("exact", scene), {});
  add_structures(simulator, scene);
  simulator.start();
  std::vector<Ids> result;
  for (const Rational& t : at) {
    simulator.run_until(t);
    result.push_back(simulator.structure(0).attribute().ids);
  }
  if (image.reverses_time()) std::reverse(result.begin(), result.end());
  return result;
}

// Time reversed, other units, a common motion: the same pairs.
TEST(Octants, TransformedScenes) {
  const Key key;
  for (const int degree : {1, 2}) {
    for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
      const Scene scene = random_flights(seed, 8, 2, degree, false);
      const Rational span = *scene.end - scene.start;
      std::vector<Rational> times;
      for (int i = 1; i < 23; ++i) {
        times.push_back(scene.start + span * Rational(Integer(97 * i + 5), Integer(97 * 23)));
      }
      const Image same{scene, key, 1, 0, false, {}, "the same"};
      for (const Request& request : octants()) {
        const auto pairs = pairs_at(request.structure, same, times);
        for (const Image& image :
             {in_time(scene, key, -1, 3), in_time(scene, key, Rational(Integer(2), Integer(3)), 1),
              scaled(scene, key, 7), carried(scene, key, path({{3, -50, 2}, {-1, 20, 1}}))}) {
          SCOPED_TRACE(request.structure + ", " + image.how);
          EXPECT_EQ(pairs_at(request.structure, image, times), pairs);
        }
      }
    }
  }
}

}  // namespace octants_test
}  // namespace kinex::test
