// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/cones_local.h"

#include <algorithm>
#include <string>

#include "structures/parts/merge_sort.h"

namespace kinex {

ConesLocal::ConesLocal(Kernel& kernel, StructureId id, const Scene& scene, const ConeFrame& frame,
                       std::string_view name)
    : ConeNeighbours(kernel, id, frame, scene.objects.size(),
                     [this](std::size_t axis, ObjectId a, ObjectId b) {
                       return in_front(this->kernel(), orders_[axis], a, b);
                     }),
      name_(name),
      slots_(kernel, id, "pointers"),
      certificates_(frame.cones() * scene.objects.size() * kClaims, kNoCertificate),
      is_alone_(frame.woods.size(), false),
      stale_(frame.woods.size(), false) {
  for (const ConeFrame::Vector& direction : frame.axes) orders_.emplace_back(kernel, direction);
}

// ---- certificates

ConesLocal::Claim ConesLocal::claim(std::uint32_t tag) const {
  const std::size_t pointer = tag / kClaims;
  return {pointer / objects(), static_cast<ObjectId>(pointer % objects()), tag % kClaims};
}

std::size_t ConesLocal::order_of(const Claim& c) {
  return (c.cone + 1 + c.which) % SchnyderWood::kColours;  // a wood's first cone is a multiple of 3
}

// "The next point is before this one in the order", or level with it.
Query ConesLocal::query(const Claim& c) const {
  const Compared two = compared(c);
  return two.order->claim(two.before, two.after);
}

ConesLocal::Compared ConesLocal::compared(const Claim& c) const {
  const ObjectId q = next(c.cone, c.point);
  const auto& [axis, reversed] = frame().woods[c.cone / SchnyderWood::kColours][order_of(c)];
  const TurnedOrder* const order = &orders_[axis];
  return reversed ? Compared{order, c.point, q} : Compared{order, q, c.point};
}

// The certificate is that of query(c). Few are by the second key, so the first one is tried first: its
// certificate knows whether the two are identically level.
bool ConesLocal::is_right(const Claim& c) const {
  const CertificateId slot = slot_of(c);
  if (slot == kNoCertificate) return false;
  const auto [order, before, after] = compared(c);
  const Query first = order->by_first_key(before, after);
  if (kernel().claims(slot, first)) return !slots_.is_tie(slot);
  return kernel().claims(slot, order->by_second_key(before, after)) &&
         kernel().sign_after(first) == Sign::kZero;
}

// The claims of a pointer as they are now, in place of what was claimed of it.
void ConesLocal::certify(std::size_t cone, ObjectId p, bool points_elsewhere) {
  for (std::size_t which = 0; which < kClaims; ++which) {
    const Claim c{cone, p, which};
    CertificateId& slot = slot_of(c);
    if (next(cone, p) == kNoObject) {
      slots_.drop(slot);
      continue;
    }
    if (!points_elsewhere && is_right(c)) continue;
    const auto [order, before, after] = compared(c);
    const Outlook outlook = slots_.set(slot, order->by_first_key(before, after), tag(c));
    if (outlook != Outlook::kIdenticallyZero) continue;
    slots_.set(slot, order->by_second_key(before, after), tag(c));
  }
}

// point_elsewhere: than where their certificates say.
void ConesLocal::certify_changed(bool point_elsewhere) {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  for (const auto& [cone, p] : changed_) certify(cone, p, point_elsewhere);
  changed_.clear();
}

void ConesLocal::pointer_changed(std::size_t cone, ObjectId p) {
  changed_.emplace_back(cone, p);
  for (std::size_t which = 0; which < kClaims; ++which) {
    kernel().prefetch(slot_of({cone, p, which}));
  }
}

// ---- the woods

// The pointers of others than the members are none already, or have just become so.
void ConesLocal::make_stale_woods() {
  ConeWoods::Lists points(orders_.size());
  for (std::size_t i = 0; i < stale_.size(); ++i) {
    if (!stale_[i]) continue;
    for (const ConeFrame::Order& order : frame().woods[i]) {
      if (points[order.axis].size() == members_.size()) continue;  // for another wood
      points[order.axis] = members_;
      merge_sort(points[order.axis], [&](ObjectId a, ObjectId b) {
        return in_front(kernel(), orders_[order.axis], a, b);
      });
    }
    woods().make(i, points);
    for (std::size_t colour = 0; colour < SchnyderWood::kColours; ++colour) {
      for (const ObjectId p : members_) {
        changed_.emplace_back(i * SchnyderWood::kColours + colour, p);
      }
    }
  }
  stale_.assign(stale_.size(), false);
  certify_changed(false);
}

void ConesLocal::make_woods() {
  stale_.assign(stale_.size(), true);
  make_stale_woods();
  begin();
}

// ---- calls

void ConesLocal::build(std::span<const ObjectId> objects) {
  members_.assign(objects.begin(), objects.end());
  make_woods();
}

void ConesLocal::rebuild() {
  for (CertificateId& slot : certificates_) slots_.drop(slot);
  make_woods();
}

// All that failed at this instant is repaired: the woods are those right after now.
void ConesLocal::insert(ObjectId object) {
  members_.insert(std::lower_bound(members_.begin(), members_.end(), object), object);
  for (std::size_t i = 0; i < woods().size(); ++i) woods().wood(i).insert(object, members_);
  certify_changed(false);
  follow_point();
}

void ConesLocal::erase(ObjectId object) {
  members_.erase(std::lower_bound(members_.begin(), members_.end(), object));
  for (std::size_t i = 0; i < woods().size(); ++i) {
    if (!woods().wood(i).erase(object)) stale_[i] = true;
  }
  make_stale_woods();
  follow_point();
}

// A claim may be by another key now. One that does not hold right after now fails next, but for two points
// that have become identically equal: nothing tells of their order.
void ConesLocal::motions_changed(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    for (const CertificateId certificate : kernel().certificates_of(object)) {
      if (!slots_.owns(certificate)) continue;
      const Claim c = claim(kernel().tag(certificate));
      changed_.emplace_back(c.cone, c.point);
    }
  }
  const std::vector<std::pair<std::size_t, ObjectId>> moved = changed_;
  certify_changed(false);
  for (const auto& [cone, p] : moved) {
    for (std::size_t which = 0; which < kClaims; ++which) {
      const Claim c{cone, p, which};
      if (!slots_.is_tie(slot_of(c))) continue;
      const auto [order, before, after] = compared(c);
      if (order->goes_first(before, after)) continue;
      stale_[cone / SchnyderWood::kColours] = true;
      kernel().settle_later(id());
    }
  }
}

