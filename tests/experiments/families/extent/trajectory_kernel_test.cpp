// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/extent/trajectory_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "predicates/points/unit_directions.h"
#include "structures/plan.h"
#include "tests/structures/test_scenes.h"

namespace kinex::families {
namespace trajectory_kernel_test {

using test::path;
using test::Random;
using test::scene_of;

Rational squared_diameter(const Scene& scene, const std::vector<ObjectId>& objects,
                          const Rational& t) {
  Rational best;
  for (const ObjectId a : objects) {
    for (const ObjectId b : objects) {
      Rational sum;
      for (int axis = 0; axis < 2; ++axis) {
        const Rational d = scene.objects[b].motion.pieces[0].trajectory.position(axis, t) -
                           scene.objects[a].motion.pieces[0].trajectory.position(axis, t);
        sum += d * d;
      }
      best = std::max(best, sum);
    }
  }
  return best;
}

std::vector<ObjectId> all_of(const Scene& scene) {
  std::vector<ObjectId> all;
  for (ObjectId id = 0; id < scene.objects.size(); ++id) all.push_back(id);
  return all;
}

// At times near and far, before and after the start.
void expect_guarantee(const Scene& scene, const Rational& error, std::size_t most) {
  ASSERT_EQ(kernel_refusal(scene), "");
  const TrajectoryKernel kernel = trajectory_kernel(scene, error);
  EXPECT_LE(kernel.objects.size(), most);
  EXPECT_TRUE(std::is_sorted(kernel.objects.begin(), kernel.objects.end()));
  const Rational least = (Rational(1) - error) * (Rational(1) - error);
  for (int i = -40; i <= 40; i += 5) {
    const Rational t = Rational(i * i * i) / Rational(i % 2 == 0 ? 640 : 641);
    const Rational all = squared_diameter(scene, all_of(scene), t);
    EXPECT_GE(squared_diameter(scene, kernel.objects, t), least * all) << t.to_string();
  }
}

Scene random_lines(std::uint64_t seed, int n, int size) {
  Random random(seed);
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(random.small_path(2, 1, size));
  return scene_of(t, 0, Rational(9));
}

TEST(TrajectoryKernel, HasTheDiameterAtAllTimes) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const char* error : {"1/2", "1/10", "1/50", "9/10"}) {
      SCOPED_TRACE(std::string(error) + ", seed " + std::to_string(seed));
      expect_guarantee(random_lines(seed, 30, 1000), *Rational::parse(error), 30);
      expect_guarantee(random_lines(seed, 12, 2), *Rational::parse(error), 12);
    }
  }
}

// On a circle all are needed for the exact diameter, in every direction of motion, too.
TEST(TrajectoryKernel, LeavesFewPointsOfACircle) {
  std::vector<Trajectory> t;
  for (int i = 0; i < 100; ++i) {
    const Rational q = Rational(i - 50) / Rational(25);
    const Rational all = Rational(1) + q * q;
    const Rational x = (Rational(1) - q * q) / all, y = Rational(2) * q / all;
    t.push_back(path({{x, y}, {y, x}}));
  }
  const Scene scene = scene_of(t, 0, Rational(1));
  expect_guarantee(scene, Rational(1) / Rational(2), 30);
  expect_guarantee(scene, Rational(1) / Rational(10), 80);
  EXPECT_LT(trajectory_kernel(scene, Rational(1) / Rational(2)).objects.size(),
            trajectory_kernel(scene, Rational(1) / Rational(50)).objects.size());
}

TEST(TrajectoryKernel, DegenerateScenes) {
  const Rational error = Rational(1) / Rational(10);
  // No point, one, all equal, all at rest, identically on a line, all through one point.
  Scene none = scene_of({}, 0, Rational(1));
  none.dimension = 2;
  EXPECT_EQ(trajectory_kernel(none, error).objects.size(), 0u);
  expect_guarantee(scene_of({path({{3, 1}, {0}})}, 0, Rational(1)), error, 1);
  expect_guarantee(scene_of(std::vector<Trajectory>(6, path({{3, 1}, {2}})), 0, Rational(1)), error,
                   1);
  std::vector<Trajectory> rest, line, pencil;
  for (int i = 0; i < 9; ++i) {
    rest.push_back(path({{(i * 4) % 9}, {(i * 7) % 9}}));
    line.push_back(path({{i, i}, {2 * i, 2 * i}}));
    pencil.push_back(path({{0, i - 4}, {0, (i * 5) % 9 - 4}}));
  }
  expect_guarantee(scene_of(rest, 0, Rational(1)), error, 9);
  expect_guarantee(scene_of(line, 0, Rational(1)), error, 2);
  expect_guarantee(scene_of(pencil, 0, Rational(1)), error, 9);
}

