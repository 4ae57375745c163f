// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/separating_wedge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/numbers/ball.h"
#include "core/numbers/exactly.h"

namespace kinex {
namespace {

using Vector = std::array<double, 2>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1]}; }
Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1]}; }
Vector rotated(const Vector& v, double c, double s) {
  return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

// The vector from the nearest point of segment p, q to `from`.
Vector from_segment(const Vector& p, const Vector& q, const Vector& from) {
  const Vector d = minus(q, p);
  const double length = dot(d, d);
  const double along = length > 0 ? dot(minus(from, p), d) / length : 0;
  const double k = std::clamp(along, 0.0, 1.0);
  return minus(from, {p[0] + k * d[0], p[1] + k * d[1]});
}

std::size_t lowest(const std::vector<Vector>& v) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (v[i][1] < v[best][1] || (v[i][1] == v[best][1] && v[i][0] < v[best][0])) best = i;
  }
  return best;
}

// The shortest vector from the sum of two convex polygons to t; {0, 0} if t is inside.
Vector from_sum(const std::vector<Vector>& a, const std::vector<Vector>& b, const Vector& t) {
  std::size_t i = lowest(a), j = lowest(b), done_a = 0, done_b = 0;
  Vector best{0, 0};
  double least = std::numeric_limits<double>::infinity();
  bool outside = false;
  while (done_a < a.size() || done_b < b.size()) {
    const Vector p = plus(a[i], b[j]);
    const std::size_t next_i = (i + 1) % a.size(), next_j = (j + 1) % b.size();
    const Vector ea = minus(a[next_i], a[i]), eb = minus(b[next_j], b[j]);
    const bool from_a = done_b == b.size() || (done_a < a.size() && cross(ea, eb) >= 0);
    const Vector e = from_a ? ea : eb;
    if (from_a) {
      i = next_i;
      ++done_a;
    } else {
      j = next_j;
      ++done_b;
    }
    outside = outside || cross(e, minus(t, p)) < 0;
    const Vector d = from_segment(p, plus(p, e), t);
    if (dot(d, d) < least) {
      least = dot(d, d);
      best = d;
    }
  }
  return outside ? best : Vector{0, 0};
}

// `value` is at most 1.
Rational rounded(double value, int bits) {
  return Rational(Integer(static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, bits)))),
                  Integer::power_of_two(static_cast<unsigned long>(bits)));
}

// The tangent of the polygon with this outward normal; its vertex is verified exactly.
FrameLine tangent(const FramePolygon& polygon, const RoughPolygon& rough, const Vector& direction,
                  int bits) {
  const Rational x = rounded(direction[0], bits), y = rounded(direction[1], bits);
  std::size_t best = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    if (dot(rough.vertices[i], direction) > dot(rough.vertices[best], direction)) best = i;
  }
  const std::size_t n = polygon.size();
  for (std::size_t step = 0; step < n; ++step) {
    const FrameLine line = frame_line(x, y, polygon.vertices[best]);
    const std::size_t next = (best + 1) % n, previous = (best + n - 1) % n;
    if (side(line, polygon.vertices[next]) == Sign::kPositive) {
      best = next;
    } else if (side(line, polygon.vertices[previous]) == Sign::kPositive) {
      best = previous;
    } else {
      break;
    }
  }
  return frame_line(x, y, polygon.vertices[best]);
}

double support(const RoughPolygon& rough, const Vector& direction) {
  double best = -std::numeric_limits<double>::infinity();
  for (const Vector& v : rough.vertices) best = std::max(best, dot(v, direction));
  return best;
}

// Relative error of a rounded time (core/numbers/rounded_instant.h).
constexpr double kTimeError = 0x1p-39;

// Bounds the absolute error of a product or a coefficient by underflow; no subnormal number, as in Ball.
constexpr double kTiny = 0x1p-900;
// Times beyond this are rounded to it, and are therefore unknown.
constexpr double kLatest = 0x1p1000;
// Lengths whose squares and products are in the range of doubles.
constexpr double kShortest = 0x1p-400, kLongest = 0x1p400;