// What the repair of a failure of two points of a wood reads, where there are many points.
// (An empty asm statement keeps compilers from dropping the call: prefetches are no effect to them.)
void ConesLocal::prefetch_points(std::size_t wood, std::span<const ObjectId> points) const {
  asm volatile("");
  for (const ObjectId p : points) {
    woods().wood(wood).prefetch(p);
    woods().prefetch(p);
    __builtin_prefetch(certificates_.data() + p * frame().cones() * kClaims, 1);
  }
  kernel().prefetch(id(), points);
}

void ConesLocal::prefetch_next() const {
  for (std::size_t i = 0; i < 3; ++i) {
    const CertificateId later = kernel().upcoming(id(), i);
    if (later == kNoCertificate) continue;
    const Query query = kernel().query(later);
    const std::size_t cone = claim(kernel().tag(later)).cone;
    prefetch_points(cone / SchnyderWood::kColours, std::span(query.ids).first(2));
  }
}

// One of a pair that is identically level changes its place by the second key: it is level with whatever
// else changes its place there.
bool ConesLocal::is_independent(const Exchange& one, const Exchange& other) const {
  for (const ObjectId p : {other.before, other.after}) {
    if (p == one.before || p == one.after) return false;
  }
  if (one.order != other.order) return true;
  const TurnedOrder& order = orders_[frame().woods[one.wood][one.order].axis];
  return kernel().tells_sign_now() &&
         kernel().sign(order.by_first_key(one.before, other.before), When::kNow) != Sign::kZero;
}

bool ConesLocal::is_independent(const Exchange& one) const {
  return std::all_of(exchanges_.begin(), exchanges_.end(), [&](const Exchange& other) {
    return other.wood != one.wood || is_independent(one, other);
  });
}

