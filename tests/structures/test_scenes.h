// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes for the tests of structures: workloads with provable event counts, and random ones.
#ifndef KINEX_TESTS_STRUCTURES_TEST_SCENES_H
#define KINEX_TESTS_STRUCTURES_TEST_SCENES_H

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "structures/parts/descriptor.h"

namespace kinex::test {

// One axis per list, low degree first.
inline Trajectory path(std::vector<std::vector<Rational>> coordinates) {
  Trajectory result{std::move(coordinates)};
  result.normalise();
  return result;
}

inline SceneObject moving(std::string id, Trajectory trajectory) {
  return {std::move(id), {{{std::nullopt, std::nullopt, std::move(trajectory)}}}};
}

inline std::string name_of(std::size_t i) { return std::string("o").append(std::to_string(i)); }

inline Scene scene_of(const std::vector<Trajectory>& trajectories, Rational start,
                      std::optional<Rational> end) {
  Scene scene;
  scene.name = "test";
  scene.dimension = trajectories.empty() ? 1 : trajectories[0].dimension();
  scene.start = std::move(start);
  scene.end = std::move(end);
  for (std::size_t i = 0; i < trajectories.size(); ++i) {
    scene.objects.push_back(moving(name_of(i), trajectories[i]));
  }
  return scene;
}

// f_j(t) = j t - (2n)^j: all n(n-1)/2 pairs cross after 0, at distinct times; a max-heap in this
// order has the largest possible number of events: the sum over j of floor(log2(j + 1)).
inline Scene steep_lines(int n) {
  std::vector<Trajectory> t;
  Integer p(1);
  for (int j = 0; j < n; ++j, p = p * Integer(2 * n))
    t.push_back(path({{Rational(-p), Rational(j)}}));
  return scene_of(t, 0, std::nullopt);
}

// f_i(t) = i t - 2^i for i < 2^k in bit-reversed order: a tournament in this order has the largest
// possible number of events, n k - n + 1.
inline Scene bit_reversed_lines(int k) {
  std::vector<Trajectory> t;
  for (int place = 0; place < 1 << k; ++place) {
    int i = 0;
    for (int bit = 0; bit < k; ++bit) i |= ((place >> bit) & 1) << (k - 1 - bit);
    t.push_back(
        path({{Rational(-Integer::power_of_two(static_cast<unsigned long>(i))), Rational(i)}}));
  }
  return scene_of(t, 0, std::nullopt);
}

// x_i(t) = i q(t) + 2^(i - 2n - 8) with q = (t - 1)(t - 2)...(t - d): every pair crosses d times,
// at distinct times.
inline Scene weaving_curves(int n, int d) {
  std::vector<Rational> q{1};
  for (int root = 1; root <= d; ++root) {
    std::vector<Rational> next(q.size() + 1);
    for (std::size_t k = 0; k < q.size(); ++k) {
      next[k + 1] += q[k];
      next[k] -= q[k] * Rational(root);
    }
    q = std::move(next);
  }
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) {
    std::vector<Rational> c;
    for (const Rational& k : q) c.push_back(k * Rational(i));
    c[0] += Rational(Integer(1), Integer::power_of_two(static_cast<unsigned long>(2 * n + 8 - i)));
    t.push_back(path({c}));
  }
  return scene_of(t, 0, Rational(d + 1));
}

// n lines through one point at t = 0, before and after it in opposite orders.
inline Scene pencil(int n) {
  std::vector<Trajectory> t;
  for (int i = 0; i < n; ++i) t.push_back(path({{0, (7 * i) % n}}));
  return scene_of(t, -1, Rational(1));
}

// The engine is specified bit by bit; so is this.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // Uniform in lo .. hi (to within 2^-32).
  int between(int lo, int hi) {
    return lo + static_cast<int>(engine_() % static_cast<std::uint64_t>(hi - lo + 1));
  }
  bool chance(int percent) { return between(0, 99) < percent; }
  // Small integers: ties, meetings of many and equal motions are frequent.
  Trajectory small_path(int dimension, int degree, int size) {
    std::vector<std::vector<Rational>> c(static_cast<std::size_t>(dimension));
    for (auto& axis : c) {
      for (int k = 0; k <= degree; ++k) axis.emplace_back(between(-size, size));
    }
    return path(std::move(c));
  }

 private:
  std::mt19937_64 engine_;
};

// `next`, shifted so that it starts where `before` is at t.
inline Trajectory continued(const Trajectory& before, Trajectory next, const Rational& t) {
  for (int axis = 0; axis < next.dimension(); ++axis) {
    const Rational gap = before.position(axis, t) - next.position(axis, t);
    next.coordinates[static_cast<std::size_t>(axis)][0] += gap;
  }
  next.normalise();
  return next;
}

