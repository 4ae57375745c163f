// SPDX-License-Identifier: GPL-3.0-or-later
// Metamorphic tests: transformations of scenes. The run of a transformed scene must have the events
// of the old one, at the transformed instants and with the renamed objects.
#ifndef KINEX_TESTS_STRUCTURES_METAMORPHIC_H
#define KINEX_TESTS_STRUCTURES_METAMORPHIC_H

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/scene.h"
#include "core/numbers/real_root.h"
#include "tests/structures/recorder.h"

namespace kinex::test {

// A transformed scene, and the map from its runs to those of the old scene: time s of the new scene
// is t = a s + b of the old one.
struct Image {
  Scene scene;
  Key key;
  Rational a = 1, b = 0;
  bool reverses_order = false;  // the smallest key becomes the largest
  std::vector<ObjectId> name;   // the old id of each new id; empty: unchanged
  std::string how;              // for messages

  bool reverses_time() const { return a < Rational(0); }
  ObjectId old_id(ObjectId id) const { return name.empty() ? id : name[id]; }
  Rational new_time(const Rational& t) const { return (t - b) / a; }
};

// ---- polynomials in t

// The coefficients of c(p t + q), low degree first.
inline std::vector<Rational> composed(const std::vector<Rational>& c, const Rational& p,
                                      const Rational& q) {
  std::vector<Rational> result;
  for (std::size_t k = c.size(); k-- > 0;) {  // Horner
    std::vector<Rational> next(result.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i] += result[i] * q;
      next[i + 1] += result[i] * p;
    }
    next[0] += c[k];
    result = std::move(next);
  }
  while (result.size() > 1 && result.back().is_zero()) result.pop_back();
  return result;
}

// ---- transformations

template <class Change>
void change_paths(Scene& scene, const Change& change) {
  for (SceneObject& object : scene.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      change(piece.trajectory);
      piece.trajectory.normalise();
    }
  }
}

// The scene in other units of time; time runs backwards if a < 0.
inline Image in_time(const Scene& scene, const Key& key, const Rational& a, const Rational& b) {
  Image image{scene, key, a, b, false, {}, "t = " + a.to_string() + " s + " + b.to_string()};
  Scene& to = image.scene;
  change_paths(to, [&](Trajectory& path) {
    for (auto& axis : path.coordinates) axis = composed(axis, a, b);
  });
  const auto moved = [&](const std::optional<Rational>& t) {
    return t ? std::optional<Rational>(image.new_time(*t)) : std::nullopt;
  };
  to.start = *moved(scene.start);
  to.end = moved(scene.end);
  for (SceneObject& object : to.objects) {
    for (MotionPiece& piece : object.motion.pieces) {
      piece.from = moved(piece.from);
      piece.to = moved(piece.to);
      if (image.reverses_time()) std::swap(piece.from, piece.to);
    }
    if (image.reverses_time()) {
      std::reverse(object.motion.pieces.begin(), object.motion.pieces.end());
    }
  }
  if (image.reverses_time()) {
    to.end = to.start;
    to.start = *moved(scene.end);
  }
  return image;
}

// One axis negated, and the key's direction with it.
inline Image mirrored(const Scene& scene, const Key& key, int axis) {
  Image image{scene, key, 1, 0, false, {}, "axis " + std::to_string(axis) + " mirrored"};
  const auto at = static_cast<std::size_t>(axis);
  change_paths(image.scene, [&](Trajectory& path) {
    for (Rational& c : path.coordinates[at]) c = -c;
  });
  image.reverses_order = key.kind == Key::Kind::kCoordinate && key.axis == axis;
  if (key.kind == Key::Kind::kDirection) image.key.direction[at] = -key.direction[at];
  return image;
}

// All axes multiplied by the same number; -1 is half a turn.
inline Image scaled(const Scene& scene, const Key& key, const Rational& factor) {
  Image image{scene, key, 1, 0, false, {}, "times " + factor.to_string()};
  change_paths(image.scene, [&](Trajectory& path) {
    for (auto& axis : path.coordinates) {
      for (Rational& c : axis) c *= factor;
    }
  });
  image.reverses_order = factor < Rational(0) && key.kind != Key::Kind::kSquaredDistance;
  return image;
}

