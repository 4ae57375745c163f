// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/bounding_box.h"

#include <algorithm>
#include <string>
#include <utility>

#include "structures/extent/static_box_audit.h"
#include "structures/parts/extremum_bounds.h"
#include "structures/parts/tournament_proof.h"

namespace kinex {

BoundingBox::BoundingBox(Kernel& kernel, StructureId id, const Scene& scene)
    : kernel_(&kernel), id_(id), events_(kernel, id, Attribute::Shape::kSequence) {
  for (int axis = 0; axis < scene.dimension; ++axis) {
    Key key;
    key.axis = axis;
    for (const Extremum extremum : {Extremum::kMinimum, Extremum::kMaximum}) {
      const std::string side = extremum == Extremum::kMinimum ? "minimum" : "maximum";
      sides_.emplace_back(kernel, id, side + " of axis " + std::to_string(axis),
                          Contest(extremum, kernel, key, scene), scene.objects.size());
    }
  }
}

void BoundingBox::read() {
  box_.clear();
  for (const auto& side : sides_) {
    if (side.size() > 0) box_.push_back(side.winner());
  }
}

void BoundingBox::certificate_failed(CertificateId failed) {
  auto& side = sides_[kernel_->part(failed)];
  const auto [old, fresh] = side.failed(failed, tied());
  box_[kernel_->part(failed)] = side.winner();
  events_.repaired(kReplace, {old, fresh}, box_);
}

void BoundingBox::visit_proof(ProofVisitor& visitor) const {
  std::uint32_t tree = 0;
  for (const auto& side : sides_) {
    visit_tournament(visitor, side, tree++, side.slots().line().name,
                     [](Item winner) { return std::vector<ObjectId>{winner}; });
  }
}

std::vector<BoundCheck> BoundingBox::bounds(const BoundContext& context) const {
  const StructureLedger& ledger = *context.ledger;
  const Integer sides = counted(sides_.size()), points = counted(context.objects());
  Integer failures(0);
  for (const auto& side : sides_) failures += side.most_failures(context.degree);
  Integer changes = sides * extremum_changes(context, context.pieces, 1, context.degree);
  if (context.plain() && context.degree <= 1) {
    changes = std::min(changes, counted(sides_.size() / 2) * points);
  }
  return {
      at_most("bounding_box.certificates", "each side's tournament has n - 1",
              points.is_zero() ? points : sides * (points - Integer(1)), counted(ledger.max_live)),
      at_most("bounding_box.locality", "a point plays once per level of each tournament",
              sides * counted(tournament_depth(context.objects())), counted(ledger.max_per_object)),
      at_most("bounding_box.events", "the epochs of the nodes of all tournaments",
              std::move(failures), counted(ledger.failures)),
      at_most("bounding_box.external", "pieces of the upper and lower envelope of each axis",
              std::move(changes), counted(ledger.external))};
}

void BoundingBox::check_invariants(AuditReport& report) const {
  report.check(events_.told().ids == box_, [] { return "a change of the box was not reported"; });
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::string& name = sides_[i].slots().line().name;
    sides_[i].check(report, name);
    report.check(box_.empty() ? sides_[i].size() == 0 : box_[i] == sides_[i].winner(),
                 [&] { return "another point is the " + name; });
  }
}

void BoundingBox::audit(const Snapshot& snapshot, AuditReport& report) const {
  report.check(static_box(snapshot) == box_, [] { return "other points are extreme"; });
}

}  // namespace kinex
