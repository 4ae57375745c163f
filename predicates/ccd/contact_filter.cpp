// SPDX-License-Identifier: GPL-3.0-or-later
// K(t) with corners q_1 .. q_k, and f = det(q_1, q_2, q_k), are those of contact_exact.cpp.
// Intervals of t are visited from left to right; on each, one of these is proved, or it is cut in
// two:
//   (1) No contact: a direction m has m . q_i > 0 for all i at both ends. Every corner is linear in
//       t, so the same holds in between, and K does not reach the origin. Tried: the axes, and the
//       direction to the point of K's border that is nearest to the origin half-way.
//   (2) No contact: the Bernstein coefficients of f have one strict sign, so f has no root.
//   (3) f has exactly one root: opposite signs at the ends and one sign change along the Bernstein
//       coefficients. The root is enclosed between two close points, where f has opposite signs. f
//       vanishes at every contact, so there is no contact elsewhere. In the small interval there is
//       either (a) no contact, by (1), or (b) a contact at the root.
//       Proof of (b): w . (q_i x q_{i+1}) > 0 for all i throughout, for a constant direction w.
//       Seen along w, the corners then wind round the origin counter-clockwise, each step by less
//       than half a turn, and once, for there are at most four steps:
//
//               q_3 .-------. q_2
//                   |   0   |       w towards the viewer
//               q_4 '-------' q_1
//
//       So the line along w through the origin meets K, and K's plane is not parallel to it. At the
//       root the plane passes through the origin too, so the line meets K in the origin.
// Directions are arbitrary doubles, not rounded values: they carry no error. The ends of intervals
// are multiples of 2^-50 in [0, 1]: t and 1 - t are exact.
#include "predicates/ccd/contact_filter.h"

#include <algorithm>

namespace kinex {

namespace {

// A cubic has three roots, so a few cuts separate them; more are for near misses in one plane.
constexpr int kMaxCuts = 16;
constexpr double kGrid = 0x1p50;         // ends are multiples of 1 / kGrid
constexpr double kFirstCut = 27.0 / 64;  // not where symmetric input has its roots
// Half the width of the interval around a root: at first what the error of f suggests, then more.
constexpr double kLeastHalf = 0x1p-46;
constexpr double kWiden = 32;
constexpr int kWidenings = 4;

using Vector = std::array<Ball, 3>;
using Direction = std::array<double, 3>;

bool positive(const Ball& b) { return b.value > b.error; }
bool negative(const Ball& b) { return -b.value > b.error; }

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Ball dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Ball dot(const Direction& d, const Vector& v) {
  return Ball{d[0], 0} * v[0] + Ball{d[1], 0} * v[1] + Ball{d[2], 0} * v[2];
}

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction middle(const Vector& a, const Vector& b) {
  return {(a[0].value + b[0].value) / 2, (a[1].value + b[1].value) / 2,
          (a[2].value + b[2].value) / 2};
}

// K at one instant.
struct Corners {
  std::array<Vector, 4> q;
};

// K over an interval of time.
struct Piece {
  double lower = 0, upper = 1;
  Corners at_lower, at_upper;
};

class Filter {
 public:
  explicit Filter(const ContactQuery& query)
      : k_(query.kind() == ContactKind::kVertexFace ? 3 : 4),
        start_(corners(query, 0)),
        end_(corners(query, 1)) {}

  ContactVerdict run() const {
    ContactVerdict verdict;
    const Piece all{0, 1, start_, end_};
    const Outcome outcome = look(all, verdict);
    if (outcome == Outcome::kClear) verdict.kind = ContactVerdict::Kind::kNone;
    if (outcome == Outcome::kCut) subdivide(verdict);
    return verdict;
  }

 private:
  enum class Outcome { kClear, kContact, kCut, kStuck };

  // What is proved about contact in the piece; fills the verdict for a contact.
  Outcome look(const Piece& piece, ContactVerdict& verdict) const {
    if (separated(piece)) return Outcome::kClear;
    const std::array<Ball, 4> f = bernstein(piece);
    if (one_sign(f)) return Outcome::kClear;
    if (!one_root(f)) return Outcome::kCut;
    Piece narrow;
    if (!catch_root(piece, f, narrow)) return Outcome::kStuck;
    if (separated(narrow)) return Outcome::kClear;
    if (!goes_round(narrow)) return Outcome::kStuck;
    verdict.kind = ContactVerdict::Kind::kFirst;
    verdict.lower = narrow.lower;
    verdict.upper = narrow.upper;
    return Outcome::kContact;
  }

