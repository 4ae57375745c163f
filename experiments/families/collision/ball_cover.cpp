// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/ball_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace kinex::families {
namespace {

using Point = std::array<double, 2>;

constexpr double kStep = 1.0 / 64;  // between samples, of the separation
constexpr int kFirstSteps = 8;      // of a flight plan, before they are halved
constexpr int kMostHalvings = 40;

Point turned(const Point& p, double c, double s) {
  return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
}

double length(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

double to_segment(const Point& x, const Point& p, const Point& q) {
  const double dx = q[0] - p[0], dy = q[1] - p[1], ex = x[0] - p[0], ey = x[1] - p[1];
  const double k = std::clamp((ex * dx + ey * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double fx = ex - k * dx, fy = ey - k * dy;
  return fx * fx + fy * fy;
}

double to_edges(const std::vector<Point>& vertices, const std::vector<Point>& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& x : vertices) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      least = std::min(least, to_segment(x, polygon[i], polygon[(i + 1) % polygon.size()]));
    }
  }
  return least;
}

struct Body {
  explicit Body(const SceneObject& object) : motion(object.motion) {
    for (const Vertex2& v : object.polygon) {
      polygon.push_back({v[0].to_double(), v[1].to_double()});
      reach = std::max(reach, std::hypot(polygon.back()[0], polygon.back()[1]));
    }
  }
  const Motion& motion;
  std::vector<Point> polygon;
  double reach = 0;
};

// A flight plan in doubles.
struct Plan {
  std::array<std::vector<double>, kBodyAxes> axes;
  Plan(const Motion& motion, double at) {
    for (const MotionPiece& piece : motion.pieces) {
      if ((piece.from && piece.from->to_double() > at) ||
          (piece.to && piece.to->to_double() < at)) {
        continue;
      }
      for (std::size_t k = 0; k < axes.size(); ++k) {
        axes[k].clear();
        for (const Rational& c : piece.trajectory.coordinates[k]) axes[k].push_back(c.to_double());
      }
    }
  }
  double operator()(std::size_t axis, double at) const {
    double value = 0;
    for (std::size_t k = axes[axis].size(); k-- > 0;) value = value * at + axes[axis][k];
    return value;
  }
};

// The relative position of the bodies at one instant.
struct Pose {
  Point t{}, seen{};  // the second one's origin in the frame of the first, and in its own
  double c = 1, s = 0;
  double separation = 0;
};

class Path {
 public:
  explicit Path(const Scene& scene) : a_(scene.objects[0]), b_(scene.objects[1]) {
    std::set<double> times{scene.start.to_double(), scene.end->to_double()};
    for (const Body* body : {&a_, &b_}) {
      for (const MotionPiece& piece : body->motion.pieces) {
        if (piece.from) times.insert(piece.from->to_double());
        if (piece.to) times.insert(piece.to->to_double());
      }
    }
    times.erase(times.begin(), times.find(scene.start.to_double()));
    times.erase(times.upper_bound(scene.end->to_double()), times.end());
    for (auto from = times.begin(), to = std::next(from); to != times.end(); ++from, ++to) {
      add_plan(*from, *to);
    }
  }

  std::uint64_t cover() const {
    std::uint64_t pieces = 0;
    const std::size_t end = poses_.size() - 1;
    for (std::size_t first = 0; first < end; ++pieces) {
      std::size_t best = first + 1;
      for (std::size_t centre = first; centre <= end && best < end; ++centre) {
        std::size_t i = first;
        while (i <= centre && holds(centre, i)) ++i;
        if (i <= centre) break;
        while (i <= end && holds(centre, i)) ++i;
        best = std::max(best, i - 1);
      }
      first = best;
    }
    return pieces;
  }

 private:
  Pose pose(const Plan& a, const Plan& b, double at) const {
    const double pa = a(2, at), qa = a(3, at), pb = b(2, at), qb = b(3, at);
    const double na = pa * pa + qa * qa, nb = pb * pb + qb * qb;
    const Point way{b(0, at) - a(0, at), b(1, at) - a(1, at)};
    Pose result;
    result.t = turned(way, (pa * pa - qa * qa) / na, -2 * pa * qa / na);
    result.seen = turned(way, (pb * pb - qb * qb) / nb, -2 * pb * qb / nb);
    const double p = pa * pb + qa * qb, q = pa * qb - qa * pb;
    result.c = (p * p - q * q) / (na * nb);
    result.s = 2 * p * q / (na * nb);
    std::vector<Point> placed;
    for (const Point& v : b_.polygon) {
      const Point x = turned(v, result.c, result.s);
      placed.push_back({result.t[0] + x[0], result.t[1] + x[1]});
    }
    result.separation =
        std::sqrt(std::min(to_edges(placed, a_.polygon), to_edges(a_.polygon, placed)));
    return result;
  }

  double way(const Pose& x, const Pose& y) const {
    const double turn = std::fabs(std::atan2(x.c * y.s - x.s * y.c, x.c * y.c + x.s * y.s));
    return std::max(length(x.t, y.t) + b_.reach * turn, length(x.seen, y.seen) + a_.reach * turn);
  }

  void add_plan(double from, double to) {
    const double middle = from + (to - from) / 2;
    const Plan a(a_.motion, middle), b(b_.motion, middle);
    const Pose first = pose(a, b, from);
    if (poses_.empty()) add(first);
    Pose last = first;
    for (int i = 0; i < kFirstSteps; ++i) {
      const double low = from + (to - from) * i / kFirstSteps;
      const double high = i + 1 == kFirstSteps ? to : from + (to - from) * (i + 1) / kFirstSteps;
      const Pose next = pose(a, b, high);
      add_between(a, b, low, last, high, next, 0);
      last = next;
    }
  }

  // All samples after `x`, up to `y`.
  void add_between(const Plan& a, const Plan& b, double low, const Pose& x, double high,
                   const Pose& y, int halvings) {
    const double allowed = kStep * std::min(x.separation, y.separation);
    if (way(x, y) <= allowed || halvings == kMostHalvings) {
      add(y);
      return;
    }
    const double middle = low + (high - low) / 2;
    const Pose between = pose(a, b, middle);
    add_between(a, b, low, x, middle, between, halvings + 1);
    add_between(a, b, middle, between, high, y, halvings + 1);
  }

  void add(const Pose& x) {
    gaps_.push_back(0);
    if (!poses_.empty()) {
      const double gap = way(poses_.back(), x);
      gaps_.back() = gap;
      gaps_[gaps_.size() - 2] = std::max(gaps_[gaps_.size() - 2], gap);
    }
    poses_.push_back(x);
  }

  bool holds(std::size_t centre, std::size_t i) const {
    return way(poses_[centre], poses_[i]) + gaps_[i] <= kBallRadius * poses_[centre].separation;
  }

  Body a_, b_;
  std::vector<Pose> poses_;
  std::vector<double> gaps_;  // to the farther neighbour
};

}  // namespace

std::uint64_t ball_cover(const Scene& scene) { return Path(scene).cover(); }

}  // namespace kinex::families
