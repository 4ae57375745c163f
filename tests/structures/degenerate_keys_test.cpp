// SPDX-License-Identifier: GPL-3.0-or-later
// The one-dimensional structures with many events at one instant, or identical ties.
// Their answer right after each of many times, degenerate ones too, is compared with the order of
// the keys' Taylor coefficients at that time: exact, and without any code of the structures.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/sanitized.h"
#include "tests/structures/metamorphic.h"
#include "tests/structures/structure_names.h"
#include "tests/structures/test_run.h"
#include "tests/structures/test_scenes.h"

namespace kinex::test {
namespace degenerate_keys_test {

// All that keep an order by a key of any degree.
const std::vector<std::string> kStructures = structures_where([](const StructureInfo& info) {
  return info.uses_key && info.reads.empty() && !info.linear();
});

Rational fraction(int p, int q) { return Rational(Integer(p), Integer(q)); }

// The value of the key as a polynomial in t.
std::vector<Rational> key_polynomial(const Scene& scene, const Key& key, ObjectId object) {
  const auto axes = [&](ObjectId id) {
    return scene.objects[id].motion.pieces[0].trajectory.coordinates;
  };
  const std::vector<std::vector<Rational>> at = axes(object);
  if (key.kind == Key::Kind::kCoordinate) return at[static_cast<std::size_t>(key.axis)];
  std::vector<Rational> sum;
  const auto add = [&](std::size_t k, const Rational& c) {
    if (sum.size() <= k) sum.resize(k + 1);
    sum[k] += c;
  };
  for (std::size_t axis = 0; axis < at.size(); ++axis) {
    std::vector<Rational> c = at[axis];
    if (key.kind == Key::Kind::kDirection) {
      for (std::size_t k = 0; k < c.size(); ++k) add(k, key.direction[axis] * c[k]);
      continue;
    }
    const std::vector<Rational> from = axes(key.object)[axis];
    c.resize(std::max(c.size(), from.size()));
    for (std::size_t k = 0; k < from.size(); ++k) c[k] -= from[k];
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t k = 0; k < c.size(); ++k) add(i + k, c[i] * c[k]);
    }
  }
  return sum;
}

// The objects in the order of their keys right after t: -1 and +1 as the key of a is less or more.
class Order {
 public:
  Order(const Scene& scene, const Key& key, const Rational& t) {
    std::size_t most = 0;
    for (ObjectId i = 0; i < scene.objects.size(); ++i) {
      taylor_.push_back(composed(key_polynomial(scene, key, i), 1, t));
      most = std::max(most, taylor_.back().size());
      if (key.kind != Key::Kind::kSquaredDistance || key.object != i) ids_.push_back(i);
    }
    for (auto& c : taylor_) c.resize(most);
  }
  std::vector<ObjectId> answer(const std::string& structure) const {
    std::vector<ObjectId> ids = ids_;
    const bool greatest = structure.rfind("maximum", 0) == 0;
    std::stable_sort(ids.begin(), ids.end(), [&](ObjectId a, ObjectId b) {
      return greatest ? taylor_[b] < taylor_[a] : taylor_[a] < taylor_[b];
    });
    if (structure != "sorted_list") ids.resize(1);
    return ids;
  }

 private:
  std::vector<std::vector<Rational>> taylor_;
  std::vector<ObjectId> ids_;
};

std::vector<Key> keys(ObjectId reference) {
  Key x, y, along, distance;
  y.axis = 1;
  along.kind = Key::Kind::kDirection;
  along.direction = {1, -1};
  distance.kind = Key::Kind::kSquaredDistance;
  distance.object = reference;
  return {x, y, along, distance};
}

// Runs everything, audited after every event, and stops at all multiples of 1/parts. Returns the
// number of events.
std::uint64_t expect_right(const Scene& scene, int parts, ObjectId reference = 0) {
  std::uint64_t events = 0;
  for (const std::string& structure : kStructures) {
    for (const Key& key : keys(reference)) {
      SCOPED_TRACE(std::string(structure) + ", key " + std::to_string(static_cast<int>(key.kind)));
      Trial run(scene, structure, "exact", AuditLevel::kEvents, key);
      for (Rational t = scene.start; t <= *scene.end; t += fraction(1, parts)) {
        run.run_until(t);
        EXPECT_EQ(run.ids(), Order(scene, key, t).answer(structure)) << "at " << t.to_string();
      }
      run.to_end().expect_clean();
      events += run.ledger().processed;
    }
  }
  return events;
}

// A rotation by twice the arctangent of t, times 1 + t^2.
Trajectory rotating(int a, int b) { return path({{a, -2 * b, -a}, {b, 2 * a, -b}}); }
constexpr int kCircle[][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                              {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};

TEST(DegenerateKeys, GridsWithIntegerVelocities) {
  std::uint64_t events = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(4u); ++seed) {
    Random random(seed);
    std::vector<Trajectory> paths;
    for (int i = 0; i < 16; ++i) {
      paths.push_back(path({{i % 4, random.between(-2, 2)}, {i / 4, random.between(-2, 2)}}));
    }
    events += expect_right(scene_of(paths, 0, Rational(4)), 2, 5);
  }
  EXPECT_GT(events, test::seen_in_fewer(1000u));
}

TEST(DegenerateKeys, CocircularPointsThatExpand) {
  std::vector<Trajectory> paths{path({{0}, {0}})};
  for (const auto& [a, b] : kCircle) paths.push_back(path({{a, a}, {b, b}}));
  // Identical distances from the centre; in the other keys the order is constant.
  EXPECT_EQ(expect_right(scene_of(paths, 0, Rational(3)), 1), 0u);
  // Around a centre that moves.
  paths[0] = path({{-7, 5}, {1}});
  EXPECT_GT(expect_right(scene_of(paths, 0, Rational(3)), 2), 0u);
}

