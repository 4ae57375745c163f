// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/min_circle_2.h"

#include <algorithm>

#include "predicates/predicates.h"
#include "structures/extent/extent_guarantees_audit.h"
#include "structures/extent/min_circle_audit.h"

namespace kinex {

MinCircle2::MinCircle2(Kernel& kernel, StructureId id, const FarthestDelaunay2& triangulation)
    : kernel_(&kernel),
      id_(id),
      triangulation_(&triangulation),
      acute_(kernel.bind(make_acute_angle_2())),
      obtuse_(kernel.bind(make_obtuse_angle_2())),
      slots_(kernel, id, "angles"),
      events_(kernel, id, Attribute::Shape::kSequence) {}

// ---- the sink

// The angle opposite h is not obtuse, or not acute.
Query MinCircle2::acute(HalfEdge h) const {
  const Triangulation2& t = triangulation_->triangles();
  const ObjectId a = t.origin(h), b = t.target(h);
  return Query(acute_, {std::min(a, b), t.apex(h), std::max(a, b)});
}

Query MinCircle2::obtuse(HalfEdge h) const {
  Query query = acute(h);
  query.predicate = obtuse_;
  return query;
}

// A half-edge of some triangle, near the sink of before.
MinCircle2::HalfEdge MinCircle2::start() const {
  const Triangulation2& t = triangulation_->triangles();
  if (at_ < t.half_edge_capacity()) {
    const Triangle triangle = Triangulation2::triangle(at_);
    if (t.live(triangle) && !t.ghost(triangle)) return at_;
  }
  return t.twin(Triangulation2::next(t.out(t.infinity())));
}

// From triangle to triangle across the side opposite to an obtuse angle. A side that is obtuse from
// both triangles is the sink, so the walk on the dual tree never turns back: it ends in every
// arithmetic, whether the triangulation holds right after now or not.
void MinCircle2::search() {
  const Triangulation2& t = triangulation_->triangles();
  two_ = true;
  circle_ = triangulation_->few();
  around_.clear();
  at_ = t.vertices() == 0 ? Triangulation2::kNone : start();
  if (at_ == Triangulation2::kNone) {
    std::sort(circle_.begin(), circle_.end());
    return certify({});
  }
  HalfEdge from = Triangulation2::kNone;  // the walk came across this side
  for (;;) {
    HalfEdge side = at_;
    int looked = 0;
    while (looked < 3 && (side == from || kernel_->sign_after(acute(side)) != Sign::kNegative)) {
      side = Triangulation2::next(side);
      ++looked;
    }
    if (looked == 3) break;  // no obtuse angle: the triangle is the sink
    at_ = side;
    const HalfEdge beyond = t.twin(side);
    const bool last = t.ghost(Triangulation2::triangle(beyond));
    if (last || kernel_->sign_after(acute(beyond)) == Sign::kNegative) {
      const ObjectId a = t.origin(side), b = t.target(side);
      circle_ = {std::min(a, b), std::max(a, b)};
      around_ = {a, b, t.apex(side)};
      if (!last) around_.push_back(t.apex(beyond));
      std::vector<Query> claims{obtuse(side)};
      if (!last) claims.push_back(obtuse(beyond));
      return certify(claims);
    }
    at_ = from = beyond;
  }
  two_ = false;
  collect();
  const HalfEdge second = Triangulation2::next(at_), third = Triangulation2::previous(at_);
  certify({acute(at_), acute(second), acute(third)});
}

// All vertices that are identically on the circle of the sink's triangle: across ties.
void MinCircle2::collect() {
  const Triangulation2& t = triangulation_->triangles();
  const HalfEdge first = at_;
  circle_ = {t.origin(first), t.target(first), t.apex(first)};
  stack_ = {first, Triangulation2::next(first), Triangulation2::previous(first)};
  while (!stack_.empty()) {
    const HalfEdge h = stack_.back(), beyond = t.twin(h);
    stack_.pop_back();
    if (!triangulation_->is_tie(h)) continue;
    circle_.push_back(t.apex(beyond));
    stack_.push_back(Triangulation2::next(beyond));
    stack_.push_back(Triangulation2::previous(beyond));
  }
  around_ = circle_;
  std::sort(circle_.begin(), circle_.end());
}

// The failed certificate is renewed first, by the same angle if that is among the claims: the
// arithmetic reuses its polynomial. Those that claim the same as before stay.
void MinCircle2::certify(const std::vector<Query>& claims) {
  std::vector<Query> open;
  std::array<bool, 3> stays{};
  for (const Query& claim : claims) {
    bool there = false;
    for (std::size_t i = 0; i < certificates_.size() && !there; ++i) {
      const CertificateId c = certificates_[i];
      there = c != kNoCertificate && c != failing_ && !stays[i] && kernel_->claims(c, claim);
      stays[i] = stays[i] || there;
    }
    if (!there) open.push_back(claim);
  }
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (stays[i] || failing_ == kNoCertificate || certificates_[i] != failing_) continue;
    const Query failed = kernel_->query(failing_);
    const auto same = std::find_if(open.begin(), open.end(),
                                   [&failed](const Query& q) { return q.ids == failed.ids; });
    if (same == open.end()) continue;
    slots_.set(certificates_[i], *same, static_cast<std::uint32_t>(i));
    open.erase(same);
    stays[i] = true;
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    if (stays[i]) continue;
    if (next == open.size()) {
      slots_.drop(certificates_[i]);
    } else {
      slots_.set(certificates_[i], open[next++], static_cast<std::uint32_t>(i));
    }
  }
}