// Failures that are not independent, and two points that meet: some swaps would leave two points ordered
// as no points of the plane can be.
void ConesLocal::certificate_failed(CertificateId failed) {
  const Claim c = claim(slots_.failed(failed));
  const std::size_t i = c.cone / SchnyderWood::kColours;
  const ObjectId p = c.point, q = next(c.cone, p);
  kernel().report(id(), kOrder, {q, p}, false);
  prefetch_next();
  const std::uint64_t instant = kernel().instant_number();
  if (instant != instant_) exchanges_.clear();
  instant_ = instant;
  const Exchange exchange{i, order_of(c), q, p};
  const bool again = std::any_of(exchanges_.begin(), exchanges_.end(),
                                 [&](const Exchange& other) { return other.wood == i; });
  if (again && is_alone_[i]) --alone_;
  is_alone_[i] = false;
  if (stale_[i] || !is_independent(exchange) ||
      woods().wood(i).swap(exchange.order, q, p) != SchnyderWood::Swap::kDone) {
    slots_.drop(slot_of(c));
    stale_[i] = true;
    return kernel().settle_later(id());
  }
  exchanges_.push_back(exchange);
  if (!again) {
    is_alone_[i] = true;
    ++alone_;
  }
  certify_changed(true);  // a swap changes no pointer two times
  repaired();
}

void ConesLocal::instant_settled() {
  remade_ += static_cast<std::uint64_t>(std::count(stale_.begin(), stale_.end(), true));
  make_stale_woods();
}

// ---- checks

// In octants the cones that do not count are quadrants.
std::string_view ConesLocal::kind_of(std::size_t cone) const {
  if (frame().corners == octant_frame().corners) {
    return frame().counts(cone) ? "next in an octant" : "next in a quadrant";
  }
  return frame().counts(cone) ? "next in a cone" : "next in a wide cone";
}

void ConesLocal::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  for (std::size_t cone = 0; cone < frame().cones(); ++cone) {
    for (const ObjectId p : members_) {
      if (next(cone, p) == kNoObject) continue;
      group.kind = kind_of(cone);
      group.about = {p, next(cone, p)};
      group.place = cone * objects() + p;
      visitor.group(group);
      for (std::size_t which = 0; which < kClaims; ++which) {
        const CertificateId slot = slot_of({cone, p, which});
        if (slot != kNoCertificate) visitor.certificate(slot, "in the cone");
      }
    }
  }
}

std::vector<BoundCheck> ConesLocal::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string own(name_);
  std::vector<BoundCheck> result{
      at_most(own + ".certificates", "two for each pointer: a point has three in a wood",
              counted(kClaims * frame().cones() * context.objects()), counted(ledger.max_live)),
      at_most(
          own + ".events",
          "each two points change their order in each of the three orders of each wood at every "
          "root, and where pieces meet",
          counted(frame().cones()) * pair_sign_changes(context.pieces, context.degree),
          counted(ledger.failures)),
      at_most(
          own + ".remade",
          "woods that are made from sorted points at the end of an instant: one for a failure, all "
          "for a new motion",
          counted(ledger.failures) + counted(frame().woods.size()) * counted(ledger.motion_updates),
          counted(remade_))};
  if (has_segments(context)) {
    result.push_back(at_most(own + ".failures",
                             "a failure that is the only one of its wood at its instant changes "
                             "two pointers, each at most "
                             "as often as the lower envelope of n - 1 segments",
                             most_pointer_changes(context) >> 1, counted(alone_)));
  }
  add_bounds(context, result);
  return result;
}

void ConesLocal::check_invariants(AuditReport& report) const {
  report.check(std::find(stale_.begin(), stale_.end(), true) == stale_.end(),
               [] { return "a wood is still to be made"; });
  check_woods(report);
  for (std::uint32_t t = 0; t < certificates_.size(); ++t) {
    const Claim c = claim(t);
    const bool holds = next(c.cone, c.point) == kNoObject ? slot_of(c) == kNoCertificate
                                                          : slots_.holds(slot_of(c), query(c), t);
    report.check(holds, [&] {
      return "a wrong certificate in cone " + std::to_string(c.cone) + " of point " +
             std::to_string(c.point);
    });
  }
}

std::size_t ConesLocal::bytes() const {
  return bytes_of_woods() + members_.capacity() * sizeof(ObjectId) +
         certificates_.capacity() * sizeof(CertificateId) +
         changed_.capacity() * sizeof(changed_[0]);
}

}  // namespace kinex