TEST(DegenerateKeys, PointsThatRotateRigidly) {
  std::vector<Trajectory> paths{path({{0}, {0}})};
  for (const auto& [a, b] : kCircle) paths.push_back(rotating(a, b));
  const Scene scene = scene_of(paths, -3, Rational(3));
  EXPECT_GT(expect_right(scene, 2), 200u);
  for (const std::string& structure : kStructures) {
    Trial run(scene, structure, "exact", AuditLevel::kEvents, keys(0)[3]);
    run.to_end().expect_clean();
    EXPECT_EQ(run.ledger().processed, 0u);
    EXPECT_EQ(run.ids().front(), 1u);
  }
}

TEST(DegenerateKeys, AllMeetAtOneInstant) {
  for (const int degree : {1, 2, 3}) {
    Random random(static_cast<std::uint64_t>(degree));
    std::vector<Trajectory> paths;
    for (int i = 0; i < 10; ++i) {
      Trajectory p = random.small_path(2, degree, 3);
      for (auto& axis : p.coordinates) {
        axis.resize(static_cast<std::size_t>(degree + 1));
        axis[0] = 1;
        if (i % 3 == 2 && degree > 1) axis[1] = 0;  // touches and turns back, or passes slowly
        axis = composed(axis, 1, fraction(-1, 2));
      }
      paths.push_back(std::move(p));
    }
    EXPECT_GT(expect_right(scene_of(paths, -1, Rational(2)), 4), 50u);
  }
}

TEST(DegenerateKeys, DuplicatesThatMoveTogether) {
  for (const int degree : {1, 2, 3}) {
    Random random(static_cast<std::uint64_t>(20 + degree));
    std::vector<Trajectory> paths;
    for (int i = 0; i < 12; ++i) {
      paths.push_back(i < 5 ? random.small_path(2, degree, 3)
                            : paths[static_cast<std::size_t>(random.between(0, 4))]);
    }
    EXPECT_GT(expect_right(scene_of(paths, -2, Rational(2)), 3, 2), 30u);
  }
}

TEST(DegenerateKeys, TouchingAndTurningBackIsNoEvent) {
  // (t - s)^2 w + i: neighbours touch at s and part again, in x and y.
  std::vector<Trajectory> paths{path({{-3}, {-3}})};
  for (int i = 0; i < 6; ++i) {
    const int s = i % 3, w = i % 2 == 0 ? 1 : -1;
    paths.push_back(
        path({{2 * (i / 2) + s * s * w, -2 * s * w, w}, {2 * (i / 2) + s * s * w, -2 * s * w, w}}));
  }
  expect_right(scene_of(paths, -1, Rational(4)), 2);
  // Only touches: a parabola on each line.
  std::vector<Trajectory> touch;
  for (int i = 0; i < 5; ++i) {
    const int h = 40 * i;
    touch.push_back(path({{h}, {h}}));
    touch.push_back(path({{h + i * i, -2 * i, 1}, {h + i * i, -2 * i, 1}}));
  }
  const Scene scene = scene_of(touch, fraction(-1, 2), fraction(9, 2));
  Trial run(scene, "sorted_list");
  run.to_end().expect_clean();
  EXPECT_EQ(run.ledger().processed, 0u);
}

TEST(DegenerateKeys, DegenerateInEveryWayAtTheStart) {
  for (int shape = 0; shape < 4; ++shape) {
    Random random(static_cast<std::uint64_t>(30 + shape));
    std::vector<Trajectory> paths;
    for (int i = 0; i < 12; ++i) {
      Trajectory p = random.small_path(2, 1 + i % 3, 2);
      const int x = shape == 0 ? 0 : shape == 1 ? i % 3 : shape == 2 ? i / 6 : kCircle[i][0];
      const int y = shape == 0 ? 0 : shape == 1 ? i % 3 : shape == 2 ? i % 2 : kCircle[i][1];
      p.coordinates[0][0] = x;
      p.coordinates[1][0] = y;
      if (i % 5 == 4) p = paths.back();
      paths.push_back(std::move(p));
    }
    expect_right(scene_of(paths, 0, Rational(2)), 2, 7);
  }
}

TEST(DegenerateKeys, LargeAndSmallNumbersTogether) {
  const Rational large = *Rational::parse("1e150"), small = *Rational::parse("1e-150");
  std::uint64_t events = 0;
  for (const int degree : {1, 2, 3}) {
    if (kSanitized && degree > 1) continue;
    Random random(static_cast<std::uint64_t>(50 + degree));
    std::vector<Trajectory> paths;
    for (int i = 0; i < (degree == 3 ? 5 : 10); ++i) {
      Trajectory p = random.small_path(2, degree, 9);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t k = 0; k < p.coordinates[axis].size(); ++k) {
          // Large and small objects, axes and coefficients, in all combinations.
          const std::size_t bits = static_cast<std::size_t>(i);
          const bool big = ((bits >> (axis + 2 * (k % 2))) & 1) != 0;
          p.coordinates[axis][k] *= big ? large : small;
        }
      }
      paths.push_back(std::move(p));
    }
    events += expect_right(scene_of(paths, -2, Rational(2)), 1, 4);
  }
  EXPECT_GT(events, kSanitized ? 10u : 50u);
}

}  // namespace degenerate_keys_test
}  // namespace kinex::test
