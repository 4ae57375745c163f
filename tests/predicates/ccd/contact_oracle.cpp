// SPDX-License-Identifier: GPL-3.0-or-later
// The set of contact times is described by signs of the polynomials below. Between two neighbouring
// roots of those that are not identically zero every sign is constant, and so is contact. The set
// is closed, so its first time is 0 or one of these roots.
#include "tests/predicates/ccd/contact_oracle.h"

#include <algorithm>
#include <utility>

namespace kinex::test {

namespace {

using P = RationalPolynomial;
using Vector = std::array<P, 3>;
constexpr std::array<std::pair<std::size_t, std::size_t>, 3> kPlanes{{{0, 1}, {0, 2}, {1, 2}}};

P combine(const P& a, const P& b, int factor) {
  std::vector<Rational> c(a.coefficients());
  c.resize(std::max(c.size(), b.coefficients().size()));
  for (std::size_t i = 0; i < b.coefficients().size(); ++i) c[i] += Rational(factor) * b[i];
  return P(std::move(c));
}
P plus(const P& a, const P& b) { return combine(a, b, 1); }
P minus(const P& a, const P& b) { return combine(a, b, -1); }
P times(const P& a, const P& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Rational> c(a.coefficients().size() + b.coefficients().size() - 1);
  for (std::size_t i = 0; i < a.coefficients().size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients().size(); ++j) c[i + j] += a[i] * b[j];
  }
  return P(std::move(c));
}
Vector minus(const Vector& a, const Vector& b) {
  return {minus(a[0], b[0]), minus(a[1], b[1]), minus(a[2], b[2])};
}
P turn(const Vector& a, const Vector& b, std::pair<std::size_t, std::size_t> plane) {
  return minus(times(a[plane.first], b[plane.second]), times(a[plane.second], b[plane.first]));
}

// Halves the interval; Sturm's theorem finds the half that contains the root.
void refine(OracleRoot& root, SturmWork& work) {
  if (root.lower == root.upper) return;
  const Rational middle = (root.lower + root.upper) / Rational(2);
  if (RationalSturm(root.polynomial, work).count(root.lower, middle) == 1) {
    root.upper = middle;
  } else {
    root.lower = middle;
  }
}

// Sign of q at the root.
int sign_of(const P& q, OracleRoot root, SturmWork& work) {
  if (q.is_zero()) return 0;
  if (root.lower == root.upper) return q.value_at(root.lower).sign();
  const P common = gcd(root.polynomial, q, work);
  if (common.degree() > 0 && RationalSturm(common, work).count(root.lower, root.upper) == 1) {
    return 0;
  }
  const RationalSturm sturm(q, work);
  while (sturm.count(root.lower, root.upper) > 0) refine(root, work);
  return q.value_at(root.upper).sign();
}

// All roots in [0, 1].
std::vector<OracleRoot> roots_of(const P& p, SturmWork& work) {
  std::vector<OracleRoot> result;
  if (p.degree() < 1) return result;
  const RationalSturm sturm(p, work);
  const P& square_free = sturm.square_free();
  if (square_free.value_at(Rational(0)).is_zero()) {
    result.push_back({square_free, Rational(0), Rational(0)});
  }
  std::vector<std::pair<Rational, Rational>> open{{Rational(0), Rational(1)}};
  while (!open.empty()) {
    const auto [low, high] = open.back();
    open.pop_back();
    const int count = sturm.count(low, high);
    if (count == 1) result.push_back({square_free, low, high});
    if (count < 2) continue;
    const Rational middle = (low + high) / Rational(2);
    open.emplace_back(middle, high);
    open.emplace_back(low, middle);
  }
  return result;
}

// Whether a < b; equality is decided by a common factor.
bool less(OracleRoot a, OracleRoot b, SturmWork& work) {
  if (sign_of(b.polynomial, a, work) == 0) {
    const P above({-b.lower, Rational(1)}), below({-b.upper, Rational(1)});
    const int from = sign_of(above, a, work), to = sign_of(below, a, work);
    if (b.lower == b.upper ? from == 0 : from > 0 && to <= 0) return false;
  }
  for (;;) {
    if (a.upper < b.lower) return true;
    if (b.upper < a.lower) return false;
    // Intervals that keep touching have different roots: the common end is the root of one only.
    if (a.upper == b.lower && b.lower != b.upper) return true;
    if (b.upper == a.lower && a.lower != a.upper) return false;
    refine(a, work);
    refine(b, work);
  }
}

class Oracle {
 public:
  Oracle(ContactKind kind, const Points& points) : kind_(kind) {
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at_[p][axis] = P({points[p][axis], points[p + 4][axis] - points[p][axis]});
      }
    }
    const bool face = kind == ContactKind::kVertexFace;
    first_ = face ? minus(at_[2], at_[1]) : minus(at_[1], at_[0]);
    second_ = face ? minus(at_[3], at_[1]) : minus(at_[3], at_[2]);
    offset_ = face ? minus(at_[0], at_[1]) : minus(at_[2], at_[0]);
    plane_ = plus(minus(times(turn(first_, second_, kPlanes[0]), offset_[2]),
                        times(turn(first_, second_, kPlanes[1]), offset_[1])),
                  times(turn(first_, second_, kPlanes[2]), offset_[0]));
    segments_ =
        face ? std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}
             : std::vector<std::array<std::size_t, 3>>{{0, 2, 3}, {1, 2, 3}, {2, 0, 1}, {3, 0, 1}};
  }

  std::optional<OracleRoot> first_contact() {
    std::vector<P> family{plane_};
    for (const auto& plane : kPlanes) {
      for (P& p : numbers(plane)) family.push_back(std::move(p));
    }
    for (const auto& [p, u, v] : segments_) {
      const Vector along = minus(at_[v], at_[u]), reach = minus(at_[p], at_[u]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        family.push_back(along[axis]);
        family.push_back(reach[axis]);
        family.push_back(minus(along[axis], reach[axis]));
      }
      for (const auto& plane : kPlanes) family.push_back(turn(along, reach, plane));
    }
    OracleRoot zero{P({Rational(0), Rational(1)}), Rational(0), Rational(0)};
    if (touches(zero)) return zero;
    std::optional<OracleRoot> best;
    for (const P& p : family) {
      for (const OracleRoot& root : roots_of(p, work_)) {
        if (best && !less(root, *best, work_)) break;
        if (!touches(root)) continue;
        best = root;
        break;
      }
    }
    return best;
  }

 private:
  // Cramer's rule in a plane: the determinant, the two numerators, and the determinant minus each
  // (for a triangle, minus their sum).
  std::vector<P> numbers(std::pair<std::size_t, std::size_t> plane) const {
    const P whole = turn(first_, second_, plane), a = turn(offset_, second_, plane);
    if (kind_ == ContactKind::kVertexFace) {
      const P b = turn(first_, offset_, plane);
      return {whole, a, b, minus(minus(whole, a), b)};
    }
    const P b = turn(offset_, first_, plane);
    return {whole, a, b, minus(whole, a), minus(whole, b)};
  }

  bool touches(const OracleRoot& t) {
    if (sign_of(plane_, t, work_) != 0) return false;
    for (const auto& plane : kPlanes) {
      const std::vector<P> n = numbers(plane);
      const int whole = sign_of(n[0], t, work_);
      if (whole == 0) continue;
      return std::all_of(n.begin() + 1, n.end(),
                         [&](const P& p) { return sign_of(p, t, work_) * whole >= 0; });
    }
    return std::any_of(segments_.begin(), segments_.end(),
                       [&](const auto& s) { return on_segment(s, t); });
  }

  bool on_segment(const std::array<std::size_t, 3>& s, const OracleRoot& t) {
    const Vector along = minus(at_[s[2]], at_[s[1]]), reach = minus(at_[s[0]], at_[s[1]]);
    const auto zero = [&](const P& p) { return sign_of(p, t, work_) == 0; };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int forward = sign_of(along[axis], t, work_);
      if (forward == 0) continue;
      if (sign_of(reach[axis], t, work_) * forward < 0) return false;
      if (sign_of(minus(along[axis], reach[axis]), t, work_) * forward < 0) return false;
      return std::all_of(kPlanes.begin(), kPlanes.end(),
                         [&](const auto& plane) { return zero(turn(along, reach, plane)); });
    }
    return std::all_of(reach.begin(), reach.end(), zero);
  }

  ContactKind kind_;
  std::array<Vector, 4> at_;
  Vector first_, second_, offset_;
  P plane_;
  std::vector<std::array<std::size_t, 3>> segments_;  // a point, and the ends of a segment
  SturmWork work_;
};

}  // namespace

std::optional<OracleRoot> oracle_first_contact(ContactKind kind, const Points& points) {
  return Oracle(kind, points).first_contact();
}

}  // namespace kinex::test