TEST(TrajectoryKernel, RefusesOtherScenes) {
  EXPECT_NE(kernel_refusal(scene_of({path({{0}})}, 0, Rational(1))), "");
  EXPECT_NE(kernel_refusal(scene_of({path({{0, 1, 1}, {0}})}, 0, Rational(1))), "");
  EXPECT_NE(kernel_refusal(test::random_flights(1, 9, 2, 1, true)), "");
}

// ---- structures on the kernel and on all points

using Measure =
    std::function<Rational(const Scene&, const std::vector<ObjectId>&, const Rational&)>;

Rational at(const Scene& scene, ObjectId object, int axis, const Rational& t) {
  return scene.objects[object].motion.pieces[0].trajectory.position(axis, t);
}

// The largest squared extent of the objects along 2k directions.
Rational squared_extent(const Scene& scene, const std::vector<ObjectId>& objects, int k,
                        const Rational& t) {
  Rational best;
  for (const DirectionVector& u : unit_directions_2(k)) {
    std::vector<Rational> places;
    for (const ObjectId object : objects) {
      places.push_back(u[0] * at(scene, object, 0, t) + u[1] * at(scene, object, 1, t));
    }
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    if (low != high) best = std::max(best, (*high - *low) * (*high - *low));
  }
  return best;
}

// Of two points the circle on them, of more the circumcircle of three that are not on one line.
Rational squared_radius(const Scene& scene, const std::vector<ObjectId>& ids, const Rational& t) {
  const auto difference = [&](ObjectId a, ObjectId b, int axis) {
    return at(scene, b, axis, t) - at(scene, a, axis, t);
  };
  const auto square = [&](ObjectId a, ObjectId b) {
    const Rational x = difference(a, b, 0), y = difference(a, b, 1);
    return x * x + y * y;
  };
  if (ids.size() < 2) return Rational(0);
  if (ids.size() == 2) return square(ids[0], ids[1]) / Rational(4);
  for (std::size_t i = 2; i < ids.size(); ++i) {
    const ObjectId a = ids[0], b = ids[1], c = ids[i];
    const Rational twice =
        difference(a, b, 0) * difference(a, c, 1) - difference(a, b, 1) * difference(a, c, 0);
    if (twice.is_zero()) continue;
    return square(a, b) * square(b, c) * square(c, a) / (Rational(4) * twice * twice);
  }
  return square(ids[0], ids[1]) / Rational(4);
}

// A run of one structure, and the measure of its attribute at each of the times, right after them.
std::vector<Rational> measures(Scene scene, const Request& request, const Measure& measure,
                               const std::vector<Rational>& times) {
  scene.maintain = {request};
  SimulatorOptions options;
  options.audit = AuditLevel::kEnd;
  Simulator simulator(scene, planned_arithmetic("exact", scene), options);
  add_structures(simulator, scene);
  simulator.start();
  const Structure& structure = simulator.structure(asked_structure(scene));
  std::vector<Rational> result;
  for (const Rational& t : times) {
    EXPECT_EQ(simulator.run_until(t), RunStatus::kDone);
    result.push_back(measure(scene, structure.attribute().ids, t));
  }
  EXPECT_EQ(simulator.violations(), std::vector<std::string>{});
  return result;
}

