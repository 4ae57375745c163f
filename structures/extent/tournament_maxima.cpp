// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/tournament_maxima.h"

#include <string>

#include "structures/parts/tournament_proof.h"

namespace kinex {

TournamentMaxima::TournamentMaxima(Kernel& kernel, StructureId structure, const Scene& scene,
                                   const std::vector<DirectionVector>& half)
    : DirectionMaxima(2 * half.size()), kernel_(&kernel), structure_(structure) {
  each_direction(half, [&](const Key& key, Extremum extremum) {
    tournaments_.emplace_back(kernel, structure, "direction " + std::to_string(tournaments_.size()),
                              Contest(extremum, kernel, key, scene), scene.objects.size());
  });
}

bool TournamentMaxima::level(std::size_t i, ObjectId a, ObjectId b) const {
  return kernel_->sign_after(tournaments_[i].claims().claim(a, b)) == Sign::kZero;
}

ObjectId TournamentMaxima::built(std::size_t i, std::span<const ObjectId> objects,
                                 const Tied& tied) {
  tournaments_[i].build({objects.begin(), objects.end()}, in(i, tied));
  return tournaments_[i].winner();
}

ObjectId TournamentMaxima::rebuilt(std::size_t i, const Tied& tied) {
  tournaments_[i].build(tournaments_[i].items(), in(i, tied));
  return tournaments_[i].winner();
}

bool TournamentMaxima::owns(CertificateId certificate) const {
  return kernel_->structure_of(certificate) == structure_ && kernel_->part(certificate) < size();
}

DirectionMaxima::Duel TournamentMaxima::failed(CertificateId certificate, const Tied& tied) {
  const std::size_t i = kernel_->part(certificate);
  const auto [old, fresh] = tournaments_[i].failed(certificate, in(i, tied));
  winners_[i] = tournaments_[i].winner();
  return {i, old, fresh};
}

ObjectId TournamentMaxima::inserted(std::size_t i, ObjectId object, const Tied& tied) {
  tournaments_[i].insert(object, in(i, tied));
  return tournaments_[i].winner();
}

ObjectId TournamentMaxima::erased(std::size_t i, ObjectId object, const Tied& tied) {
  tournaments_[i].erase(object, in(i, tied));
  return tournaments_[i].winner();
}

ObjectId TournamentMaxima::moved(std::size_t i, std::span<const ObjectId> objects,
                                 const Tied& tied) {
  tournaments_[i].motions_changed(objects, in(i, tied));
  return tournaments_[i].winner();
}

// ---- bounds, proof, invariants

Integer TournamentMaxima::most_certificates(const BoundContext& context) const {
  const std::size_t n = context.objects();
  return counted(n == 0 ? 0 : size()) * counted(n == 0 ? 0 : n - 1);
}

Integer TournamentMaxima::most_per_object(const BoundContext& context) const {
  return counted(size()) * counted(tournament_depth(context.objects()));
}

Integer TournamentMaxima::most_failures(const BoundContext& context) const {
  Integer sum(0);
  for (const auto& tournament : tournaments_) sum += tournament.most_failures(context.degree);
  return sum;
}

void TournamentMaxima::visit_proof(ProofVisitor& visitor) const {
  std::uint32_t tree = 0;
  for (const auto& tournament : tournaments_) {
    visit_tournament(visitor, tournament, tree++, tournament.slots().line().name,
                     [](Item winner) { return std::vector<ObjectId>{winner}; });
  }
}

void TournamentMaxima::check(AuditReport& report) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const std::string& name = tournaments_[i].slots().line().name;
    tournaments_[i].check(report, name);
    report.check(winners_[i] == tournaments_[i].winner(),
                 [&] { return "another object is extreme in " + name; });
  }
}

std::size_t TournamentMaxima::bytes() const {
  std::size_t sum = winners_.capacity() * sizeof(ObjectId);
  for (const auto& tournament : tournaments_) sum += sizeof tournament + tournament.bytes();
  return sum;
}

}  // namespace kinex
