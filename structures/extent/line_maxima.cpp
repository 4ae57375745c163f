// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/extent/line_maxima.h"

#include <algorithm>
#include <stdexcept>

#include "structures/parts/extremum_bounds.h"

namespace kinex {

LineMaxima::LineMaxima(Kernel& kernel, StructureId structure, const Scene& scene,
                       const std::vector<DirectionVector>& half)
    : DirectionMaxima(2 * half.size()), kernel_(&kernel), slots_(kernel, structure, "directions") {
  if (scene.degree_without_weights() > 1) {
    throw std::invalid_argument("dual hulls need linear motions, not motions of degree " +
                                std::to_string(scene.degree_without_weights()));
  }
  each_direction(half, [&](const Key& key, Extremum extremum) {
    directions_.emplace_back(kernel, scene, key, extremum);
  });
}

bool LineMaxima::level(std::size_t i, ObjectId a, ObjectId b) const {
  return kernel_->sign_after(directions_[i].contest.claim(a, b)) == Sign::kZero;
}

ObjectId LineMaxima::look(std::size_t i) {
  const LineHull& hull = directions_[i].hull;
  const ObjectId winner = hull.empty() ? kNoObject : hull.best();
  expect(i, winner, winner == kNoObject ? kNoObject : hull.next(winner));
  return winner;
}

void LineMaxima::expect(std::size_t i, ObjectId winner, ObjectId next) {
  Direction& direction = directions_[i];
  direction.next = next;
  if (next == kNoObject) return slots_.drop(direction.certificate);
  const Query query = direction.contest.claim(winner, next);
  if (direction.certificate == kNoCertificate || !kernel_->claims(direction.certificate, query)) {
    slots_.set(direction.certificate, query, static_cast<std::uint32_t>(i));
  }
}

ObjectId LineMaxima::built(std::size_t i, std::span<const ObjectId> objects, const Tied&) {
  directions_[i].hull.build({objects.begin(), objects.end()});
  return look(i);
}

ObjectId LineMaxima::rebuilt(std::size_t i, const Tied&) {
  directions_[i].hull.build(directions_[i].hull.members());
  return look(i);
}

DirectionMaxima::Duel LineMaxima::failed(CertificateId certificate, const Tied&) {
  const std::size_t i = slots_.failed(certificate);
  const ObjectId old = winners_[i];
  winners_[i] = directions_[i].next;
  expect(i, winners_[i], directions_[i].hull.next(winners_[i]));
  return {i, old, winners_[i]};
}

ObjectId LineMaxima::inserted(std::size_t i, ObjectId object, const Tied&) {
  directions_[i].hull.insert(object);
  return look(i);
}

ObjectId LineMaxima::erased(std::size_t i, ObjectId object, const Tied&) {
  directions_[i].hull.erase(object);
  return look(i);
}

// If another object is best now, the certificate still claims the old winner: it fails at once, and
// the change is an event like any other.
ObjectId LineMaxima::moved(std::size_t i, std::span<const ObjectId> objects, const Tied& tied) {
  Direction& direction = directions_[i];
  direction.hull.change(objects);
  if (direction.hull.empty()) return kNoObject;
  const ObjectId old = winners_[i], best = direction.hull.best();
  if (best != old && kernel_->sign_after(direction.contest.claim(old, best)) == Sign::kNegative) {
    expect(i, old, best);
    return old;
  }
  look(i);
  if (best != old) tied({i, old, best});
  return best;
}

// ---- bounds, proof, invariants

Integer LineMaxima::most_certificates(const BoundContext& context) const {
  return counted(context.objects() < 2 ? 0 : size());
}

Integer LineMaxima::most_per_object(const BoundContext&) const { return counted(size()); }

// A direction and its opposite: the two chains of the hull of n dual points.
Integer LineMaxima::most_failures(const BoundContext& context) const {
  if (context.plain()) return counted(size() / 2) * counted(context.objects());
  return counted(size()) * extremum_changes(context, context.pieces, 1, 1);
}

void LineMaxima::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "extreme in a direction";
  for (std::size_t i = 0; i < size(); ++i) {
    group.place = i;
    group.about.clear();
    if (winners_[i] != kNoObject) group.about.push_back(winners_[i]);
    visitor.group(group);
    const CertificateId certificate = directions_[i].certificate;
    if (certificate != kNoCertificate) visitor.certificate(certificate, "ahead of the next one");
  }
}

void LineMaxima::check(AuditReport& report) const {
  for (std::size_t i = 0; i < size(); ++i) {
    const Direction& d = directions_[i];
    const auto where = [i] { return " in direction " + std::to_string(i); };
    const std::string complaint = d.hull.complaint();
    report.check(complaint.empty(), [&] { return complaint + where(); });
    if (winners_[i] == kNoObject) {
      report.check(d.hull.empty(), [&] { return "no extreme object" + where(); });
      continue;
    }
    const bool member = d.hull.contains(winners_[i]);
    report.check(member, [&] { return "an extreme object that is not there" + where(); });
    if (!member) continue;
    report.check(d.next == d.hull.next(winners_[i]),
                 [&] { return "another object is the next vertex" + where(); });
    report.check(d.next == kNoObject
                     ? d.certificate == kNoCertificate
                     : slots_.holds(d.certificate, d.contest.claim(winners_[i], d.next),
                                    static_cast<std::uint32_t>(i)),
                 [&] { return "a certificate of something else" + where(); });
  }
}

std::size_t LineMaxima::bytes() const {
  std::size_t sum = winners_.capacity() * sizeof(ObjectId) + size() * sizeof(Direction);
  for (const Direction& direction : directions_) sum += direction.hull.bytes();
  return sum;
}

}  // namespace kinex