// What the choice proves of the kernel for e = error, at all times: the diameter, at least 1 - e of that of
// all; extents along the 2k directions and the sides of the box, at least 1 - e/2; by Jung's theorem,
// D/2 <= R <= D / sqrt 3, the radius of the smallest circle, at least (1 - e) sqrt 3 / 2.
void expect_errors(const Scene& scene, const Rational& error) {
  const TrajectoryKernel kernel = trajectory_kernel(scene, error);
  const Scene thin = kKernelThinning.thin(scene, error).scene;
  ASSERT_EQ(thin.objects.size(), kernel.objects.size());
  std::vector<Rational> times;
  for (int i = 0; i <= 120; ++i) {
    times.push_back(scene.start + (*scene.end - scene.start) * Rational(i) / Rational(120));
  }
  const Rational whole = (Rational(1) - error) * (Rational(1) - error);
  const Rational half = (Rational(1) - error / Rational(2)) * (Rational(1) - error / Rational(2));
  const auto side = [](std::size_t axis) -> Measure {
    return [axis](const Scene& in, const std::vector<ObjectId>& ids, const Rational& t) {
      const int number = static_cast<int>(axis);
      const Rational d = at(in, ids[2 * axis + 1], number, t) - at(in, ids[2 * axis], number, t);
      return d * d;
    };
  };
  const auto expect_at_least = [&](const Request& request, const Measure& measure,
                                   const Rational& share) {
    SCOPED_TRACE(request.structure);
    const std::vector<Rational> all = measures(scene, request, measure, times);
    const std::vector<Rational> some = measures(thin, request, measure, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_GE(some[i], share * all[i]) << times[i].to_string();
      EXPECT_LE(some[i], all[i]) << times[i].to_string();
    }
  };
  for (const char* structure : {"diameter_2", "diameter_all_pairs"}) {
    expect_at_least({structure, structure, {}}, squared_diameter, whole);
  }
  Request along{"diameter_directions", "along", {}};
  along.parameters = {{"k", Rational(kernel.k)}};
  expect_at_least(
      along,
      [k = kernel.k](const Scene& in, const std::vector<ObjectId>& ids, const Rational& t) {
        return squared_extent(in, ids, k, t);
      },
      half);
  for (const std::size_t axis : {0, 1}) {
    expect_at_least({"bounding_box", "box", {}}, side(axis), half);
  }
  expect_at_least({"min_circle_2", "circle", {}}, squared_radius,
                  whole * Rational(3) / Rational(4));
}

TEST(TrajectoryKernel, StructuresOnItAreWithinTheError) {
  for (const char* error : {"1/2", "1/10", "1/50"}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(std::string(error) + ", seed " + std::to_string(seed));
      const Rational e = *Rational::parse(error);
      expect_errors(random_lines(seed, 24, 1000), e);
      expect_errors(random_lines(seed + 10, 9, 2), e);
    }
  }
}

TEST(TrajectoryKernel, KeepsWhatKeysReferTo) {
  Scene scene = random_lines(3, 20, 9);
  Key key;
  key.kind = Key::Kind::kSquaredDistance;
  key.object = 7;
  scene.maintain = {{"maximum_tournament", "far", key}};
  const Scene thin = only_objects(scene, {2, 11, 12});
  ASSERT_EQ(thin.objects.size(), 4u);
  EXPECT_EQ(thin.objects[1].id, scene.objects[7].id);
  EXPECT_EQ(thin.maintain[0].key.object, 1u);
}

TEST(TrajectoryKernel, KeepsWhatSubsetsName) {
  Scene scene = random_lines(3, 20, 9);
  Request some{"diameter_2", "some", {}}, others{"diameter_2", "others", {}};
  some.of = {Subset::Kind::kObjects, {3, 11, 17}};
  others.of = {Subset::Kind::kAllBut, {5}};
  scene.maintain = {some, others};
  const Scene thin = only_objects(scene, {2, 11, 12});
  std::vector<std::string> ids, expected;
  for (const SceneObject& object : thin.objects) ids.push_back(object.id);
  for (const std::size_t kept : {2, 3, 5, 11, 12, 17}) expected.push_back(scene.objects[kept].id);
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(thin.maintain[0].of.objects, (std::vector<ObjectId>{1, 3, 5}));
  EXPECT_EQ(thin.maintain[1].of.objects, std::vector<ObjectId>{2});
}

}  // namespace trajectory_kernel_test
}  // namespace kinex::families
