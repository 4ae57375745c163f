// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of bodies that are the same thing said otherwise: moved, turned, scaled, with vertices
// listed from elsewhere, bodies exchanged, time running backwards.
#include <gtest/gtest.h>

#include <algorithm>

#include "structures/collision/separation_mixed.h"
#include "tests/experiments/families/collision/collision_runs.h"
#include "tests/sanitized.h"

namespace kinex::test {
namespace collision_metamorphic_test {

using Axis = std::vector<Rational>;

Axis plus(const Axis& a, const Axis& b) {
  Axis sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
  return sum;
}
Axis times(const Rational& k, Axis a) {
  for (Rational& c : a) c *= k;
  return a;
}

// a(end - t)
Axis reversed(const Axis& a, const Rational& end) {
  Axis result;
  for (std::size_t i = a.size(); i-- > 0;) {
    Axis next(result.size() + 1);
    for (std::size_t k = 0; k < result.size(); ++k) {
      next[k] += end * result[k];
      next[k + 1] -= result[k];
    }
    next[0] += a[i];
    result = std::move(next);
  }
  return result;
}

template <class Change>
Scene changed(Scene scene, const Change& change) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& one : object.motion.pieces) {
      change(one.trajectory.coordinates, object.polygon);
      one.trajectory.normalise();
    }
  }
  return scene;
}

using Coordinates = std::vector<Axis>;

Scene moved(const Scene& scene) {
  return changed(scene, [](Coordinates& c, formats::Polygon2&) {
    c[0] = plus(c[0], {ratio(22, 7), 3, ratio(-1, 3)});
    c[1] = plus(c[1], {-1000, ratio(1, 5)});
  });
}

Scene scaled(const Scene& scene, const Rational& k) {
  return changed(scene, [&](Coordinates& c, formats::Polygon2& polygon) {
    c[0] = times(k, c[0]);
    c[1] = times(k, c[1]);
    for (Vertex2& v : polygon) v = {k * v[0], k * v[1]};
  });
}

// By the rotor 3 + 2i.
Scene turned(const Scene& scene) {
  const Rational cos = ratio(5, 13), sin = ratio(12, 13);
  return changed(scene, [&](Coordinates& c, formats::Polygon2&) {
    const Axis x = c[0], y = c[1], p = c[2], q = c[3];
    c[0] = plus(times(cos, x), times(-sin, y));
    c[1] = plus(times(sin, x), times(cos, y));
    c[2] = plus(times(3, p), times(-2, q));
    c[3] = plus(times(2, p), times(3, q));
  });
}

Scene relisted(const Scene& scene) {
  return changed(scene, [](Coordinates&, formats::Polygon2& polygon) {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  });
}

Scene exchanged(Scene scene) {
  std::swap(scene.objects[0], scene.objects[1]);
  return scene;
}

Scene backwards(const Scene& scene) {
  return changed(scene, [&](Coordinates& c, formats::Polygon2&) {
    for (Axis& axis : c) axis = reversed(axis, *scene.end);
  });
}

Scene random_scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&](int low, int high) {
    return ratio(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)), 16);
  };
  for (;;) {
    const formats::Polygon2 p = random_polygon(random, 10, 4), q = random_polygon(random, 10, 4);
    Scene scene =
        scene_of_bodies({body("a", p, {{0, draw(-9, 9)}, {0}, {1, draw(-9, 9)}, {0, draw(1, 30)}}),
                         body("b", q,
                              {{draw(120, 150), draw(-190, -60), draw(-9, 30)},
                               {draw(-60, 60), draw(-60, 60)},
                               {1, draw(-9, 9)},
                               {0, draw(-30, -1)}})},
                        0, Rational(3));
    const auto at = [&](int i, const Rational& t) {
      const SceneObject& object = scene.objects[static_cast<std::size_t>(i)];
      return formats::placed_polygon(object.polygon, object.motion.pieces[0].trajectory, t);
    };
    if (formats::contact_of(at(0, 0), at(1, 0)) == formats::Contact::kApart) return scene;
  }
}

struct Outcome {
  std::vector<std::string> kinds;  // of all events, without names
  std::vector<RealRoot> contacts;
};

Outcome outcome(const Scene& scene, const std::string& structure) {
  Trial trial(scene, structure);
  trial.without_twin().sink.recorder.instants = 100000;
  trial.to_end();
  trial.expect_clean();
  Outcome result;
  for (const Recorded& event : trial.sink.recorder.events) {
    result.kinds.push_back(std::to_string(event.kind));
    if (event.external && event.ids.size() == 4) result.contacts.push_back(instant_of(event));
  }
  return result;
}

void expect_same_contacts(Outcome a, Outcome b) {
  RootCounters counters;
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    EXPECT_EQ(compare(a.contacts[i], b.contacts[i], counters), 0);
  }
}

const int kRounds = kSanitized ? 3 : 15;

TEST(CollisionMetamorphic, PlaceSizeAndVertices) {
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    const Scene scene = random_scene(static_cast<std::uint64_t>(round));
    for (const std::string& name : collision_structures(true)) {
      SCOPED_TRACE(name);
      const Outcome plain = outcome(scene, name);
      const Outcome other = outcome(moved(scene), name);
      expect_same_contacts(plain, other);
      const Outcome list = outcome(relisted(scene), name);
      expect_same_contacts(plain, list);
      EXPECT_EQ(plain.kinds, list.kinds);
      const Outcome large = outcome(scaled(scene, *Rational::parse("4096")), name);
      expect_same_contacts(plain, large);
      EXPECT_EQ(plain.kinds, large.kinds);
      const Outcome tilted = outcome(turned(scene), name);
      expect_same_contacts(plain, tilted);
      // A is never turned in its own frame; squares about the bodies are not turned.
      if (name != "bounding_volumes" && name != "separation_hysteresis") {
        EXPECT_EQ(plain.kinds, other.kinds);
        EXPECT_EQ(plain.kinds, tilted.kinds);
      }
    }
    if (HasFailure()) return;
  }
}