// The value with a bound on its error, including the error of the rounded time t; infinite or NaN
// beyond the range of doubles.
Ball value_at(const std::vector<Rational>& p, double t) {
  double value = 0, slope = 0, size = 0, tiny = 0;
  for (std::size_t k = p.size(); k-- > 0;) {
    const double c = p[k].to_double();
    slope = slope * t + value;
    value = value * t + c;
    size = size * std::fabs(t) + std::fabs(c);
    tiny = tiny * std::fabs(t) + kTiny;
  }
  const double terms = static_cast<double>(4 * p.size());
  return {value, terms * (size * 0x1p-52 + tiny) +
                     (std::fabs(slope) + terms * (tiny + size * 0x1p-52)) *
                         (std::fabs(t) * kTimeError + kTiny)};
}

// False for NaN.
bool is_at_most(double value, double bound) { return value <= bound; }
bool is_usable(const RoughPolygon& polygon) {
  return polygon.diameter >= kShortest && is_at_most(polygon.reach, kLongest) &&
         is_at_most(polygon.diameter, kLongest) && is_at_most(polygon.radius, kLongest);
}

// Rounded down to ten bits; 0 for a value that is not finite, or so small that bits are missing.
Rational few_bits(double value) {
  if (!(std::fabs(value) >= 0x1p-1000) || std::isinf(value)) return Rational();
  const int exponent = std::ilogb(value) - 10;
  return exactly(std::ldexp(std::floor(std::ldexp(value, -exponent)), exponent));
}

// Bits that preserve an angle of this size.
int bits_for(double angle) {
  return std::clamp(static_cast<int>(std::ceil(-std::log2(angle))), 4, 44);
}

constexpr double kSmallest =
    0x1p-26;                       // separation over the diameter that doubles can resolve
constexpr double kClear = 0x1p10;  // separation over the error of a pose
constexpr double kWidest = 1.1;    // half-angle in radians
// The least half-angle of a wedge, in units of separation / diameter: the displacement is then more
// than 0.23 separations. Small enough to leave room where the separation is twice the diameter.
constexpr double kLeast = 0.47;
// The least room between wedge and line, in separations: enough for the same displacement. Less is
// found where the sum has edges that are nearly parallel.
constexpr double kRoom = 0.45;
constexpr double kAlike = 1e-3;  // angles and losses that differ by less count as equal

// The wedge of this body, seen in direction m of its frame at separation s.
WedgePlan::Role widest(const RoughPolygon& body, const Vector& m, double s) {
  const double height = support(body, m);
  if (s > 2 * body.diameter) {
    const Vector middle{Rational(body.middle.x, body.middle.w).to_double(),
                        Rational(body.middle.y, body.middle.w).to_double()};
    return {std::numeric_limits<double>::infinity(), body.radius + dot(middle, m) - height};
  }
  const auto loss = [&](double phi) {
    const double c = std::cos(phi), sine = std::sin(phi);
    const Vector right = rotated(m, c, -sine), left = rotated(m, c, sine);
    double most_right = dot(body.vertices[0], right), most_left = dot(body.vertices[0], left);
    for (const Vector& v : body.vertices) {
      most_right = std::max(most_right, dot(v, right));
      most_left = std::max(most_left, dot(v, left));
    }
    return (most_right + most_left) / (2 * c) - height;
  };
  WedgePlan::Role role{kLeast * s / body.diameter, 0};
  role.loss = loss(role.half_angle);
  while (2 * role.half_angle <= kWidest) {
    const double more = loss(2 * role.half_angle);
    if (more > s / 4) break;
    role = {2 * role.half_angle, more};
  }
  return role;
}

// How far the wedge is from failing at its line; `pose` in A's frame.
double room(const SeparatingWedge& wedge, const RoughPose& pose, Frame line_of) {
  const bool of_a = line_of == Frame::kA;
  // Long numbers: over the largest.
  const Integer scale = std::max(abs(wedge.line.nx), abs(wedge.line.ny));
  const Vector n{Rational(wedge.line.nx, scale).to_double(),
                 Rational(wedge.line.ny, scale).to_double()};
  const Vector v{Rational(wedge.v.x, wedge.v.w).to_double(),
                 Rational(wedge.v.y, wedge.v.w).to_double()};
  const Vector t = of_a ? pose.t : rotated(pose.t, pose.c, -pose.s);
  const Vector apex = rotated(v, pose.c, of_a ? pose.s : -pose.s);
  const double h = Rational(wedge.line.h, scale).to_double();
  return (dot(n, minus(t, apex)) - h) / std::hypot(n[0], n[1]);
}

