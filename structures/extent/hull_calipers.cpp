// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/hull_calipers.h"

#include "structures/hull/hull_events.h"
#include "structures/parts/binomial.h"

namespace kinex {
namespace {

std::uint64_t events_of(const StructureLedger& ledger, const std::string& kind) {
  const auto found = ledger.by_kind.find(kind);
  return found == ledger.by_kind.end() ? 0 : found->second;
}

}  // namespace

HullCalipers::HullCalipers(Kernel& kernel, StructureId owner, int folds, const HullSource& hull,
                           StructureId hull_id)
    : kernel_(&kernel), hull_id_(hull_id), hull_(&hull), calipers_(kernel, owner, folds) {}

void HullCalipers::build() {
  calipers_.build(hull_->ring());
  is_behind_ = false;
}

void HullCalipers::rebuild() {
  calipers_.clear();
  build();
}

// The hull may have changes at this instant that it has not made or not reported yet; until then
// certificates of the old ring may contradict each other.
bool HullCalipers::may_swap() {
  if (instant_ != kernel_->instant_number()) swaps_ = 0;
  instant_ = kernel_->instant_number();
  return !is_behind_ && !kernel_->instant_is_shared(hull_id_) && !hull_->is_settling() &&
         ++swaps_ <= 8 + 2 * calipers_.ring().size();
}

HullCalipers::Failure HullCalipers::failed(CertificateId failed) {
  const bool swaps = may_swap();
  const HullRing& ring = calipers_.ring();
  const auto [e, f, turn] = swaps ? calipers_.failed(failed) : calipers_.dropped(failed);
  is_behind_ = is_behind_ || !swaps;
  const bool parallel = 2 * turn == calipers_.folds();
  return {parallel ? kAntiparallel : kPerpendicular, {e, ring.next(e), f, ring.next(f)}, swaps};
}

// The list follows a vertex that comes or goes alone, on the edge between its neighbours; after
// anything else that happens to the hull at an instant it is built anew.
HullCalipers::HullChange HullCalipers::watched_changed(const Event* event) {
  const bool first = hull_instant_ != kernel_->instant_number();
  hull_instant_ = kernel_->instant_number();
  HullChange change{kRenew, {kNoObject, kNoObject, kNoObject}};
  const bool jumps = hull_->fineness() != 0;
  if (first && event != nullptr && !jumps && !is_behind_ && follow(*event, change)) return change;
  build();
  return {kRenew, {kNoObject, kNoObject, kNoObject}};
}

// Makes the change of the hull that the event states; false if it is not one of a single vertex, or
// contradicts what is there.
bool HullCalipers::follow(const Event& event, HullChange& change) {
  const ObjectId vertex = event.ids[0];
  const HullRing &ring = calipers_.ring(), &hull = hull_->ring();
  if (event.kind == HullEvents::kEnter && event.count == 3) {
    if (hull.size() != ring.size() + 1 || !hull.has(vertex)) return false;
    change = {kSplit, {vertex, event.ids[1], event.ids[2]}};
    return calipers_.enter(vertex, event.ids[1], event.ids[2]);
  }
  if (event.kind != HullEvents::kLeave || !ring.has(vertex)) return false;
  if (hull.size() + 1 != ring.size() || hull.has(vertex)) return false;
  change = {kMerge, {vertex, ring.previous(vertex), ring.next(vertex)}};
  return calipers_.leave(vertex);
}

bool HullCalipers::settled() {
  if (!is_behind_) return false;
  build();
  return true;
}

// Two edges have one polynomial of degree 2d for each kind of event, and every root of it is one
// event at most. Four points are three pairs of disjoint edges, three points three pairs of edges
// that share a vertex; these are antiparallel only where all points are on one line.
void HullCalipers::add_bounds(const std::string& name, const BoundContext& context,
                              std::vector<BoundCheck>& checks) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer n = counted(context.objects()), degree(context.degree);
  checks.push_back(at_most(name + ".calipers", "one for each two directions that are neighbours", n,
                           counted(calipers_.slots().line().max_live)));
  if (!context.plain() || ledger.rebuilds != 0 || !kernel_->is_exact()) return;
  const Integer roots = Integer(6) * degree * (binomial(n, 4) + binomial(n, 3));
  const std::string reason = "2d roots for each two edges: 6d (C(n,4) + C(n,3))";
  for (const char* kind : {"antiparallel", "perpendicular"}) {
    checks.push_back(at_most(name + "." + kind, reason, roots, counted(events_of(ledger, kind))));
    if (calipers_.folds() == 2) break;
  }
}

void HullCalipers::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "caliper";
  for (const ObjectId edge : calipers_.list()) {
    if (calipers_.certificate(edge) == kNoCertificate) continue;
    group.about = {edge, calipers_.ring().next(edge)};
    visitor.group(group);
    visitor.certificate(calipers_.certificate(edge), "its direction, and the next one's");
  }
}

void HullCalipers::check(AuditReport& report) const {
  report.check(calipers_.ring().cycle() == hull_->ring().cycle(),
               [] { return "it has missed a change of the hull"; });
  calipers_.check(report);
}

}  // namespace kinex