// The other body's frame: the same contacts, and the same changes of what does not depend on it.
TEST(CollisionMetamorphic, BodiesExchanged) {
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    const Scene scene = random_scene(100 + static_cast<std::uint64_t>(round));
    for (const std::string& name : collision_structures(true)) {
      SCOPED_TRACE(name);
      const Outcome plain = outcome(scene, name), other = outcome(exchanged(scene), name);
      expect_same_contacts(plain, other);
      if (name == "closest_features" || name == "inner_tangents" || name == "bounding_volumes" ||
          name == "separation_hysteresis") {
        EXPECT_EQ(plain.kinds, other.kinds);
      }
    }
    if (HasFailure()) return;
  }
}

// The tiles that the point is in for a while, one after another. Half-planes are left out: they
// overlap, and the point stays in the one it is in. Tiles that it goes through at one instant are
// left out too: on the way out of a half-plane and into another the search looks at the tiles
// between them, which do not hold the point, and the way back does not leave that half-plane then.
class TileSink final : public EventSink {
 public:
  TileSink(const SeparationMixed& structure, const Scene& scene)
      : structure_(structure), trees_{tree_of(scene, 0), tree_of(scene, 1)} {}
  void event(const Event& event, Arithmetic& arithmetic) override {
    recorder_.events.clear();
    recorder_.instants = 1;
    recorder_.event(event, arithmetic);
    RealRoot now = instant_of(recorder_.events[0]);
    if (!since_ || compare(*since_, now, counters_) != 0) keep();
    since_ = std::move(now);
    look();
  }
  void look() {
    present_ = structure_.tile(0, 1);
    // Where a line touches its polygon in a vertex, several nodes are at one place: any of them may
    // name the triangle there.
    if (present_ && present_->kind == Tile::Kind::kTriangle) {
      const OuterHierarchy& tree = trees_[1 - present_->x];
      present_->other = tree.node(present_->other).point;
    }
  }
  void keep_at(const Rational& end) {
    if (!since_ || compare(*since_, end, counters_) != 0) keep();
  }
  // The present tile has held for a while.
  void keep() {
    if (!present_ || present_->kind == Tile::Kind::kHalf) return;
    if (tiles.empty() || !(tiles.back() == *present_)) tiles.push_back(*present_);
  }
  std::vector<Tile> tiles;

 private:
  static OuterHierarchy tree_of(const Scene& scene, std::size_t body) {
    return OuterHierarchy(frame_polygon(scene.objects[body].polygon, body == 1),
                          CutPolicy::kBalancedDudley);
  }
  const SeparationMixed& structure_;
  std::array<OuterHierarchy, 2> trees_;
  std::optional<Tile> present_;
  std::optional<RealRoot> since_;
  Recorder recorder_;
  RootCounters counters_;
};

std::vector<Tile> tiles_of(const Scene& scene) {
  Trial trial(scene, "separation_mixed");
  trial.without_twin();
  TileSink sink(proof_of<SeparationMixed>(trial.simulator.structure(0)), scene);
  sink.look();
  trial.simulator.set_sink(&sink);
  trial.to_end();
  trial.expect_clean();
  sink.keep_at(*scene.end);
  return sink.tiles;
}

// The events after the start and before the end. One at an end is seen only on the way to it: a
// proof that begins there holds right after it.
std::size_t changes_inside(const Scene& scene, const std::string& structure) {
  Trial trial(scene, structure);
  trial.without_twin().sink.recorder.instants = 100000;
  trial.to_end();
  trial.expect_clean();
  RootCounters counters;
  std::size_t count = 0;
  for (const Recorded& event : trial.sink.recorder.events) {
    RealRoot instant = instant_of(event);
    const bool at_end =
        compare(instant, scene.start, counters) == 0 || compare(instant, *scene.end, counters) == 0;
    count += at_end ? 0 : 1;
  }
  return count;
}

// Back through the same tiles, from end to start, and as many changes of features.
TEST(CollisionMetamorphic, TimeReversed) {
  std::size_t tiles = 0;
  int rounds = 0;
  for (std::uint64_t seed = 1000; rounds < (kSanitized ? 4 : 25); ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed);
    if (!outcome(scene, "closest_features").contacts.empty()) continue;
    ++rounds;
    const Scene back = backwards(scene);
    const std::vector<Tile> forth = tiles_of(scene);
    std::vector<Tile> return_way = tiles_of(back);
    std::reverse(return_way.begin(), return_way.end());
    EXPECT_EQ(forth.size(), return_way.size());
    EXPECT_TRUE(forth == return_way);
    tiles += forth.size();
    for (const char* name : {"closest_features", "inner_tangents"}) {
      EXPECT_EQ(changes_inside(scene, name), changes_inside(back, name)) << name;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(tiles, kSanitized ? 10u : 20u);
}

}  // namespace collision_metamorphic_test
}  // namespace kinex::test