double error_of(const RoughPose& pose, const RoughPolygon& a, const RoughPolygon& b) {
  // Vertices are rounded, too.
  return pose.error_t + (a.reach + b.reach) * (pose.error_turn + 0x1p-52);
}

}  // namespace

RoughPolygon::RoughPolygon(const FramePolygon& polygon) {
  for (const FramePoint& p : polygon.vertices) {
    vertices.push_back({Rational(p.x, p.w).to_double(), Rational(p.y, p.w).to_double()});
  }
  double x = 0, y = 0;
  for (const Vector& v : vertices) {
    x += v[0] / static_cast<double>(vertices.size());
    y += v[1] / static_cast<double>(vertices.size());
    reach = std::max(reach, std::hypot(v[0], v[1]));
    for (const Vector& w : vertices)
      diameter = std::max(diameter, std::hypot(v[0] - w[0], v[1] - w[1]));
  }
  middle = frame_point(few_bits(x), few_bits(y));
  const Vector centre{Rational(middle.x, middle.w).to_double(),
                      Rational(middle.y, middle.w).to_double()};
  for (const Vector& v : vertices) {
    radius = std::max(radius, std::hypot(v[0] - centre[0], v[1] - centre[1]));
  }
  radius *= 1 + 0x1p-40;
}

template <class Value>
RoughPose::RoughPose(Frame frame, const Value& at) {
  const std::size_t x = frame == Frame::kA ? 0 : 2;
  const Ball n = at(4), tx = at(x), ty = at(x + 1), cosine = at(5), sine = at(6);
  t = {tx.value / n.value, ty.value / n.value};
  c = cosine.value / n.value;
  s = sine.value / n.value;
  const double least = n.value - n.error;
  error_t = (tx.error + ty.error + (std::fabs(t[0]) + std::fabs(t[1])) * n.error) / least;
  error_turn = (cosine.error + sine.error + 2 * n.error) / least;
  if (frame == Frame::kB) s = -s;
  const double sum = std::fabs(t[0]) + std::fabs(t[1]) + std::fabs(c) + std::fabs(s);
  if (!(least > 0x1p-900) || !is_at_most(sum + error_t + error_turn, kLongest)) forget();
}

// Makes the pose unknown.
void RoughPose::forget() {
  t = {0, 0};
  c = 1;
  s = 0;
  error_t = error_turn = std::numeric_limits<double>::infinity();
}

RoughPose::RoughPose(const Trajectory& pose, double now, Frame frame)
    : RoughPose(frame, [&](std::size_t axis) { return value_at(pose.coordinates[axis], now); }) {
  if (!is_at_most(std::fabs(now), kLatest)) forget();
}

RoughPose RoughPose::precise(const Trajectory& pose, double now, Frame frame) {
  const Rational t = Rational::from_double(now).value_or(Rational());
  const Rational time_error = exactly(kTimeError);
  RoughPose result(frame, [&](std::size_t axis) {
    Rational value, slope;
    const std::vector<Rational>& p = pose.coordinates[axis];
    for (std::size_t k = p.size(); k-- > 0;) {
      slope = slope * t + value;
      value = value * t + p[k];
    }
    const double v = value.to_double();
    return Ball{v, std::fabs(v) * 0x1p-52 + std::fabs((slope * t * time_error).to_double()) +
                       std::fabs(slope.to_double()) * kTiny + kTiny};
  });
  if (!is_at_most(std::fabs(now), kLatest)) result.forget();
  return result;
}

bool is_too_rough(const RoughPose& pose, const RoughPolygon& a, const RoughPolygon& b) {
  return !is_at_most(error_of(pose, a, b) * kClear, kSmallest * (a.diameter + b.diameter));
}