// ---- events

void MinCircle2::rebuild() {
  for (CertificateId& slot : certificates_) slots_.drop(slot);
  begin();
}

void MinCircle2::certificate_failed(CertificateId failed) {
  slots_.failed(failed);
  if (!kernel_->is_exact() && repeats_.failed(kernel_->query(failed))) {
    return kernel_->corrupt(id_, "a certificate fails again and again");
  }
  failing_ = failed;
  search();
  failing_ = kNoCertificate;
  if (triangulation_->instant_may_go_on()) {
    kernel_->settle_later(id_);
    triangulation_->settle_below();
  }
  const std::size_t size = std::min<std::size_t>(circle_.size(), two_ ? 2 : 3);
  const std::uint8_t kind = two_ ? kToTwo : kToThree;
  const StructureId reads = triangulation_->id();
  if (size == 3) {
    events_.repaired(kind, {circle_[0], circle_[1], circle_[2]}, circle_, reads);
  } else if (size == 2) {
    events_.repaired(kind, {circle_[0], circle_[1]}, circle_, reads);
  } else {
    events_.repaired(kind, {}, circle_, reads);
  }
}

// Two or more of an event's points are of the sink, or it is no single flip.
bool MinCircle2::concerns_sink(const Event& event) const {
  if (event.kind != FarthestDelaunay2::kFlip) return true;
  const auto of_sink = [this](ObjectId id) {
    return std::find(around_.begin(), around_.end(), id) != around_.end();
  };
  return std::count_if(event.ids.begin(), event.ids.begin() + event.count, of_sink) > 1;
}

void MinCircle2::watched_changed(const Event* event) {
  if (event == nullptr || concerns_sink(*event)) search();
  if (circle_ != events_.told().ids) kernel_->settle_later(id_);
}

void MinCircle2::instant_over() { events_.over(circle_); }

void MinCircle2::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "circle";
  group.about = circle_;
  visitor.group(group);
  for (const CertificateId c : certificates_) {
    if (c != kNoCertificate) visitor.certificate(c, two_ ? "not acute" : "not obtuse");
  }
}

std::vector<BoundCheck> MinCircle2::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> checks{at_most("min_circle_2.certificates",
                                         "three angles of a triangle, or two at one side",
                                         Integer(3), counted(context.ledger->max_live))};
  // Vertices of a hull of directions jump, and the circle with them.
  if (triangulation_->hull().fineness() == 0) add_circle_bound("min_circle_2", context, checks);
  return checks;
}

void MinCircle2::check_invariants(AuditReport& report) const {
  report.check(circle_ == events_.told().ids,
               [] { return "a change of the circle was not reported"; });
  std::vector<Query> claims;
  if (triangulation_->triangles().vertices() != 0) claims = claims_of_sink(report);
  std::size_t live = 0;
  for (std::size_t i = 0; i < certificates_.size(); ++i) {
    const CertificateId c = certificates_[i];
    if (c == kNoCertificate) continue;
    ++live;
    const Query query = kernel_->query(c);
    report.check(std::find(claims.begin(), claims.end(), query) != claims.end() &&
                     slots_.holds(c, query, static_cast<std::uint32_t>(i)),
                 [] { return "a wrong certificate"; });
  }
  report.check(live == claims.size(), [] { return "a certificate is missing"; });
}

// By the ids of the sink: half-edges may have moved. (Where all points have been on one line for an
// instant the triangulation may be its mirror image, with the same edges.)
std::vector<Query> MinCircle2::claims_of_sink(AuditReport& report) const {
  const Triangulation2& t = triangulation_->triangles();
  const HalfEdge first = t.out(around_.at(0));
  HalfEdge h = first;
  while (t.target(h) != around_.at(1) && t.around(h) != first) h = t.around(h);
  if (t.apex(h) != around_.at(2)) h = t.twin(h);
  report.check((t.target(h) == around_[1] || t.origin(h) == around_[1]) && t.apex(h) == around_[2],
               [] { return "the sink is not in the triangulation"; });
  if (!two_) return {acute(h), acute(Triangulation2::next(h)), acute(Triangulation2::previous(h))};
  const ObjectId beyond = t.apex(t.twin(h));
  report.check(beyond == (around_.size() == 4 ? around_[3] : t.infinity()),
               [] { return "another triangle is at the sink"; });
  if (beyond == t.infinity()) return {obtuse(h)};
  return {obtuse(h), obtuse(t.twin(h))};
}

std::size_t MinCircle2::bytes() const {
  return sizeof *this + events_.bytes() +
         (circle_.capacity() + around_.capacity() + stack_.capacity()) * sizeof(ObjectId);
}

void MinCircle2::audit(const Snapshot& snapshot, AuditReport& report) const {
  const auto circle = [this, &report](const Snapshot& points) {
    audit_min_circle(circle_, points, report);
  };
  audit_reader(triangulation_->hull(), snapshot, report, circle, guarantee_circle);
}

}  // namespace kinex
