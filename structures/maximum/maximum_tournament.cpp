// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/maximum/maximum_tournament.h"

#include <string>

#include "structures/maximum/maximum_bounds.h"

namespace kinex {

MaximumTournament::MaximumTournament(Kernel& kernel, StructureId id, const Key& key,
                                     const Scene& scene, Extremum extremum)
    : MaximumStructure(kernel, id, scene, Contest(extremum, kernel, key, scene),
                       "maximum_tournament", "minimum_tournament", kReplace),
      tournament_(kernel, id, "tournament", contest_, scene.objects.size()) {}

std::vector<std::string_view> MaximumTournament::event_kinds() const {
  return common_event_kinds({"replace", "tie"});
}

void MaximumTournament::build(std::span<const ObjectId> objects) {
  tournament_.build(contest_.order().members(objects), tied());
  events_.begin(winner());
}

void MaximumTournament::rebuild() {
  tournament_.build(tournament_.items(), tied());
  events_.begin(winner());
}

void MaximumTournament::certificate_failed(CertificateId failed) {
  const auto [old, fresh] = tournament_.failed(failed, tied());
  events_.repaired(kReplace, {old, fresh}, winner());
}

void MaximumTournament::motions_changed(std::span<const ObjectId> objects) {
  tournament_.motions_changed(objects, tied());
}

void MaximumTournament::insert(ObjectId object) {
  tournament_.insert(object, tied());
  events_.begin(winner());
}

void MaximumTournament::erase(ObjectId object) {
  contest_.order().check_erasure(object);
  tournament_.erase(object, tied());
  events_.begin(winner());
}

std::vector<BoundCheck> MaximumTournament::bounds(const BoundContext& context) const {
  std::vector<BoundCheck> result = maximum_bounds(name(), contest_.order(), context);
  const std::string own(name());
  if (contest_.order().reference() == kNoObject) {
    const std::size_t n = contest_.order().member_pieces(context).size();
    result.push_back(at_most(own + ".locality",
                             "an object plays at most once per level: ceil(log2 n)",
                             counted(tournament_depth(n)), counted(context.ledger->max_per_object)));
  }
  result.push_back(at_most(own + ".events",
                           "sum over nodes, and their epochs between changes below, of the changes "
                           "of the upper envelope of their leaves, Davenport-Schinzel numbers; "
                           "Guibas 1998, section 5",
                           tournament_.most_failures(contest_.order().degree(context.degree)),
                           counted(context.ledger->failures)));
  return result;
}

void MaximumTournament::check_invariants(AuditReport& report) const {
  check_told(report);
  tournament_.check(report, "the tournament");
}

}  // namespace kinex
