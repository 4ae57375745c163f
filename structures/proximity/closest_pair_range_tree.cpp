// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/proximity/closest_pair_range_tree.h"

#include <algorithm>

#include "structures/parts/tournament_proof.h"
#include "structures/proximity/static_closest_pair_audit.h"

namespace kinex {
namespace {

// An octant by three orders, each along an axis or against it.
struct Octant {
  OctantAxis alpha, beta, projection;
  bool against_alpha, against_beta, against_projection;
};

// One of each two opposite octants.
constexpr Octant kOctants[] = {
    {kAlongY, kAlongDifference, kAlongX, false, false, false},  // 0 < y < x, by x
    {kAlongX, kAlongDifference, kAlongY, false, true, false},   // 0 < x < y, by y
    {kAlongX, kAlongSum, kAlongY, true, false, false},          // 0 < -x < y, by y
    {kAlongY, kAlongSum, kAlongX, false, true, true},           // 0 < y < -x, by -x
};

}  // namespace

ClosestPairRangeTree::ClosestPairRangeTree(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel),
      id_(id),
      pairs_(kernel, id, "pairs", PairDistances(kernel, 2)),
      events_(kernel, id, Attribute::Shape::kTuples) {
  const std::size_t objects = scene.objects.size();
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_.emplace_back(kernel, id, octant_axis_name(static_cast<OctantAxis>(axis)),
                        TurnedOrder(kernel, octant_axis(static_cast<OctantAxis>(axis))), objects);
    places_[axis].assign(objects, 0);
  }
  for (const Octant& octant : kOctants) {
    octants_.emplace_back(PlacesAlong(places_[octant.alpha], octant.against_alpha),
                          PlacesAlong(places_[octant.beta], octant.against_beta),
                          PlacesAlong(places_[octant.projection], octant.against_projection),
                          objects, [this](const Pair& pair, int change) { offer(pair, change); });
  }
}

std::vector<ObjectId> ClosestPairRangeTree::closest() const {
  const Pair* front = pairs_.front();
  if (front == nullptr) return {};
  return {(*front)[0], (*front)[1]};
}

// ---- the offers

void ClosestPairRangeTree::offer(const Pair& pair, int change) {
  int& count = offers_[pair];
  count += change;
  if (count == 0) {
    offers_.erase(pair);
    pairs_.go(pair);
  } else if (change > 0 && count == 1) {
    pairs_.come(pair);
  }
}

void ClosestPairRangeTree::count_places() {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    std::uint32_t place = 0;
    for (const ObjectId object : lists_[axis].items()) places_[axis][object] = place++;
  }
}

void ClosestPairRangeTree::make_trees() {
  count_places();
  const std::vector<ObjectId> points = lists_[kAlongX].items();
  for (OctantPairs& octant : octants_) octant.build(points);
}

// Two neighbours of a list have changed places.
void ClosestPairRangeTree::exchange(std::size_t axis, ObjectId before, ObjectId after) {
  std::swap(places_[axis][before], places_[axis][after]);
  for (std::size_t i = 0; i < octants_.size(); ++i) {
    if (kOctants[i].alpha == axis) octants_[i].alpha_changed(before, after);
    if (kOctants[i].beta == axis) octants_[i].beta_changed(before, after);
    if (kOctants[i].projection == axis) octants_[i].projection_changed(before, after);
  }
}

// ---- calls

void ClosestPairRangeTree::begin() {
  make_trees();
  pairs_.apply(tied());
  events_.begin(closest());
}

void ClosestPairRangeTree::build(std::span<const ObjectId> objects) {
  for (List& list : lists_) list.build({objects.begin(), objects.end()}, [](Item, Item) {});
  begin();
}

void ClosestPairRangeTree::rebuild() {
  const std::vector<ObjectId> objects = lists_[kAlongX].items();
  for (List& list : lists_) list.build(objects, [](Item, Item) {});
  make_trees();
  pairs_.rebuild(tied());
  events_.begin(closest());
}

void ClosestPairRangeTree::insert(ObjectId object) {
  for (List& list : lists_) list.insert(object, [](Item, Item) {});
  begin();
}

void ClosestPairRangeTree::erase(ObjectId object) {
  for (List& list : lists_) list.erase(object, [](Item, Item) {});
  begin();
}

