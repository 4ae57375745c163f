// SPDX-License-Identifier: GPL-3.0-or-later
// Let q_1 .. q_k be the corners of K(t) in order around it (k = 3: a triangle; k = 4: a
// parallelogram), n = (q_2 - q_1) x (q_k - q_1) its normal, and f = det(q_1, q_2, q_k), which is
// n times the position of K's plane. The origin is 0. Contact at t means 0 in K(t).
//
// (1) Contact at one given instant where f = 0 (f vanishes at every contact):
//   (a) If n is not 0, K is a convex polygon whose plane contains 0. Then 0 lies in K iff it is on
//       the inner side of every edge: n . (q_i x q_{i+1}) >= 0 for all i.
//   (b) If n = 0, all corners lie on one line (in a parallelogram because n = 0 makes the two
//       directions of its sides parallel). A closed walk on a line covers the hull of its corners,
//       so 0 lies in K iff it lies on one of the segments [q_i, q_{i+1}].
//       0 lies on [u, v] iff u x v = 0 and u . v <= 0: u, v and 0 are then collinear, and u and v
//       are not strictly on the same side of 0. (For u = v, u . u <= 0 says u = 0.)
//
// (2) The first contact, if f is not identically zero: the candidates are its roots in [0, 1], in
//     ascending order.
//
// (3) The first contact, if f is identically zero: t = 0 is tried first. If there is no contact
//     then, let T > 0 be the first one. 0 lies on an edge of K(T):
//       if n(T) = 0, because K is the union of its edges, by (1b);
//       else, because otherwise n . (q_i x q_{i+1}) > 0 for all i at T, and so shortly before T,
//       where f = 0 as well: an earlier contact.
//     So T is the smallest, over all i, of the first times at which 0 lies on [q_i, q_{i+1}]. For
//     one edge [u, v]:
//       if a component g of u x v is not identically zero, all such times are roots of g;
//       if all three are, such times are those with u . v <= 0. u . v > 0 at t = 0, so the first of
//       them is a root of u . v, and every root of u . v is such a time.
//     So in both cases the candidates are the roots in (0, 1] of the first polynomial that is not
//     identically zero, among the three components and u . v.
#include "predicates/ccd/contact_exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/exactly.h"

namespace kinex {

namespace {

using Vector = std::array<Polynomial, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The coordinates on one axis, times a positive number that makes them integers.
using Integers = std::array<Integer, 2 * ContactQuery::kPoints>;

Integers scaled_doubles(const ContactQuery& query, std::size_t axis) {
  constexpr int kMantissa = 53;
  Integers result;
  std::array<int, 2 * ContactQuery::kPoints> exponents{};
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double mantissa = std::frexp(query.rounded(3 * i + axis).value, &exponents[i]);
    if (mantissa == 0) continue;
    result[i] = Integer(static_cast<std::int64_t>(std::ldexp(mantissa, kMantissa)));
    least = std::min(least, exponents[i]);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!result[i].is_zero()) result[i] <<= static_cast<unsigned long>(exponents[i] - least);
  }
  return result;
}

Integers scaled_fractions(const ContactQuery& query, std::size_t axis) {
  Integers result;
  Integer denominator(1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    denominator = lcm(denominator, query.coordinate(3 * i + axis).denominator());
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = (query.coordinate(3 * i + axis) * Rational(denominator)).numerator();
  }
  return result;
}

// The four points as polynomials in t. Contact does not depend on the units of the axes, so each
// axis has its own positive factor.
std::array<Vector, ContactQuery::kPoints> moving_points(const ContactQuery& query) {
  std::array<Vector, ContactQuery::kPoints> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Integers values =
        query.all_doubles() ? scaled_doubles(query, axis) : scaled_fractions(query, axis);
    for (std::size_t p = 0; p < ContactQuery::kPoints; ++p) {
      const Integer& start = values[p];
      result[p][axis] =
          Polynomial(std::vector<Integer>{start, values[p + ContactQuery::kPoints] - start});
    }
  }
  return result;
}

