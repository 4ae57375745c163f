// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/caliper_extremum.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "structures/hull/hull_events.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {
namespace {

CaliperCandidates::Value no_candidate() {
  CaliperCandidates::Value value;
  value.fill(kNoObject);
  return value;
}

}  // namespace

CaliperExtremum::CaliperExtremum(Kernel& kernel, StructureId id, std::string_view name,
                                 CaliperMeasure measure, const HullSource& hull,
                                 StructureId hull_id)
    : kernel_(&kernel),
      id_(id),
      hull_id_(hull_id),
      name_(name),
      measure_(measure),
      hull_(&hull),
      calipers_(kernel, id, folds_of(measure)),
      candidates_(kernel, id, "candidates", CaliperCandidates(kernel, measure)),
      events_(kernel, id,
              measure == CaliperMeasure::kDiameter ? Attribute::Shape::kTuples
                                                   : Attribute::Shape::kSequence) {}

std::vector<ObjectId> CaliperExtremum::best() const {
  const Value* front = candidates_.front();
  if (front == nullptr) {
    const bool equal = measure_ == CaliperMeasure::kDiameter && members_.size() > 1;
    if (!equal) return {};
    return {*members_.begin(), *std::next(members_.begin())};
  }
  return candidates_.claims().shown(calipers_, *front);
}

// The candidates of the edges that have changed.
void CaliperExtremum::follow() {
  for (const ObjectId edge : calipers_.changes()) {
    if (value_of_.size() <= edge) value_of_.resize(std::size_t{edge} + 1, no_candidate());
    const Value fresh = candidates_.claims().of(calipers_, edge).value_or(no_candidate());
    Value& old = value_of_[edge];
    if (old == fresh) continue;
    if (old[0] != kNoObject) candidates_.go(old);
    old = fresh;
  }
  for (const ObjectId edge : calipers_.changes()) {
    if (value_of_[edge][0] != kNoObject) candidates_.come(value_of_[edge]);
  }
  calipers_.forget_changes();
  candidates_.apply(tied());
}

void CaliperExtremum::build_calipers() {
  calipers_.build(hull_->ring());
  behind_ = false;
  follow();
}

void CaliperExtremum::begin() {
  build_calipers();
  events_.begin(best());
}

void CaliperExtremum::rebuild() {
  calipers_.clear();
  build_calipers();
  candidates_.rebuild(tied());
  events_.begin(best());
}

// The hull may have changes at this instant that it has not made or not reported yet; until then
// certificates of the old ring may contradict each other.
bool CaliperExtremum::may_swap() {
  if (instant_ != kernel_->instant_number()) swaps_ = 0;
  instant_ = kernel_->instant_number();
  return !behind_ && !kernel_->instant_is_shared(hull_id_) && !hull_->is_settling() &&
         ++swaps_ <= 8 + 2 * calipers_.ring().size();
}

// Where the hull may still change at this instant, so may the attribute.
void CaliperExtremum::report_repair(Kind kind, std::initializer_list<ObjectId> ids) {
  if (!hull_->is_settling()) return events_.repaired(kind, ids, best(), hull_id_);
  kernel_->report(id_, kind, ids, false);
  kernel_->settle_later(id_);
}

void CaliperExtremum::certificate_failed(CertificateId failed) {
  if (!calipers_.owns(failed)) {
    const auto [old, fresh] = candidates_.failed(failed, tied());
    return report_repair(kReplace, {old[0], old[1], fresh[0], fresh[1]});
  }
  const bool swaps = may_swap();
  const HullRing& ring = calipers_.ring();
  const auto [e, f, turn] = swaps ? calipers_.failed(failed) : calipers_.dropped(failed);
  behind_ = behind_ || !swaps;
  if (swaps) follow();
  const bool parallel = 2 * turn == calipers_.folds();
  report_repair(parallel ? kAntiparallel : kPerpendicular, {e, ring.next(e), f, ring.next(f)});
  if (!swaps) kernel_->settle_later(id_);
}

void CaliperExtremum::motions_changed(std::span<const ObjectId> objects) {
  calipers_.motions_changed(objects);
  follow();
  candidates_.motions_changed(objects, tied());
}