  // From left to right: everything before `piece` is clear, and `ends` holds where the intervals
  // after it end, the next one on top.
  void subdivide(ContactVerdict& verdict) const {
    std::array<double, kMaxCuts + 1> ends;
    std::size_t size = 1;
    ends[0] = 1;
    Piece piece{0, 1, start_, end_};
    double fraction = kFirstCut;
    for (;;) {
      if (verdict.cuts == kMaxCuts) return;
      ++verdict.cuts;
      const double cut = on_grid(piece.lower + (piece.upper - piece.lower) * fraction);
      fraction = 0.5;
      ends[size++] = cut;
      piece.upper = cut;
      piece.at_upper = at(cut);
      Outcome outcome = look(piece, verdict);
      while (outcome == Outcome::kClear && --size > 0) {
        piece.lower = piece.upper;
        piece.at_lower = piece.at_upper;
        piece.upper = ends[size - 1];
        piece.at_upper = size == 1 ? end_ : at(piece.upper);
        outcome = look(piece, verdict);
      }
      if (size == 0) verdict.kind = ContactVerdict::Kind::kNone;
      if (outcome != Outcome::kCut) return;
    }
  }

  static Vector point(const ContactQuery& query, int time, std::size_t p) {
    const std::size_t i = ContactQuery::index(time, p, 0);
    return {query.rounded(i), query.rounded(i + 1), query.rounded(i + 2)};
  }

  static Corners corners(const ContactQuery& query, int time) {
    const Vector a = point(query, time, 0), b = point(query, time, 1), c = point(query, time, 2),
                 d = point(query, time, 3);
    if (query.kind() == ContactKind::kVertexFace) {
      return {{difference(b, a), difference(c, a), difference(d, a), {}}};
    }
    return {{difference(c, a), difference(d, a), difference(d, b), difference(c, b)}};
  }

  static double on_grid(double t) { return std::floor(t * kGrid) / kGrid; }

  Corners at(double t) const {
    const Ball late{t, 0}, early{1 - t, 0};
    Corners result;
    for (std::size_t i = 0; i < k_; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result.q[i][axis] = early * start_.q[i][axis] + late * end_.q[i][axis];
      }
    }
    return result;
  }

