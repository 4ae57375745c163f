// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/caliper_extremum.h"

#include <algorithm>
#include <iterator>
#include <string>

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
                                 StructureId hull_id, const Calipers2* shared)
    : kernel_(&kernel),
      id_(id),
      hull_id_(hull_id),
      name_(name),
      measure_(measure),
      hull_(&hull),
      own_(shared == nullptr
               ? std::make_optional<HullCalipers>(kernel, id, folds_of(measure), hull, hull_id)
               : std::nullopt),
      shared_(shared),
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
  return candidates_.claims().shown(calipers(), *front);
}

// The candidates of the edges that have changed since it last followed.
void CaliperExtremum::follow() {
  const auto changed = calipers().changes_since(followed_);
  followed_ = calipers().changes_end();
  if (changed) {
    follow(*changed);
  } else {
    std::vector<ObjectId> all = calipers().ring().cycle();
    for (ObjectId edge = 0; edge < value_of_.size(); ++edge) all.push_back(edge);
    follow(all);
  }
  if (own_) own_->forget_changes();
  candidates_.apply(tied());
}

void CaliperExtremum::follow(std::span<const ObjectId> edges) {
  for (const ObjectId edge : edges) {
    if (value_of_.size() <= edge) value_of_.resize(std::size_t{edge} + 1, no_candidate());
    const Value fresh = candidates_.claims().of(calipers(), edge).value_or(no_candidate());
    Value& old = value_of_[edge];
    if (old == fresh) continue;
    if (old[0] != kNoObject) candidates_.go(old);
    old = fresh;
  }
  for (const ObjectId edge : edges) {
    if (value_of_[edge][0] != kNoObject) candidates_.come(value_of_[edge]);
  }
}

void CaliperExtremum::begin() {
  if (own_) own_->build();
  follow();
  events_.begin(best());
}

void CaliperExtremum::rebuild() {
  if (own_) own_->rebuild();
  follow();
  candidates_.rebuild(tied());
  events_.begin(best());
}

// The hull or the calipers may still change at this instant, and with them the attribute.
bool CaliperExtremum::is_settling() const {
  if (hull_->is_settling()) return true;
  return shared_ != nullptr && (shared_->is_settling() || !is_up_to_date());
}

void CaliperExtremum::report_repair(std::uint8_t kind, std::initializer_list<ObjectId> ids) {
  if (!is_settling()) return events_.repaired(kind, ids, best(), hull_id_);
  kernel_->report(id_, kind, ids, false);
  kernel_->settle_later(id_);
}

void CaliperExtremum::certificate_failed(CertificateId failed) {
  if (!own_ || !own_->owns(failed)) {
    const auto [old, fresh] = candidates_.failed(failed, tied());
    return report_repair(kReplace, {old[0], old[1], fresh[0], fresh[1]});
  }
  const auto [kind, edges, swapped] = own_->failed(failed);
  const auto [a, b, c, d] = edges;
  if (swapped) follow();
  report_repair(kind, {a, b, c, d});
  if (!swapped) kernel_->settle_later(id_);
}

void CaliperExtremum::motions_changed(std::span<const ObjectId> objects) {
  if (own_) own_->motions_changed(objects);
  follow();
  candidates_.motions_changed(objects, tied());
}

void CaliperExtremum::watched_changed(const Event* event) {
  if (own_) {
    const auto [kind, ids] = own_->watched_changed(event);
    follow();
    if (kind == HullCalipers::kRenew) {
      kernel_->report(id_, kind, {}, false);
    } else {
      kernel_->report(id_, kind, {ids[0], ids[1], ids[2]}, false);
    }
  } else {
    follow();
  }
  if (best() != events_.told().ids) kernel_->settle_later(id_);
}

void CaliperExtremum::instant_settled() {
  if (own_) {
    if (!own_->settled()) return;
    follow();
    kernel_->report(id_, HullCalipers::kRenew, {}, false);
  } else if (!is_up_to_date()) {
    follow();
  }
}

void CaliperExtremum::visit_proof(ProofVisitor& visitor) const {
  if (own_) own_->visit_proof(visitor);
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
  std::vector<BoundCheck> result;
  if (own_) own_->add_bounds(name, context, result);
  const std::size_t edges = n < 2 ? 0 : n - 1, calipers = own_ ? n : 0;
  result.push_back(at_most(name + ".certificates",
                           own_ ? "and a tournament of the edges" : "a tournament of the edges",
                           counted(n < 2 ? 0 : calipers + edges), counted(ledger.max_live)));
  result.push_back(at_most(name + ".duels", "the epochs of the nodes of the tournament",
                           candidates_.most_failures(claims.degree(context.degree)),
                           counted(candidates_.slots().line().failures)));
  // Vertices of a hull of directions jump: distances come and go.
  const bool jumps = hull_->fineness() != 0;
  if (context.plain() && n > 1 && measure_ == CaliperMeasure::kDiameter && !jumps) {
    const Integer envelope = davenport_schinzel_bound(2 * context.degree, kinex::pairs(counted(n)));
    result.push_back(at_most(name + ".external",
                             "pieces of the upper envelope of the distances of all pairs",
                             envelope - Integer(1), counted(ledger.external)));
  }
  return result;
}

void CaliperExtremum::check_invariants(AuditReport& report) const {
  if (own_) own_->check(report);
  report.check(is_up_to_date(), [] { return "it has missed a change of the calipers"; });
  candidates_.check(report, "candidates");
  std::vector<Value> expected;
  for (const ObjectId edge : calipers().ring().cycle()) {
    const auto value = candidates_.claims().of(calipers(), edge);
    if (value) expected.push_back(*value);
  }
  std::sort(expected.begin(), expected.end());
  report.check(candidates_.values() == expected, [] { return "the candidates are others"; });
  report.check(best() == events_.told().ids, [] { return "a change was not reported"; });
}

std::size_t CaliperExtremum::bytes() const {
  return (own_ ? own_->bytes() : 0) + candidates_.bytes() + members_.size() * 40 +
         value_of_.capacity() * sizeof(Value) + events_.bytes();
}

}  // namespace kinex
