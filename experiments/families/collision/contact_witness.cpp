// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/collision/contact_witness.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace kinex::families {

namespace {

using Series = std::vector<Rational>;  // a polynomial in t, low degree first

Series operator+(const Series& a, const Series& b) {
  Series sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
  return sum;
}
Series operator*(const Series& a, const Series& b) {
  Series product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}
Series operator*(const Rational& a, Series b) {
  for (Rational& c : b) c *= a;
  return b;
}
Series operator-(const Series& a, const Series& b) { return a + Rational(-1) * b; }

struct MovingPoint {
  Series x, y;
};
MovingPoint operator-(const MovingPoint& a, const MovingPoint& b) { return {a.x - b.x, a.y - b.y}; }

// A body in one flight plan: position, and rotation by (c, s) / n.
struct Frame {
  explicit Frame(const Trajectory& trajectory)
      : x(trajectory.coordinates[0]), y(trajectory.coordinates[1]) {
    const Series& p = trajectory.coordinates[2];
    const Series& q = trajectory.coordinates[3];
    c = p * p - q * q;
    s = Rational(2) * (p * q);
    n = p * p + q * q;
  }
  // n times the place of a point of the frame.
  MovingPoint place(const Vertex2& v) const {
    return {n * x + v[0] * c - v[1] * s, n * y + v[0] * s + v[1] * c};
  }
  Series x, y, c, s, n;
};

struct Candidate {
  RealRoot instant;
  std::optional<FeaturePair> features;  // nullopt: a seam of flight plans
};

// A time in which both bodies keep their flight plans.
struct Span {
  Rational from;
  std::optional<Rational> to;
  const Trajectory* a;
  const Trajectory* b;
};

std::vector<Span> common_spans(const Motion& a, const Motion& b, const Rational& start,
                               const std::optional<Rational>& end) {
  std::vector<Span> spans;
  for (const MotionPiece& p : a.pieces) {
    for (const MotionPiece& q : b.pieces) {
      Span span{start, end, &p.trajectory, &q.trajectory};
      for (const MotionPiece* piece : {&p, &q}) {
        if (piece->from) span.from = std::max(span.from, *piece->from);
        if (piece->to && (!span.to || *piece->to < *span.to)) span.to = piece->to;
      }
      if (!span.to || span.from < *span.to) spans.push_back(span);
    }
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& x, const Span& y) { return x.from < y.from; });
  return spans;
}

class SpanSearch {
 public:
  SpanSearch(const SceneObject& a, const SceneObject& b, const Span& span)
      : a_(a), b_(b), span_(span) {}

  std::vector<Candidate> candidates() {
    found_.clear();
    found_.push_back({RealRoot(span_.from), std::nullopt});
    const Frame a(*span_.a), b(*span_.b);
    visit(true, a, a_.polygon, b, b_.polygon);
    visit(false, b, b_.polygon, a, a_.polygon);
    return std::move(found_);
  }

  // A vertex that stays on an edge meets it at every instant.
  void add_staying(RealRoot& instant, std::vector<FeaturePair>& features) {
    for (const Staying& one : staying_) {
      if (sign_at(one.along, instant, counters_) == Sign::kNegative) continue;
      if (sign_at(one.ahead, instant, counters_) == Sign::kNegative) continue;
      features.push_back(one.features);
    }
    std::sort(features.begin(), features.end());
    features.erase(std::unique(features.begin(), features.end()), features.end());
  }

  formats::Contact contact_at(const Rational& t) const {
    return formats::contact_of(formats::placed_polygon(a_.polygon, *span_.a, t),
                      formats::placed_polygon(b_.polygon, *span_.b, t));
  }

 private:
  void visit(bool vertex_of_a, const Frame& v_frame, const formats::Polygon2& vertices, const Frame& e_frame,
             const formats::Polygon2& edges) {
    std::vector<MovingPoint> tips, ends;  // all times n of both frames
    for (const Vertex2& v : vertices) {
      const MovingPoint place = v_frame.place(v);
      tips.push_back({e_frame.n * place.x, e_frame.n * place.y});
    }
    for (const Vertex2& v : edges) {
      const MovingPoint place = e_frame.place(v);
      ends.push_back({v_frame.n * place.x, v_frame.n * place.y});
    }
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const std::size_t next = (k + 1) % edges.size();
      const Vertex2 way{edges[next][0] - edges[k][0], edges[next][1] - edges[k][1]};
      const MovingPoint direction{way[0] * e_frame.c - way[1] * e_frame.s,
                            way[0] * e_frame.s + way[1] * e_frame.c};
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        look_at({vertex_of_a, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)},
                direction, tips[i] - ends[k], ends[next] - tips[i]);
      }
    }
  }

  // from_first: the vector from the edge's first end to the vertex; to_second: from there to its
  // other end.
  void look_at(const FeaturePair& features, const MovingPoint& direction, const MovingPoint& from_first,
               const MovingPoint& to_second) {
    const Polynomial side =
        Polynomial::from_rationals(direction.x * from_first.y - direction.y * from_first.x);
    const Polynomial along =
        Polynomial::from_rationals(direction.x * from_first.x + direction.y * from_first.y);
    const Polynomial ahead =
        Polynomial::from_rationals(direction.x * to_second.x + direction.y * to_second.y);
    if (!side.is_zero()) {
      add_roots(side, along, ahead, features);
      return;
    }
    staying_.push_back({along, ahead, features});
    // The vertex stays on the line: it can only enter the edge at its ends, or be on it already.
    add(RealRoot(span_.from), along, ahead, features);
    if (!along.is_zero()) add_roots(along, along, ahead, features);
    if (!ahead.is_zero()) add_roots(ahead, along, ahead, features);
  }

  void add_roots(const Polynomial& p, const Polynomial& along, const Polynomial& ahead,
                 const FeaturePair& features) {
    if (p.degree() < 1) return;
    for (RootWithMultiplicity& zero : isolate_real_roots(p, counters_)) {
      if (compare(zero.root, span_.from, counters_) < 0) continue;
      if (span_.to && compare(zero.root, *span_.to, counters_) > 0) continue;
      add(std::move(zero.root), along, ahead, features);
    }
  }

  void add(RealRoot instant, const Polynomial& along, const Polynomial& ahead,
           const FeaturePair& features) {
    if (sign_at(along, instant, counters_) == Sign::kNegative) return;
    if (sign_at(ahead, instant, counters_) == Sign::kNegative) return;
    found_.push_back({std::move(instant), features});
  }

  struct Staying {  // a vertex that stays on the line of an edge
    Polynomial along, ahead;
    FeaturePair features;
  };
  const SceneObject& a_;
  const SceneObject& b_;
  const Span& span_;
  std::vector<Candidate> found_;
  std::vector<Staying> staying_;
  RootCounters counters_;
};

