// SPDX-License-Identifier: GPL-3.0-or-later
// Separation witnesses: at random times the certificates in force name a direction in which one
// body lies wholly before the other. The checker is given the direction alone; it compares the
// support values of the two polygons at that time, in rationals.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "experiments/lab/workload.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace separation_witness_test {

using Vector = std::array<Rational, 2>;

Rational dot(const Vector& a, const Vertex2& b) { return a[0] * b[0] + a[1] * b[1]; }

// The checker: no vertex of `a` reaches beyond any of `b` in this direction.
bool separates(const Vector& direction, const formats::Polygon2& a, const formats::Polygon2& b) {
  Rational most = dot(direction, a[0]), least = dot(direction, b[0]);
  for (const Vertex2& v : a) most = std::max(most, dot(direction, v));
  for (const Vertex2& v : b) least = std::min(least, dot(direction, v));
  return most <= least && (!direction[0].is_zero() || !direction[1].is_zero());
}

const Trajectory& plan_at(const SceneObject& body, const Rational& t) {
  for (const MotionPiece& piece : body.motion.pieces) {
    if (!piece.to || t < *piece.to) return piece.trajectory;
  }
  return body.motion.pieces.back().trajectory;
}

// From the frame of a body to the world, up to a positive factor.
Vector turned(const Trajectory& plan, const Rational& t, const Vector& v) {
  const Rational p = plan.position(2, t), q = plan.position(3, t);
  const Rational c = p * p - q * q, s = Rational(2) * p * q;
  return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

// What the certificates of one pair name: directions, and vertices in the world.
struct Named {
  std::vector<Vector> directions;
  std::array<std::vector<Vertex2>, 2> vertices;
};

class Reader {
 public:
  Reader(const Scene& scene, Simulator& simulator, const Rational& t)
      : scene_(scene), simulator_(simulator), t_(t) {}

  std::map<std::pair<ObjectId, ObjectId>, Named> read() {
    const EventQueue& queue = simulator_.queue();
    for (CertificateId c = 0; c < queue.capacity(); ++c) {
      if (queue.certificate(c).live) look_at(queue.query(c));
    }
    return std::move(all_);
  }

 private:
  std::vector<Rational> numbers(ObjectId id) const {
    std::vector<Rational> result;
    for (const auto& axis : simulator_.kernel().derived().trajectory(id).coordinates) {
      result.push_back(axis[0]);
    }
    return result;
  }
  void look_at(const Query& query) {
    const DerivedObjects& derived = simulator_.kernel().derived();
    if (!derived.is_derived(query.ids[0])) return;  // cells, boxes and discs
    const std::string name(simulator_.arithmetic().predicate(query.predicate).name());
    if (name.rfind("side_", 0) != 0 && name.rfind("inside_", 0) != 0) return;
    const auto& bases = derived.object(query.ids[0]).bases;
    Named& named = all_[{bases[0], bases[1]}];
    const std::size_t z = name.back() == 'a' ? 0 : 1, w = 1 - z;
    const SceneObject &lined = scene_.objects[bases[z]], &other = scene_.objects[bases[w]];
    const std::vector<Rational> line = numbers(query.ids[1]), point = numbers(query.ids[2]);
    const Vector normal = turned(plan_at(lined, t_), t_, {line[0], line[1]});
    if (name[0] == 's') named.directions.push_back(normal);
    // A point of the second body is one of B' = -B.
    const Rational sign = w == 0 ? Rational(1) : Rational(-1);
    const Vertex2 there{sign * point[0] / point[2], sign * point[1] / point[2]};
    named.vertices[w].push_back(formats::placed_polygon({there}, plan_at(other, t_), t_)[0]);
  }
  const Scene& scene_;
  Simulator& simulator_;
  const Rational& t_;
  std::map<std::pair<ObjectId, ObjectId>, Named> all_;
};

// Some direction among them will do: that of a line, or between two vertices.
bool is_proved(const Named& named, const formats::Polygon2& a, const formats::Polygon2& b) {
  for (const Vector& direction : named.directions) {
    if (separates(direction, a, b)) return true;
  }
  for (const Vertex2& x : named.vertices[0]) {
    for (const Vertex2& y : named.vertices[1]) {
      if (separates({y[0] - x[0], y[1] - x[1]}, a, b)) return true;
    }
  }
  return false;
}

// The pairs that were proved apart, at `times` random instants of the run.
int check(const Scene& scene, const std::string& structure, int times, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<int> places;
  for (int i = 0; i < times; ++i) places.push_back(static_cast<int>(random() % 100000));
  std::sort(places.begin(), places.end());
  Trial trial(scene, structure, "exact", AuditLevel::kNone);
  trial.without_twin();
  const auto& pairs = dynamic_cast<const CollisionPairs&>(trial.simulator.structure(0));
  int proved = 0;
  for (const int place : places) {
    const Rational t = scene.start + (*scene.end - scene.start) * ratio(place, 100000);
    trial.run_until(t);
    for (const auto& [pair, named] : Reader(scene, trial.simulator, t).read()) {
      if (pairs.in_contact(pair.first, pair.second)) continue;
      const auto placed = [&](ObjectId id) {
        const SceneObject& body = scene.objects[id];
        return formats::placed_polygon(body.polygon, plan_at(body, t), t);
      };
      EXPECT_TRUE(is_proved(named, placed(pair.first), placed(pair.second)))
          << structure << " in " << scene.name << " at t = " << t.to_string() << ": "
          << scene.objects[pair.first].id << ", " << scene.objects[pair.second].id;
      ++proved;
    }
  }
  return proved;
}

TEST(SeparationWitness, CertificatesInForceAreCheckedBySupportValues) {
  struct Case {
    const char* family;
    int n, m;
    const char* separation;  // nullptr: the family's own
    bool turning;
  };
  int proved = 0;
  for (const Case& one : std::initializer_list<Case>{{"polygon-random", 9, 8, nullptr, true},
                                                     {"polygon-orbit", 24, 17, "1/50", false},
                                                     {"polygon-spin-orbit", 16, 9, "1/20", true},
                                                     {"polygon-gears", 12, 7, "1/100", true},
                                                     {"polygon-line", 32, 24, "1/1000", false},
                                                     {"polygon-kinks", 12, 8, nullptr, false},
                                                     {"polygon-fan", 8, 6, nullptr, true},
                                                     {"polygons-in-box", 7, 5, nullptr, true}}) {
    SCOPED_TRACE(one.family);
    for (std::uint64_t seed = 1; seed <= (kSanitized ? 1 : 3); ++seed) {
      lab::WorkloadParameters parameters;
      const lab::Workload& workload = *lab::find_workload(one.family);
      parameters.n = one.n;
      parameters.m = one.m;
      if (workload.random) parameters.seed = seed;
      if (one.separation != nullptr) parameters.separation = Rational::parse(one.separation);
      const Scene scene = lab::generate_scene(workload, parameters);
      for (const std::string& name : collision_structures(turns(scene))) {
        proved += check(scene, name, kSanitized ? 5 : 60, seed);
      }
      if (HasFailure()) return;
      if (!workload.random) break;
    }
  }
  EXPECT_GT(proved, kSanitized ? 80 : 3000);
}

// The checker refuses what does not separate.
TEST(SeparationWitness, TheCheckerLooksAtBothBodies) {
  const formats::Polygon2 a = square_of(1), b = box(2, 0, 3, 4);
  EXPECT_TRUE(separates({1, 0}, a, b));
  EXPECT_FALSE(separates({-1, 0}, a, b));
  EXPECT_FALSE(separates({0, 1}, a, b));
  EXPECT_FALSE(separates({0, 0}, a, b));
  EXPECT_TRUE(separates({1, 0}, a, box(1, -1, 2, 2)));  // they touch
}

}  // namespace separation_witness_test
}  // namespace kinex::test