void ClosestPairRangeTree::certificate_failed(CertificateId failed) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    if (!lists_[axis].slots().owns(failed)) continue;
    const auto [before, after] = lists_[axis].failed(failed);
    exchange(axis, before, after);
    pairs_.apply(tied());
    events_.repaired(kOrder, {before, after}, closest());
    lists_[axis].settle(exchanged(axis));
    pairs_.apply(tied());
    if (closest() != events_.told().ids) kernel_->settle_later(id_);
    return;
  }
  const auto [old, fresh] = pairs_.failed(failed, tied());
  events_.repaired(kReplace, {old[0], old[1], fresh[0], fresh[1]}, closest());
}

// Two points that were level by a first key may be so no more, or have become it.
void ClosestPairRangeTree::motions_changed(std::span<const ObjectId> objects) {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].renew(objects, exchanged(axis));
  }
  pairs_.motions_changed(objects, tied());
  pairs_.apply(tied());
}

// ---- checks

void ClosestPairRangeTree::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  std::uint64_t place = std::uint64_t{1} << 32;  // those of the tournament are smaller
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    group.kind = "neighbours";
    group.text = std::string("by ") + octant_axis_name(static_cast<OctantAxis>(axis));
    lists_[axis].each_link([&](Item a, Item b, CertificateId certificate) {
      group.about = {a, b};
      group.place = ++place;
      visitor.group(group);
      visitor.certificate(certificate, "in order");
    });
  }
  visit_tournament(visitor, pairs_, 0, "pairs by distance", [](const Pair& winner) {
    return std::vector<ObjectId>(winner.begin(), winner.end());
  });
}

std::vector<BoundCheck> ClosestPairRangeTree::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::size_t n = context.objects();
  std::size_t depth = 0;
  while ((std::size_t{1} << depth) < n) ++depth;
  const Integer all = kinex::pairs(counted(n));
  const Integer offers = std::min(all, counted(8 * n * depth));
  const Integer lists = counted(n == 0 ? 0 : 4 * (n - 1));
  std::vector<BoundCheck> result{
      at_most("closest_pair_range_tree.certificates",
              "four lists, and a tournament of 8 n ceil(log2 n) offers or all pairs",
              lists + (offers.sign() > 0 ? offers - Integer(1) : Integer(0)),
              counted(ledger.max_live)),
      at_most("closest_pair_range_tree.events",
              "each two points change their order in each list at every root, and where pieces "
              "meet; the epochs of the nodes of the tournament",
              Integer(4) * pair_sign_changes(context.pieces, context.degree) +
                  pairs_.most_failures(2 * context.degree),
              counted(ledger.failures))};
  if (!context.plain() || n < 2) return result;
  const auto orders = ledger.by_kind.find("order");
  result.push_back(at_most("closest_pair_range_tree.order",
                           "each two points change their order in each list at most d times",
                           Integer(4 * context.degree) * all,
                           counted(orders == ledger.by_kind.end() ? 0 : orders->second)));
  result.push_back(at_most("closest_pair_range_tree.external",
                           "pieces of the lower envelope of the distances of all pairs",
                           davenport_schinzel_bound(2 * context.degree, all) - Integer(1),
                           counted(ledger.external)));
  return result;
}

void ClosestPairRangeTree::check_invariants(AuditReport& report) const {
  for (std::size_t axis = 0; axis < kOctantAxes; ++axis) {
    lists_[axis].check(report, octant_axis_name(static_cast<OctantAxis>(axis)));
    std::uint32_t place = 0;
    for (const ObjectId object : lists_[axis].items()) {
      report.check(places_[axis][object] == place++, [] { return "a place that is out of date"; });
    }
  }
  for (const OctantPairs& octant : octants_) octant.check(report);
  std::vector<Pair> offered;
  for (const auto& [pair, count] : offers_) offered.push_back(pair);
  report.check(pairs_.values() == offered, [] { return "pairs that no tree offers"; });
  pairs_.check(report, "pairs");
  report.check(closest() == events_.told().ids, [] { return "a change was not reported"; });
}

void ClosestPairRangeTree::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_closest_pair(snapshot) == closest(),
               [] { return "another pair is the closest"; });
}

std::size_t ClosestPairRangeTree::bytes() const {
  std::size_t total = pairs_.bytes() + events_.bytes() + offers_.size() * (sizeof(Pair) + 56);
  for (const List& list : lists_) total += list.bytes();
  for (const auto& places : places_) total += places.capacity() * sizeof(std::uint32_t);
  for (const OctantPairs& octant : octants_) total += octant.bytes();
  return total;
}

}  // namespace kinex