// The instants of flight plans: multiples of 1/4, of which many are shared, or, of each object, multiples
// of 1/7, of 1/11 or of 1/13, of which few are.
enum class PlanInstants { kQuarters, kOddParts };

// Objects on one scene's time 0 .. 4 with random flight plans: pieces that join, lives that begin
// late and end early, and pairs with equal motions.
inline Scene random_flights(std::uint64_t seed, int n, int dimension, int degree, bool lives,
                            PlanInstants instants = PlanInstants::kQuarters) {
  constexpr std::array<int, 3> kParts{7, 11, 13};
  Random random(seed);
  Scene scene;
  scene.name = "flights";
  scene.dimension = dimension;
  scene.start = 0;
  scene.end = Rational(4);
  for (int i = 0; i < n; ++i) {
    std::vector<Rational> cuts;
    const int parts = instants == PlanInstants::kQuarters
                          ? 4
                          : kParts[static_cast<std::size_t>(random.between(0, 2))];
    const auto instant = [parts](int k) { return Rational(Integer(k), Integer(parts)); };
    const int pieces = random.between(1, 3), last = 4 * parts;
    int at = lives && random.chance(30) ? random.between(1, 2 * parts) : 0;
    const int stop = lives && random.chance(30) ? random.between(at + 1, last) : last;
    cuts.push_back(instant(at));
    for (int p = 1; p < pieces; ++p) {
      at = random.between(at, stop);
      if (instant(at) > cuts.back() && at < stop) cuts.push_back(instant(at));
    }
    SceneObject object;
    object.id = name_of(static_cast<std::size_t>(i));
    for (std::size_t p = 0; p < cuts.size(); ++p) {
      Trajectory t = random.small_path(dimension, random.between(0, degree), 2);
      if (p == 0 && i > 0 && random.chance(25)) {
        t = scene.objects[static_cast<std::size_t>(random.between(0, i - 1))]
                .motion.pieces[0]
                .trajectory;
      }
      if (p > 0) t = continued(object.motion.pieces.back().trajectory, t, cuts[p]);
      const Rational to = p + 1 < cuts.size() ? cuts[p + 1] : instant(stop);
      object.motion.pieces.push_back({cuts[p], to, t});
    }
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

// Makes the points of a scene discs or boxes with small constant extents, some of them 0, or gives them
// such weights.
inline void with_extents(Scene& scene, Extents extents) {
  if (scene.extents != Extents::kNone) return;
  scene.extents = extents;
  int k = 0;
  for (SceneObject& object : scene.objects) {
    for (int axis = 0; axis < scene.extent_axes(); ++axis) {
      k = (5 * k + 3) % 8;
      const Rational half(Integer(k), Integer(4));
      for (MotionPiece& piece : object.motion.pieces) piece.trajectory.coordinates.push_back({half});
    }
  }
}

// Makes the points of a scene lines: all of them, or every second one.
inline void with_lines(Scene& scene, LineUse lines) {
  if (lines == LineUse::kNone || scene.dimension != 2 || scene.has_lines()) return;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].line = lines == LineUse::kAlone || i % 2 == 0;
  }
}

// The scene in a form that the structure takes: for structures of space with a third axis, on which
// nothing moves; for structures of graphs its first axis alone, and the points as edges, the k-th
// between the k-th pair of vertices in the order 01, 02, 12, 03, ..; for structures of discs and
// boxes with small constant extents, for those that read weights with such weights; for structures of
// lines with lines.
inline Scene suited(Scene scene, const StructureInfo& info) {
  if (scene.dimension < info.min_dimension && info.min_dimension == 3) {
    scene.dimension = 3;
    int k = 0;
    for (SceneObject& object : scene.objects) {
      const Rational height((7 * k + 3) * k % 5);
      ++k;
      for (MotionPiece& piece : object.motion.pieces) {
        piece.trajectory.coordinates.resize(3, std::vector<Rational>{height});
      }
    }
  }
  if (info.usual_extents() != Extents::kNone) with_extents(scene, info.usual_extents());
  with_lines(scene, info.lines);
  if (!info.graph) return scene;
  scene.dimension = 1;
  int u = 0, v = 1;
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) piece.trajectory.coordinates.resize(1);
    object.ends = {std::to_string(u), std::to_string(v)};
    if (++u == v) {
      u = 0;
      ++v;
    }
  }
  return scene;
}

}  // namespace kinex::test

#endif