// Turned in the plane of the first two axes by an angle of the triangle with sides 3, 4, 5. Not for
// a coordinate as key.
inline Image turned(const Scene& scene, const Key& key) {
  Image image{scene, key, 1, 0, false, {}, "turned"};
  const Rational c(Integer(3), Integer(5)), s(Integer(4), Integer(5));
  change_paths(image.scene, [&](Trajectory& path) {
    auto& x = path.coordinates[0];
    auto& y = path.coordinates[1];
    x.resize(std::max(x.size(), y.size()));
    y.resize(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Rational old = x[k];
      x[k] = c * old - s * y[k];
      y[k] = s * old + c * y[k];
    }
  });
  if (key.kind == Key::Kind::kDirection) {
    const auto& d = key.direction;
    image.key.direction = {c * d[0] - s * d[1], s * d[0] + c * d[1]};
  }
  return image;
}

// The same motion added to all objects.
inline Image carried(const Scene& scene, const Key& key, const Trajectory& along) {
  Image image{scene, key, 1, 0, false, {}, "carried in degree " + std::to_string(along.degree())};
  change_paths(image.scene, [&](Trajectory& path) {
    for (std::size_t axis = 0; axis < path.coordinates.size(); ++axis) {
      auto& c = path.coordinates[axis];
      const auto& more = along.coordinates[axis];
      c.resize(std::max(c.size(), more.size()));
      for (std::size_t k = 0; k < more.size(); ++k) c[k] += more[k];
    }
  });
  return image;
}

// Object i is the old object name[i].
inline Image permuted(const Scene& scene, const Key& key, std::vector<ObjectId> name) {
  Image image{scene, key, 1, 0, false, std::move(name), "ids permuted"};
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    image.scene.objects[i] = scene.objects[image.name[i]];
    if (key.kind == Key::Kind::kSquaredDistance && image.name[i] == key.object) {
      image.key.object = static_cast<ObjectId>(i);
    }
  }
  return image;
}

// ---- instants

// The instant of an event in the time of the old scene.
inline RealRoot instant_of(const Recorded& event, const Image& image) {
  std::vector<Rational> c;
  for (const std::string& text : event.polynomial) c.push_back(*Rational::parse(text));
  RootCounters counters;
  const Polynomial p =
      Polynomial::from_rationals(composed(c, Rational(1) / image.a, -image.b / image.a));
  std::vector<RootWithMultiplicity> roots = isolate_real_roots(p, counters);
  const int index =
      image.reverses_time() ? static_cast<int>(roots.size()) - event.root : event.root - 1;
  return roots.at(static_cast<std::size_t>(index)).root;
}

// The events at one instant, in words, in any order.
struct Moment {
  RealRoot at;
  std::multiset<std::string> happenings;
};

// `word`: the text of an event, or nullopt for one that is left out.
template <class Word>
std::vector<Moment> moments_of(const std::vector<Recorded>& events, const Image& image,
                               const Word& word) {
  std::vector<Moment> moments;
  RootCounters counters;
  for (const Recorded& event : events) {
    const std::optional<std::string> text = word(event);
    if (!text) continue;
    RealRoot at = instant_of(event, image);
    if (moments.empty() || compare(moments.back().at, at, counters) != 0) {
      moments.push_back({std::move(at), {}});
    }
    moments.back().happenings.insert(*text);
  }
  if (image.reverses_time()) std::reverse(moments.begin(), moments.end());
  return moments;
}

// Exactly equal instants, and the same events at each.
inline void expect_same_moments(std::vector<Moment> expected, std::vector<Moment> found) {
  RootCounters counters;
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(compare(expected[i].at, found[i].at, counters), 0) << "instant " << i;
    ASSERT_EQ(expected[i].happenings, found[i].happenings) << "instant " << i;
  }
}

// Rational times before, between and after the given instants, inside (start, end).
inline std::vector<Rational> times_between(std::vector<RealRoot> instants, const Rational& start,
                                           const Rational& end) {
  RootCounters counters;
  std::sort(instants.begin(), instants.end(), [&](const RealRoot& x, const RealRoot& y) {
    RealRoot a = x, b = y;
    return compare(a, b, counters) < 0;
  });
  std::vector<Rational> times;
  const Rational half(Integer(1), Integer(2));
  RealRoot before(start);
  instants.emplace_back(end);
  for (RealRoot& at : instants) {
    if (compare(before, at, counters) >= 0) continue;  // equal, or before the start
    // compare() has made the intervals disjoint but for an end.
    while (!(before.upper() < at.lower())) {
      before.refine(counters);
      at.refine(counters);
    }
    times.push_back((before.upper() + at.lower()) * half);
    before = at;
  }
  return times;
}

}  // namespace kinex::test

#endif