  bool separated(const Piece& piece) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bool above = true, below = true;
      for (std::size_t i = 0; i < k_ && (above || below); ++i) {
        const Ball& a = piece.at_lower.q[i][axis];
        const Ball& b = piece.at_upper.q[i][axis];
        above = above && positive(a) && positive(b);
        below = below && negative(a) && negative(b);
      }
      if (above || below) return true;
    }
    const Direction m = towards_border(piece);
    for (std::size_t i = 0; i < k_; ++i) {
      if (!positive(dot(m, piece.at_lower.q[i])) || !positive(dot(m, piece.at_upper.q[i]))) {
        return false;
      }
    }
    return true;
  }

  // Approximately from the origin to the nearest point of K's border half-way through the interval.
  Direction towards_border(const Piece& piece) const {
    std::array<Direction, 4> q{};
    for (std::size_t i = 0; i < k_; ++i) q[i] = middle(piece.at_lower.q[i], piece.at_upper.q[i]);
    Direction best = q[0];
    double nearest = dot(best, best);
    for (std::size_t i = 0; i < k_; ++i) {
      const Direction& u = q[i];
      const Direction& v = q[i + 1 == k_ ? 0 : i + 1];
      const Direction along{v[0] - u[0], v[1] - u[1], v[2] - u[2]};
      const double length = dot(along, along);
      const double part = length > 0 ? std::clamp(-dot(u, along) / length, 0.0, 1.0) : 0.0;
      Direction c{u[0] + part * along[0], u[1] + part * along[1], u[2] + part * along[2]};
      if (part > 0 && part < 1) {
        // Close to the edge c is a small difference: it is made perpendicular to the edge again.
        const double rest = dot(c, along) / length;
        for (std::size_t axis = 0; axis < 3; ++axis) c[axis] -= rest * along[axis];
      }
      const double distance = dot(c, c);
      if (distance < nearest) {
        nearest = distance;
        best = c;
      }
    }
    return best;
  }

  Ball f_at(const Corners& c) const { return dot(cross(c.q[0], c.q[1]), c.q[k_ - 1]); }

  // The Bernstein coefficients of f on the interval, the inner two times three.
  std::array<Ball, 4> bernstein(const Piece& piece) const {
    const Vector &a0 = piece.at_lower.q[0], &a1 = piece.at_upper.q[0];
    const Vector &b0 = piece.at_lower.q[1], &b1 = piece.at_upper.q[1];
    const Vector &c0 = piece.at_lower.q[k_ - 1], &c1 = piece.at_upper.q[k_ - 1];
    const Vector early = cross(a0, b0), late = cross(a1, b1);
    Vector mixed = cross(a0, b1);
    const Vector other = cross(a1, b0);
    for (std::size_t axis = 0; axis < 3; ++axis) mixed[axis] += other[axis];
    return {dot(early, c0), dot(early, c1) + dot(mixed, c0), dot(mixed, c1) + dot(late, c0),
            dot(late, c1)};
  }

  static bool one_sign(const std::array<Ball, 4>& f) {
    return std::all_of(f.begin(), f.end(), positive) || std::all_of(f.begin(), f.end(), negative);
  }

  // Opposite signs at the ends, and one of the inner coefficients has the sign of its end. There is
  // then one sign change, whatever the sign of the other inner coefficient.
  static bool one_root(const std::array<Ball, 4>& f) {
    if (positive(f[0]) && negative(f[3])) return positive(f[1]) || negative(f[2]);
    if (negative(f[0]) && positive(f[3])) return negative(f[1]) || positive(f[2]);
    return false;
  }

  // Finds a small interval around the only root of f in the piece.
  bool catch_root(const Piece& piece, const std::array<Ball, 4>& f, Piece& narrow) const {
    const auto [place, uncertain] = approximate_root(f);
    const double width = piece.upper - piece.lower, root = piece.lower + width * place;
    const bool rises = negative(f[0]);
    double half = std::max(kLeastHalf, 2 * width * uncertain);
    for (int i = 0; i < kWidenings; ++i, half *= kWiden) {
      narrow.lower = std::max(piece.lower, on_grid(root - half));
      narrow.upper = std::min(piece.upper, on_grid(root + half));
      if (!(narrow.lower < narrow.upper)) return false;  // or NaN
      narrow.at_lower = at(narrow.lower);
      narrow.at_upper = at(narrow.upper);
      const Ball before = f_at(narrow.at_lower), after = f_at(narrow.at_upper);
      if (rises ? negative(before) && positive(after) : positive(before) && negative(after)) {
        return true;
      }
    }
    return false;
  }

  struct Guess {
    double root, error;
  };

  // An approximate root of the cubic in [0, 1]: Newton's method, safeguarded by bisection.
  static Guess approximate_root(const std::array<Ball, 4>& f) {
    const double c0 = f[0].value, c1 = f[1].value - 3 * c0,
                 c2 = f[2].value - 2 * f[1].value + 3 * c0,
                 c3 = f[3].value - f[2].value + f[1].value - c0;
    const double error = f[0].error + f[1].error + f[2].error + f[3].error;
    double low = 0, high = 1, t = c0 / (c0 - f[3].value), slope = 0;
    for (int step = 0; step < 60; ++step) {
      const double value = c0 + t * (c1 + t * (c2 + t * c3));
      slope = c1 + t * (2 * c2 + t * (3 * c3));
      ((value > 0) == (c0 > 0) ? low : high) = t;
      double next = t - value / slope;
      if (!(low < next && next < high)) next = (low + high) / 2;
      const double change = std::fabs(next - t);
      t = next;
      if (change < 0x1p-50) break;
    }
    return {t, error / std::fabs(slope)};
  }

  // Whether the corners wind round the origin, seen along one direction, throughout the piece.
  bool goes_round(const Piece& piece) const {
    std::array<Direction, 3> q;
    const std::array<std::size_t, 3> of{0, 1, k_ - 1};
    for (std::size_t i = 0; i < 3; ++i) {
      q[i] = middle(piece.at_lower.q[of[i]], piece.at_upper.q[of[i]]);
    }
    Direction u, v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      u[axis] = q[1][axis] - q[0][axis];
      v[axis] = q[2][axis] - q[0][axis];
    }
    const Direction w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]};
    for (std::size_t i = 0; i < k_; ++i) {
      const std::size_t j = i + 1 == k_ ? 0 : i + 1;
      const Vector &a0 = piece.at_lower.q[i], &a1 = piece.at_upper.q[i];
      const Vector &b0 = piece.at_lower.q[j], &b1 = piece.at_upper.q[j];
      // The Bernstein coefficients of a quadratic, the inner one doubled.
      if (!positive(dot(w, cross(a0, b0))) || !positive(dot(w, cross(a1, b1))) ||
          !positive(dot(w, cross(a0, b1)) + dot(w, cross(a1, b0)))) {
        return false;
      }
    }
    return true;
  }

  std::size_t k_;
  Corners start_, end_;
};

}  // namespace

ContactVerdict filter_contact(const ContactQuery& query) { return Filter(query).run(); }

}  // namespace kinex