// The calipers follow a vertex that comes or goes alone; after anything else that happens to the
// hull at an instant they are built anew.
void CaliperExtremum::watched_changed(const Event* event) {
  const bool first = hull_instant_ != kernel_->instant_number();
  hull_instant_ = kernel_->instant_number();
  if (!first || event == nullptr || behind_ || !follow(*event)) {
    build_calipers();
    kernel_->report(id_, kRenew, {}, false);
  }
  if (best() != events_.told().ids) kernel_->settle_later(id_);
}

// Makes the change of the hull that the event states; false if it is not one of a single vertex, or
// contradicts what is there.
bool CaliperExtremum::follow(const Event& event) {
  const ObjectId vertex = event.ids[0];
  const HullRing &ring = calipers_.ring(), &hull = hull_->ring();
  if (event.kind == HullEvents::kEnter && event.count == 3) {
    if (hull.size() != ring.size() + 1 || !hull.has(vertex)) return false;
    if (!calipers_.enter(vertex, event.ids[1], event.ids[2])) return false;
    follow();
    kernel_->report(id_, kSplit, {vertex, event.ids[1], event.ids[2]}, false);
    return true;
  }
  if (event.kind != HullEvents::kLeave || !ring.has(vertex)) return false;
  if (hull.size() + 1 != ring.size() || hull.has(vertex)) return false;
  const ObjectId from = ring.previous(vertex), to = ring.next(vertex);
  if (!calipers_.leave(vertex)) return false;
  follow();
  kernel_->report(id_, kMerge, {vertex, from, to}, false);
  return true;
}

void CaliperExtremum::instant_settled() {
  if (!behind_) return;
  build_calipers();
  kernel_->report(id_, kRenew, {}, false);
}

void CaliperExtremum::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "caliper";
  for (const ObjectId edge : calipers_.list()) {
    if (calipers_.certificate(edge) == kNoCertificate) continue;
    group.about = {edge, calipers_.ring().next(edge)};
    visitor.group(group);
    visitor.certificate(calipers_.certificate(edge), "its direction, and the next one's");
  }
  visit_tournament(visitor, candidates_, 0, "candidates", [this](const Value& winner) {
    return std::vector<ObjectId>(
        winner.begin(), winner.begin() + static_cast<std::ptrdiff_t>(candidates_.claims().size()));
  });
}

std::vector<BoundCheck> CaliperExtremum::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const std::string name(name_);
  const std::size_t n = context.objects();
  const CaliperCandidates& claims = candidates_.claims();
  std::vector<BoundCheck> result{
      at_most(name + ".calipers", "one for each two directions that are neighbours", counted(n),
              counted(calipers_.slots().line().max_live)),
      at_most(name + ".certificates", "and a tournament of the edges",
              counted(n < 2 ? 0 : 2 * n - 1), counted(ledger.max_live)),
      at_most(name + ".duels", "the epochs of the nodes of the tournament",
              candidates_.most_failures(claims.degree(context.degree)),
              counted(candidates_.slots().line().failures))};
  if (context.plain() && n > 1 && measure_ == CaliperMeasure::kDiameter) {
    const Integer envelope = davenport_schinzel_bound(2 * context.degree, kinex::pairs(counted(n)));
    result.push_back(at_most(name + ".external",
                             "pieces of the upper envelope of the distances of all pairs",
                             envelope - Integer(1), counted(ledger.external)));
  }
  return result;
}

void CaliperExtremum::check_invariants(AuditReport& report) const {
  report.check(calipers_.ring().cycle() == hull_->ring().cycle(),
               [] { return "it has missed a change of the hull"; });
  calipers_.check(report);
  candidates_.check(report, "candidates");
  std::vector<Value> expected;
  for (const ObjectId edge : calipers_.ring().cycle()) {
    const auto value = candidates_.claims().of(calipers_, edge);
    if (value) expected.push_back(*value);
  }
  std::sort(expected.begin(), expected.end());
  report.check(candidates_.values() == expected, [] { return "the candidates are others"; });
  report.check(best() == events_.told().ids, [] { return "a change was not reported"; });
}

std::size_t CaliperExtremum::bytes() const {
  return calipers_.bytes() + candidates_.bytes() + members_.size() * 40 +
         value_of_.capacity() * sizeof(Value) + events_.bytes();
}

}  // namespace kinex
