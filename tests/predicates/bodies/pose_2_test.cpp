// SPDX-License-Identifier: GPL-3.0-or-later
// Poses and the linear forms in them, against the same statements in world coordinates.
#include "predicates/bodies/pose_2.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace kinex {
namespace pose_2_test {

using Lists = std::vector<std::vector<Rational>>;
struct Vec {
  Rational x, y;
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
};
Rational dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y; }
Rational cross(const Vec& a, const Vec& b) { return a.x * b.y - a.y * b.x; }

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  int below(int bound) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(bound)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  Rational rational() { return Rational(Integer(between(-9, 9)), Integer(between(1, 4))); }
  Trajectory body(int positions, int rotor) {
    Trajectory result;
    for (const int degree : {positions, positions, rotor, rotor}) {
      std::vector<Rational>& axis = result.coordinates.emplace_back();
      for (int k = 0; k <= degree; ++k) axis.push_back(rational());
    }
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

// A body in the world at t.
struct Placed {
  Placed(const Trajectory& trajectory, const Rational& t)
      : origin{trajectory.position(0, t), trajectory.position(1, t)} {
    const Rational p = trajectory.position(2, t), q = trajectory.position(3, t);
    n = p * p + q * q;
    if (n.is_zero()) return;
    cos = (p * p - q * q) / n;
    sin = Rational(2) * p * q / n;
  }
  Vec turned(const Vec& v) const { return {cos * v.x - sin * v.y, sin * v.x + cos * v.y}; }
  Vec placed(const Vec& v) const { return origin + turned(v); }
  Vec origin;
  Rational n, cos, sin;
};

Rational value_at(const std::vector<Rational>& coefficients, const Rational& t) {
  Rational value;
  for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
  return value;
}

// The arguments of a predicate: the pose, then constants, all with `degree` + 1 coefficients.
class Arguments {
 public:
  Arguments(const Trajectory& pose, const std::vector<std::array<Rational, 3>>& constants)
      : degree_(pose.degree()) {
    add(pose.coordinates);
    for (const auto& c : constants) add({{c[0]}, {c[1]}, {c[2]}});
  }
  int degree() const { return degree_; }
  template <class R, class Convert>
  std::vector<std::vector<R>> in(Convert&& convert) const {
    std::vector<std::vector<R>> result;
    for (const auto& one : all_) {
      std::vector<R>& list = result.emplace_back();
      for (const Rational& q : one) list.push_back(convert(q));
    }
    return result;
  }

 private:
  void add(const Lists& axes) {
    std::vector<Rational>& list = all_.emplace_back();
    for (int axis = 0; axis < kPoseAxes; ++axis) {
      for (int k = 0; k <= degree_; ++k) {
        const auto a = static_cast<std::size_t>(axis), power = static_cast<std::size_t>(k);
        list.push_back(a < axes.size() && power < axes[a].size() ? axes[a][power] : Rational());
      }
    }
  }
  int degree_;
  std::vector<std::vector<Rational>> all_;
};

template <class R>
std::vector<const R*> views(const std::vector<std::vector<R>>& lists) {
  std::vector<const R*> result;
  for (const auto& list : lists) result.push_back(list.data());
  return result;
}

std::vector<Rational> rational_value(const Predicate& predicate, const Arguments& arguments) {
  const auto lists = arguments.in<Rational>([](const Rational& q) { return q; });
  return predicate.rational(arguments.degree(), views(lists).data());
}

Trajectory pose_of(const Trajectory& a, const Trajectory& b) {
  const Trajectory* bases[] = {&a, &b};
  return make_pose_2()->derive(bases);
}

// Two bodies, a line and a point in each frame; the points of B' are those of B, negated.
struct Example {
  explicit Example(Draw& draw)
      : a(draw.body(draw.below(3), draw.below(3))),
        b(draw.body(draw.below(3), draw.below(3))),
        pose(pose_of(a, b)),
        line_a{draw.rational(), draw.rational(), draw.rational()},
        line_b{draw.rational(), draw.rational(), draw.rational()},
        point_a{draw.rational(), draw.rational(), Rational(draw.between(1, 5))},
        point_b{draw.rational(), draw.rational(), Rational(draw.between(1, 5))},
        inner_a{line_b[0], line_a[1], point_b[2]},
        inner_b{line_a[2], line_b[1], point_a[2]} {}
  static Vec direction(const std::array<Rational, 3>& line) { return {line[0], line[1]}; }
  static Vec place(const std::array<Rational, 3>& point) {
    return {point[0] / point[2], point[1] / point[2]};
  }
  Trajectory a, b, pose;
  std::array<Rational, 3> line_a, line_b, point_a, point_b, inner_a, inner_b;
};

// The world's values, up to positive factors: B' = -B is carried to -R_B b seen from B's origin.
struct World {
  World(const Example& e, const Rational& t) : a(e.a, t), b(e.b, t) {
    if (a.n.is_zero() || b.n.is_zero()) return;
    const Vec minus_b = Vec{} - Example::place(e.point_b);  // a point of B
    const Vec m = a.turned(Example::direction(e.line_a));   // outward normals, in the world
    const Vec g = b.turned(Example::direction(e.line_b));   // of B', so inward for B
    const Vec point_a = a.placed(Example::place(e.point_a));
    const Vec point_b = b.placed(minus_b);
    // A's line m.x = h at its place; beyond it: the point of B.
    side_a = dot(m, point_b - a.origin) - e.line_a[2];
    // B's line g.x = -h at its place; before it: the point of A.
    side_b = dot(g, b.origin - point_a) - e.line_b[2];
    along_a = dot({-m.y, m.x}, point_b - point_a);
    along_b = dot({-g.y, g.x}, point_b - point_a);
    order = cross(g, m);
    // The ray from inner_a + R inner_b through point_a + R point_b, all in A's frame turned as A
    // is; t is where B's origin is seen from A's.
    const Vec inner = a.turned(Example::place(e.inner_a)) + b.turned(Example::place(e.inner_b));
    const Vec through = a.turned(Example::place(e.point_a)) + b.turned(Example::place(e.point_b));
    left = cross(through - inner, b.origin - a.origin - inner);
  }
  Placed a, b;
  Rational side_a, side_b, along_a, along_b, order, left;
};

// The factor that makes all coefficients of the pose integers.
Rational scale_of(const Example& e, const Rational& t) {
  return e.pose.position(4, t) / (Placed(e.a, t).n * Placed(e.b, t).n);
}

TEST(Pose2, ThePoseIsThatOfOneBodyInTheFrameOfTheOther) {
  Draw draw(1);
  for (int round = 0; round < 200; ++round) {
    const Example e(draw);
    const Rational t = draw.rational();
    const Placed a(e.a, t), b(e.b, t);
    if (a.n.is_zero() || b.n.is_zero()) continue;
    const auto axis = [&](int i) { return e.pose.position(i, t); };
    const Rational scale = scale_of(e, t);
    EXPECT_GT(scale.sign(), 0);
    const Rational later = t + Rational(1);  // no time is special
    if (!Placed(e.a, later).n.is_zero() && !Placed(e.b, later).n.is_zero()) {
      EXPECT_EQ(scale, scale_of(e, later));
    }
    const Rational n = a.n * b.n * scale;
    const Vec way = b.origin - a.origin;
    EXPECT_EQ(axis(0), n * dot(way, a.turned({1, 0})));
    EXPECT_EQ(axis(1), n * dot(way, a.turned({0, 1})));
    EXPECT_EQ(axis(2), n * dot(way, b.turned({1, 0})));
    EXPECT_EQ(axis(3), n * dot(way, b.turned({0, 1})));
    EXPECT_EQ(axis(5), n * dot(b.turned({1, 0}), a.turned({1, 0})));
    EXPECT_EQ(axis(6), n * dot(b.turned({1, 0}), a.turned({0, 1})));
  }
}

TEST(Pose2, DegreeIsThatOfPositionsAndTwiceBothRotors) {
  Draw draw(2);
  for (int positions = 0; positions <= 3; ++positions) {
    for (int rotor_a = 0; rotor_a <= 2; ++rotor_a) {
      for (int rotor_b = 0; rotor_b <= 2; ++rotor_b) {
        const Trajectory pose =
            pose_of(draw.body(positions, rotor_a), draw.body(positions, rotor_b));
        ASSERT_EQ(pose.dimension(), kPoseAxes);
        EXPECT_LE(pose.degree(), positions + 2 * (rotor_a + rotor_b));
        EXPECT_LE(pose.degree_of_axes(4, 7), 2 * (rotor_a + rotor_b));
        for (const int d : {1, 5, 9}) EXPECT_EQ(make_pose_side(Frame::kA, true)->degree(d), d);
      }
    }
  }
  EXPECT_EQ(make_pose_2()->name(), "pose_2");
}

struct Form {
  const char* name;
  std::shared_ptr<const Predicate> predicate;
  std::vector<std::array<Rational, 3>> constants;
  // From the world: the value is this times N and the constants' weights.
  Rational World::*wanted;
  int sign;
  Rational weight;
};

std::vector<Form> forms(const Example& e) {
  const Rational wa = e.point_a[2], wb = e.point_b[2];
  return {
      {"side_a", make_pose_side(Frame::kA, false), {e.line_a, e.point_b}, &World::side_a, 1, wb},
      {"inside_a", make_pose_side(Frame::kA, true), {e.line_a, e.point_b}, &World::side_a, -1, wb},
      {"side_b", make_pose_side(Frame::kB, false), {e.line_b, e.point_a}, &World::side_b, 1, wa},
      {"inside_b", make_pose_side(Frame::kB, true), {e.line_b, e.point_a}, &World::side_b, -1, wa},
      {"along_a",
       make_pose_along(Frame::kA),
       {e.line_a, e.point_a, e.point_b},
       &World::along_a,
       1,
       wa * wb},
      {"along_b",
       make_pose_along(Frame::kB),
       {e.line_b, e.point_a, e.point_b},
       &World::along_b,
       1,
       wa * wb},
      {"normal_order", make_pose_normal_order(false), {e.line_a, e.line_b}, &World::order, 1, 1},
      {"left_of_ray",
       make_pose_ray(false),
       {e.inner_a, e.inner_b, e.point_a, e.point_b},
       &World::left,
       1,
       wa * wb * e.inner_a[2] * e.inner_b[2]},
      {"right_of_ray",
       make_pose_ray(true),
       {e.inner_a, e.inner_b, e.point_a, e.point_b},
       &World::left,
       -1,
       wa * wb * e.inner_a[2] * e.inner_b[2]},
      {"normal_order_reversed",
       make_pose_normal_order(true),
       {e.line_a, e.line_b},
       &World::order,
       -1,
       1},
  };
}

TEST(PoseForms, AgreeWithTheWorld) {
  Draw draw(3);
  int zeros = 0;
  for (int round = 0; round < 300; ++round) {
    const Example e(draw);
    const Rational t = round % 5 == 0 ? Rational(0) : draw.rational();
    const World world(e, t);
    if (world.a.n.is_zero() || world.b.n.is_zero()) continue;
    for (const Form& form : forms(e)) {
      EXPECT_EQ(form.predicate->name(), form.name);
      EXPECT_EQ(form.predicate->arity(), static_cast<int>(form.constants.size()) + 1);
      EXPECT_EQ(form.predicate->dimension(), kPoseAxes);
      const Arguments arguments(e.pose, form.constants);
      const Rational value = value_at(rational_value(*form.predicate, arguments), t);
      const Rational wanted = world.*form.wanted * Rational(form.sign);
      EXPECT_EQ(value, wanted * form.weight * world.a.n * world.b.n * scale_of(e, t)) << form.name;
      zeros += value.is_zero();
    }
  }
  EXPECT_GT(zeros, 0);
}

// The point t itself: on the line of A shifted by b iff the two places touch in the world.
TEST(PoseForms, MultiplesOfConstantsAreTheSame) {
  Draw draw(4);
  for (int round = 0; round < 50; ++round) {
    const Example e(draw);
    for (const Form& form : forms(e)) {
      const std::vector<Rational> one = rational_value(*form.predicate, {e.pose, form.constants});
      auto doubled = form.constants;
      for (std::size_t i = 0; i < doubled.size(); ++i) {
        for (Rational& c : doubled[i]) c *= Rational(static_cast<int>(i) + 2);
      }
      const std::vector<Rational> many = rational_value(*form.predicate, {e.pose, doubled});
      const Rational factor = doubled.size() == 2 ? 6 : doubled.size() == 3 ? 24 : 120;
      for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(many[k], factor * one[k]) << form.name;
    }
  }
}

TEST(PoseForms, RingsAgree) {
  Draw draw(5);
  for (int round = 0; round < 60; ++round) {
    const Example e(draw);
    for (const Form& form : forms(e)) {
      const Arguments arguments(e.pose, form.constants);
      const int d = arguments.degree();
      const auto size = static_cast<std::size_t>(d) + 1;
      const std::vector<Rational> rational = rational_value(*form.predicate, arguments);
      ASSERT_EQ(rational.size(), size);

      // Every argument times its own factor that makes it integral.
      auto whole = arguments.in<Rational>([](const Rational& q) { return q; });
      Rational factor = 1;
      std::vector<std::vector<Integer>> integers;
      for (auto& list : whole) {
        Integer multiple = 1;
        for (const Rational& q : list) multiple = lcm(multiple, q.denominator());
        factor *= Rational(multiple);
        std::vector<Integer>& row = integers.emplace_back();
        for (const Rational& q : list) row.push_back((q * Rational(multiple)).numerator());
      }
      const Polynomial exact = form.predicate->exact(d, views(integers).data());
      for (std::size_t k = 0; k < size; ++k) {
        const Rational here =
            static_cast<int>(k) <= exact.degree() ? Rational(exact[k]) : Rational(0);
        EXPECT_EQ(here, factor * rational[k]) << form.name;
      }

      const auto floats = arguments.in<MpFloat>([](const Rational& q) { return MpFloat(200L, q); });
      std::vector<MpFloat> precise(size, MpFloat(200L));
      form.predicate->multiprecision(d, views(floats).data(), precise.data());
      const auto balls = arguments.in<Ball>([](const Rational& q) {
        const double value = q.to_double();
        return Ball{value, std::fabs(value) * 0x1p-52};
      });
      const auto doubles = arguments.in<double>([](const Rational& q) { return q.to_double(); });
      ASSERT_TRUE(form.predicate->shifts(d));
      for (const double shift : {0.0, 0.75, -3.0}) {
        std::vector<Ball> ball(size);
        std::vector<double> plain(size);
        form.predicate->ball(d, views(balls).data(), shift, ball.data());
        form.predicate->plain(d, views(doubles).data(), shift, plain.data());
        std::vector<Rational> shifted = rational;
        const Rational s = *Rational::from_double(shift);
        for (std::size_t k = 0; k < size; ++k) {
          for (std::size_t j = size - 1; j-- > k;) shifted[j] += s * shifted[j + 1];
        }
        for (std::size_t k = 0; k < size; ++k) {
          const Rational off = shifted[k] - *Rational::from_double(ball[k].value);
          const Rational error = *Rational::from_double(ball[k].error);
          EXPECT_LE(off, error) << form.name;
          EXPECT_GE(off, -error) << form.name;
          const double most = form.constants.size() < 4 ? 1e-6 : 1e-2;
          EXPECT_LE(ball[k].error, 1e-9 * (1 + std::fabs(ball[k].value)) + most);
          EXPECT_NEAR(plain[k], shifted[k].to_double(), ball[k].error + 1e-9) << form.name;
        }
        if (shift != 0) continue;
        for (std::size_t k = 0; k < size; ++k) {
          EXPECT_NEAR(precise[k].to_double(), rational[k].to_double(),
                      1e-12 * (1 + std::fabs(rational[k].to_double())))
              << form.name;
        }
      }
    }
  }
}

// The numbers of bodies are never machine integers.
TEST(PoseForms, RefuseNarrowNumbers) {
  const std::vector<double> magnitude(4, 1.0);
  for (const auto& predicate : {make_pose_side(Frame::kA, false), make_pose_along(Frame::kB)}) {
    EXPECT_FALSE(predicate->narrow_fits(1, magnitude.data(), 1));
    EXPECT_TRUE(std::isinf(predicate->reach_error(1)));
    Int128 out = 0;
    EXPECT_THROW(predicate->narrow(1, nullptr, &out), std::logic_error);
  }
}

}  // namespace pose_2_test
}  // namespace kinex
