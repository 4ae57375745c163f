// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/peers/case.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kinex::peers {

namespace {

// Stored and loaded: g++ 12 with -O3 omits the rounding where it vectorises two operations.
double nearest_float(double x) {
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

PeerPose nearest_float(const PeerPose& pose) {
  return {nearest_float(pose.x), nearest_float(pose.y), nearest_float(pose.angle)};
}

PeerPose between(const PeerPose& p, const PeerPose& q, double s) {
  return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.angle + s * (q.angle - p.angle)};
}

PeerShape placed(const PeerShape& shape, const PeerPose& pose) {
  const double c = std::cos(pose.angle), s = std::sin(pose.angle);
  PeerShape result;
  result.reserve(shape.size());
  for (const auto& v : shape) {
    result.push_back({pose.x + c * v[0] - s * v[1], pose.y + s * v[0] + c * v[1]});
  }
  return result;
}

// The largest distance of b from the line of an edge of a.
double best_line(const PeerShape& a, const PeerShape& b) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i];
    const auto& q = a[(i + 1) % a.size()];
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& v : b) {
      const double out = (q[1] - p[1]) * (v[0] - p[0]) - (q[0] - p[0]) * (v[1] - p[1]);
      least = std::min(least, out / length);
    }
    best = std::max(best, least);
  }
  return best;
}

double closest(const PeerShape& a, const PeerShape& b) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i];
    const auto& q = a[(i + 1) % a.size()];
    const double dx = q[0] - p[0], dy = q[1] - p[1], square = dx * dx + dy * dy;
    for (const auto& v : b) {
      const double s = std::clamp(((v[0] - p[0]) * dx + (v[1] - p[1]) * dy) / square, 0.0, 1.0);
      best = std::min(best, std::hypot(v[0] - p[0] - s * dx, v[1] - p[1] - s * dy));
    }
  }
  return best;
}

}  // namespace

PeerCase PeerCase::as_float() const {
  PeerCase result = *this;
  for (PeerShape* shape : {&result.a, &result.b}) {
    for (auto& v : *shape) v = {nearest_float(v[0]), nearest_float(v[1])};
  }
  for (PeerFrame& frame : result.frames) {
    frame = {nearest_float(frame.a), nearest_float(frame.b)};
  }
  return result;
}

PeerFrame PeerCase::at(double time) const {
  const double place = time * static_cast<double>(frames.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), frames.size() - 2);
  const double s = place - static_cast<double>(i);
  return {between(frames[i].a, frames[i + 1].a, s), between(frames[i].b, frames[i + 1].b, s)};
}

double PeerCase::largest_turn() const {
  double most = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    most = std::max({most, std::abs(frames[i + 1].a.angle - frames[i].a.angle),
                     std::abs(frames[i + 1].b.angle - frames[i].b.angle)});
  }
  return most;
}

bool PeerCase::turns_alike() const {
  const PeerFrame& first = frames.front();
  return std::all_of(frames.begin(), frames.end(), [&](const PeerFrame& frame) {
    return frame.a.angle == frame.b.angle && frame.a.x == first.a.x && frame.a.y == first.a.y &&
           frame.b.x == first.b.x && frame.b.y == first.b.y;
  });
}

double outer_radius(const PeerShape& shape) {
  double radius = 0;
  for (const auto& v : shape) radius = std::max(radius, std::hypot(v[0], v[1]));
  return radius;
}

double inner_radius(const PeerShape& shape) { return -best_line(shape, PeerShape{{0.0, 0.0}}); }

double signed_distance(const PeerCase& question, const PeerFrame& frame) {
  const PeerShape a = placed(question.a, frame.a), b = placed(question.b, frame.b);
  const double line = std::max(best_line(a, b), best_line(b, a));
  return line <= 0 ? line : std::min(closest(a, b), closest(b, a));
}

}  // namespace kinex::peers