class MovingPolygon {
 public:
  explicit MovingPolygon(const ContactQuery& query) {
    const std::array<Vector, ContactQuery::kPoints> p = moving_points(query);
    if (query.kind() == ContactKind::kVertexFace) {
      corners_ = {p[1] - p[0], p[2] - p[0], p[3] - p[0]};
    } else {
      corners_ = {p[2] - p[0], p[3] - p[0], p[3] - p[1], p[2] - p[1]};
    }
    f_ = dot(cross(corners_[0], corners_[1]), corners_.back());
  }

  const Polynomial& f() const { return f_; }

  std::optional<ContactTime> first_contact(RootCounters& counters) const {
    if (!f_.is_zero()) {
      return first_root(f_, Rational(0), counters,
                        [&](RealRoot& root) { return holds_origin(root, counters); });
    }
    RealRoot start(Rational(0));
    if (holds_origin(start, counters)) {
      return ContactTime{start, Polynomial(std::vector<Integer>{Integer(0), Integer(1)})};
    }
    std::optional<ContactTime> first;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      std::optional<ContactTime> time = first_on_edge(i, counters);
      if (time && (!first || compare(time->root, first->root, counters) < 0)) {
        first = std::move(time);
      }
    }
    return first;
  }

 private:
  const Vector& corner(std::size_t i) const { return corners_[i % corners_.size()]; }

  // The first root of p in [0, 1] for which `accepts`.
  template <class Accepts>
  static std::optional<ContactTime> first_root(const Polynomial& p, const Rational& from,
                                               RootCounters& counters, const Accepts& accepts) {
    for (RootWithMultiplicity& entry : isolate_real_roots(p, counters)) {
      if (compare(entry.root, from, counters) < 0) continue;
      if (compare(entry.root, Rational(1), counters) > 0) break;
      if (accepts(entry.root)) return ContactTime{std::move(entry.root), p};
    }
    return std::nullopt;
  }

  static bool vanishes(const Vector& v, RealRoot& at, RootCounters& counters) {
    return std::all_of(v.begin(), v.end(), [&](const Polynomial& component) {
      return sign_at(component, at, counters) == Sign::kZero;
    });
  }

  bool on_edge(std::size_t i, RealRoot& at, RootCounters& counters) const {
    return vanishes(cross(corner(i), corner(i + 1)), at, counters) &&
           sign_at(dot(corner(i), corner(i + 1)), at, counters) != Sign::kPositive;
  }

  // Whether the origin lies in the polygon at an instant where f is 0.
  bool holds_origin(RealRoot& at, RootCounters& counters) const {
    const Vector normal = cross(corners_[1] - corners_[0], corners_.back() - corners_[0]);
    const bool flat = vanishes(normal, at, counters);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (flat) {
        if (on_edge(i, at, counters)) return true;
      } else if (sign_at(dot(normal, cross(corner(i), corner(i + 1))), at, counters) ==
                 Sign::kNegative) {
        return false;
      }
    }
    return !flat;
  }

  // The first time in (0, 1] at which the origin lies on an edge; there is no contact at 0.
  std::optional<ContactTime> first_on_edge(std::size_t i, RootCounters& counters) const {
    const Vector turn = cross(corner(i), corner(i + 1));
    const Polynomial product = dot(corner(i), corner(i + 1));
    const auto* candidates =
        std::find_if(turn.begin(), turn.end(), [](const Polynomial& p) { return !p.is_zero(); });
    const Polynomial& p = candidates == turn.end() ? product : *candidates;
    require(!p.is_zero(), "contact: an edge that always holds the origin");
    return first_root(p, Rational(0), counters,
                      [&](RealRoot& root) { return on_edge(i, root, counters); });
  }

  std::vector<Vector> corners_;
  Polynomial f_;
};

}  // namespace

std::optional<ContactTime> first_contact_exactly(const ContactQuery& query,
                                                 RootCounters& counters) {
  return MovingPolygon(query).first_contact(counters);
}

ContactTime contact_between(const ContactQuery& query, double lower, double upper) {
  const MovingPolygon polygon(query);
  return {RealRoot(polygon.f(), exactly(lower), exactly(upper)),
          polygon.f()};
}

}  // namespace kinex