// Candidates of one instant.
struct Moment {
  RealRoot instant;
  std::vector<FeaturePair> features;
};

std::vector<Moment> in_order(std::vector<Candidate> candidates, RootCounters& counters) {
  std::vector<std::size_t> order(candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    if (i == j) return false;
    return compare(candidates[i].instant, candidates[j].instant, counters) < 0;
  });
  std::vector<Moment> moments;
  for (const std::size_t i : order) {
    Candidate& candidate = candidates[i];
    if (moments.empty() || compare(moments.back().instant, candidate.instant, counters) != 0) {
      moments.push_back({candidate.instant, {}});
    }
    if (candidate.features) moments.back().features.push_back(*candidate.features);
  }
  return moments;
}

// A rational strictly between two instants, before < after.
Rational between(RealRoot& before, RealRoot& after, RootCounters& counters) {
  while (!(before.upper() < after.lower())) {
    before.refine(counters);
    after.refine(counters);
  }
  return (before.upper() + after.lower()) / Rational(2);
}

// Right after an instant until which the bodies have these flight plans.
formats::Contact contact_beyond(const SceneObject& a, const SceneObject& b, const Span& span,
                       const Rational& instant, RootCounters& counters) {
  const Span beyond{instant, std::nullopt, span.a, span.b};
  SpanSearch search(a, b, beyond);
  std::vector<Moment> moments = in_order(search.candidates(), counters);
  if (moments.size() == 1) return search.contact_at(instant + Rational(1));
  return search.contact_at(between(moments[0].instant, moments[1].instant, counters));
}

// The contacts of one pair, from its instants in order.
class Story {
 public:
  void appear() { before_ = formats::Contact::kApart; }
  void add(Moment moment, formats::Contact after) {
    BodyContact contact{std::move(moment.instant), std::move(moment.features), after};
    const bool touches = !contact.features.empty();
    if (after == formats::Contact::kOverlapping) {
      if (before_ != formats::Contact::kOverlapping) result_.contacts.push_back(std::move(contact));
    } else if (before_ == formats::Contact::kOverlapping) {
      result_.separations.push_back(std::move(contact));
    } else if (touches && before_ == formats::Contact::kApart) {
      result_.grazes.push_back(std::move(contact));
    }
    before_ = after;
  }
  CollisionWitness result() { return std::move(result_); }

 private:
  formats::Contact before_ = formats::Contact::kApart;
  CollisionWitness result_;
};

}  // namespace

const BodyContact* CollisionWitness::first() const {
  if (grazes.empty()) return contacts.empty() ? nullptr : &contacts.front();
  if (contacts.empty()) return &grazes.front();
  RealRoot graze = grazes.front().instant, contact = contacts.front().instant;
  RootCounters counters;
  return compare(graze, contact, counters) < 0 ? &grazes.front() : &contacts.front();
}

CollisionWitness find_contacts(const SceneObject& a, const SceneObject& b, const Rational& start,
                               const std::optional<Rational>& end) {
  Story story;
  RootCounters counters;
  std::optional<Rational> reached;
  for (const Span& span : common_spans(a.motion, b.motion, start, end)) {
    if (reached != span.from) story.appear();  // one of them has just appeared
    reached = span.to;
    SpanSearch search(a, b, span);
    std::vector<Moment> moments = in_order(search.candidates(), counters);
    std::optional<RealRoot> last;
    if (span.to) last.emplace(*span.to);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      Moment& moment = moments[i];
      search.add_staying(moment.instant, moment.features);
      if (last && compare(moment.instant, *last, counters) == 0) {
        // Decided by the next flight plans, if there are any.
        const bool is_last = !end || *span.to == *end;
        if (is_last) {
          const formats::Contact after = contact_beyond(a, b, span, *span.to, counters);
          story.add(std::move(moment), after);
        }
        break;
      }
      RealRoot* next = i + 1 < moments.size() ? &moments[i + 1].instant : last ? &*last : nullptr;
      const Rational later =
          next ? between(moment.instant, *next, counters) : moment.instant.upper() + Rational(1);
      story.add(std::move(moment), search.contact_at(later));
    }
  }
  return story.result();
}

}  // namespace kinex::families