Frame WedgePlan::longer() const {
  const double a = line_of_a.half_angle, b = line_of_b.half_angle;
  if (a > b * (1 + kAlike)) return Frame::kA;
  if (b > a * (1 + kAlike)) return Frame::kB;
  const double cost = line_of_a.loss - line_of_b.loss;
  if (std::fabs(cost) > separation * kAlike) return cost < 0 ? Frame::kA : Frame::kB;
  return diameter_a > diameter_b ? Frame::kB : Frame::kA;
}

std::optional<WedgePlan> plan_wedge(const RoughPolygon& a, const RoughPolygon& b,
                                    const RoughPose& pose) {
  if (!is_usable(a) || !is_usable(b)) return std::nullopt;
  std::vector<Vector> turned_b;
  turned_b.reserve(b.vertices.size());
  for (const Vector& v : b.vertices) turned_b.push_back(rotated(v, pose.c, pose.s));
  const Vector away = from_sum(a.vertices, turned_b, pose.t);
  const double s = std::hypot(away[0], away[1]);
  if (!(s > kSmallest * (a.diameter + b.diameter)) || !(s < kLongest)) return std::nullopt;
  if (!(s > kClear * error_of(pose, a, b))) return std::nullopt;
  WedgePlan plan;
  plan.separation = s;
  plan.direction = {away[0] / s, away[1] / s};
  plan.line_of_a = widest(b, rotated(plan.direction, pose.c, -pose.s), s);
  plan.line_of_b = widest(a, plan.direction, s);
  plan.diameter_a = a.diameter;
  plan.diameter_b = b.diameter;
  return plan;
}

std::optional<SeparatingWedge> separating_wedge(const WedgePlan& plan, Frame line_of,
                                                const WedgeBody& a, const WedgeBody& b,
                                                const RoughPose& pose) {
  const bool of_a = line_of == Frame::kA;
  const WedgeBody &lined = of_a ? a : b, &wedged = of_a ? b : a;
  const WedgePlan::Role& role = of_a ? plan.line_of_a : plan.line_of_b;
  const Vector &in_a = plan.direction, in_b = rotated(plan.direction, pose.c, -pose.s);
  const Vector &m = of_a ? in_a : in_b, &seen = of_a ? in_b : in_a;
  const double s = plan.separation;
  SeparatingWedge wedge;
  wedge.turns = std::isfinite(role.half_angle);
  const int line_bits = bits_for(s / (32 * (plan.diameter_a + plan.diameter_b)));
  const FrameLine touching = tangent(lined.polygon, lined.rough, m, line_bits);
  // Its normal is primitive, of any length: a multiple of the rounded m.
  const double guard = s / 8 + (wedge.turns ? 0 : wedged.rough.radius * (1 + 0x1p-8));
  const double length = std::hypot(touching.nx.to_double(), touching.ny.to_double());
  Rational beyond;
  if (is_at_most(length, kLongest)) {
    beyond = few_bits(length * guard);
  } else {
    const Rational x = rounded(m[0], line_bits), y = rounded(m[1], line_bits);
    const Rational times = x.is_zero() ? Rational(touching.ny) / y : Rational(touching.nx) / x;
    beyond = times * few_bits(std::hypot(x.to_double(), y.to_double()) * guard);
  }
  wedge.line = frame_line(Rational(touching.nx), Rational(touching.ny),
                          Rational(touching.h) + beyond);
  if (!wedge.turns) {
    wedge.v = wedged.rough.middle;
    // Far from its frame's origin a body's place is too inaccurate for the direction.
    if (!(room(wedge, pose, line_of) >= kRoom * s)) return std::nullopt;
    return wedge;
  }
  const double c = std::cos(role.half_angle), sine = std::sin(role.half_angle);
  const int bits = bits_for(role.half_angle / 256);
  wedge.g1 = tangent(wedged.polygon, wedged.rough, rotated(seen, c, -sine), bits);
  wedge.g2 = tangent(wedged.polygon, wedged.rough, rotated(seen, c, sine), bits);
  if (turn(wedge.g1, wedge.g2) != Sign::kPositive) return std::nullopt;
  wedge.v = meeting(wedge.g1, wedge.g2);
  if (!(room(wedge, pose, line_of) >= kRoom * s)) return std::nullopt;
  return wedge;
}

}  // namespace kinex
