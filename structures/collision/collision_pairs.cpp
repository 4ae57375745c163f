// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/collision_pairs.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/numbers/check.h"
#include "core/numbers/show_text.h"
#include "core/numbers/time_text.h"

namespace kinex {

CollisionPairs::CollisionPairs(Kernel& kernel, StructureId id, const Scene& scene,
                               const CollisionMethod& method)
    : kernel_(kernel),
      id_(id),
      scene_(scene),
      method_(method),
      pairs_(kernel, id, scene, method.policy),
      overlap_(kernel, id, "overlap"),
      proof_(method.make(pairs_)),
      alive_(scene.objects.size(), 0) {
  if (scene.objects.size() <= 2) return;
  auto lines = BodyGridLines::over(kernel, scene, pairs_.volumes().largest_radius());
  if (lines) grid_.emplace(kernel, id, std::move(*lines), scene.objects.size());
}

std::vector<std::string_view> CollisionPairs::event_kinds() const {
  std::vector<std::string_view> kinds{"contact", "graze", "separation", "inside",
                                      "volume",  "grid",  "overlap"};
  kinds.insert(kinds.end(), method_.kinds.begin(), method_.kinds.end());
  return common_event_kinds(std::move(kinds));
}

void CollisionPairs::build(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    add_body(object);
    report_overlaps(object);
  }
}

void CollisionPairs::rebuild() {
  for (PairId p = 0; p < pairs_.size(); ++p) {
    if (!pairs_[p].in_use()) continue;
    pairs_.drop(p);
    follow_near(p);
  }
}

// Doubles cannot decide whether two bodies only touch.
void CollisionPairs::insert(ObjectId object) {
  add_body(object);
  if (kernel_.is_exact() && scene_.overlapping_starts == OverlappingStarts::kRefused) {
    for (const PairId p : pairs_.of(object)) {
      if (!pairs_[p].in_contact()) continue;
      const ObjectId other = pairs_[p].a == object ? pairs_[p].b : pairs_[p].a;
      throw std::invalid_argument(
          show_text(scene_.objects[object].id) + " appears at " + time_text(kernel_.now()) +
          " in contact with " + show_text(scene_.objects[other].id) +
          "; let it come, or jump, to where it is apart from all others, "
          "or say \"overlapping_starts\": \"contact\" (not \"refused\", the "
          "default) in the scene");
    }
  }
  report_overlaps(object);
}

void CollisionPairs::erase(ObjectId object) {
  alive_[object] = 0;
  --bodies_;
  if (grid_) grid_->erase(object);
  const std::vector<PairId> gone = pairs_.of(object);
  for (const PairId p : gone) pairs_.remove(p);
}

void CollisionPairs::motions_changed(std::span<const ObjectId> objects) {
  std::vector<PairId> changed;
  for (const ObjectId object : objects) {
    changed.insert(changed.end(), pairs_.of(object).begin(), pairs_.of(object).end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const PairId p : changed) {
    if (pairs_[p].in_contact()) {
      overlap_moved(p);
    } else if (pairs_[p].is_apart()) {
      proof_->moved(p);
    }
    look_for_touch(p);
  }
}

void CollisionPairs::certificate_failed(CertificateId failed) {
  if (grid_ && grid_->owns(failed)) return cell_left(failed);
  const auto asked = [this] {
    return method_.counts_signs ? pairs_.predicates().signs_asked(kernel_) : 0;
  };
  const std::uint64_t before = asked();
  const auto [p, slot] = pairs_.failed(failed);
  if (pairs_[p].in_contact()) {
    overlap_failed(p, slot);
  } else if (pairs_[p].is_apart()) {
    if (!only_touches(p, slot)) proof_failed(p, slot);
  } else {
    volume_failed(p);
  }
  pairs_.handled();
  look_for_touch(p);
  if (method_.counts_signs) proof_->handled(asked() - before);
}

// ---- the broad phase

void CollisionPairs::add_body(ObjectId object) {
  most_bodies_ = std::max(most_bodies_, ++bodies_);
  if (grid_) {
    grid_->insert(object);
    update_pairs(object);
  } else {
    for (ObjectId other = 0; other < alive_.size(); ++other) {
      if (alive_[other] != 0) follow(pairs_.add(object, other));
    }
  }
  alive_[object] = 1;
}

void CollisionPairs::update_pairs(ObjectId body) {
  const std::vector<PairId> before = pairs_.of(body);
  had_.clear();
  for (const PairId p : before) {
    if (pairs_[p].in_contact()) {
      had_.push_back(p);
    } else if (!grid_->are_near(pairs_[p].a, pairs_[p].b)) {
      pairs_.remove(p);
    }
  }
  for (const ObjectId other : grid_->near(body)) {
    if (pairs_.find(body, other) == kNoPair) follow_near(pairs_.add(body, other));
  }
}

void CollisionPairs::cell_left(CertificateId failed) {
  const ObjectId body = grid_->move_on(failed);
  update_pairs(body);
  kernel_.report(id_, CollisionEvent::kGrid, {body}, false);
  // In an inexact arithmetic the body may overlap one that was far away.
  for (const PairId p : pairs_.of(body)) {
    if (pairs_[p].in_contact() && std::find(had_.begin(), had_.end(), p) == had_.end()) {
      report(p, CollisionEvent::kOverlap, true);
    }
  }
}

// By a volume if one is a proof, else by the proof of the structure.
void CollisionPairs::follow_near(PairId p) {
  if (grid_ && pairs_.set_volume(p)) {
    pairs_[p].state = State::kFar;
  } else {
    follow(p);
  }
}

void CollisionPairs::follow(PairId p) {
  pairs_.make_pose(p);
  if (!proof_->start(p, nullptr)) return follow_overlap(p, edge_ahead(p, {}));
  pairs_[p].state = proof_->touch(p, When::kRightAfter) ? State::kResting : State::kApart;
}

void CollisionPairs::volume_failed(PairId p) {
  follow_near(p);
  if (pairs_[p].state == State::kResting) pairs_[p].state = State::kApart;
  report(p, CollisionEvent::kVolume);
  if (pairs_[p].state == State::kOverlap) {  // the proof held up to the contact
    report_meeting(p, CollisionEvent::kContact, features_at(p, pairs_[p].ahead));
  } else if (pairs_[p].in_contact()) {
    report(p, CollisionEvent::kOverlap, true);
  }
}

// ---- two bodies that are apart

bool CollisionPairs::only_touches(PairId p, std::uint32_t slot) {
  const Query query = kernel_.query(pairs_[p].slots[slot]);
  if (!kernel_.tells_sign_now() || !kernel_.fails_at_touch(query) ||
      kernel_.sign_after(query) == Sign::kNegative) {
    return false;
  }
  pairs_.renew(p, slot);
  return true;
}

void CollisionPairs::proof_failed(PairId p, std::uint32_t slot) {
  if (is_stuck(p)) {
    if (!proof_->start(p, nullptr)) return contact(p, {});
    return report(p, CollisionEvent::kFirstOwn);
  }
  const SeparationProof::Repair done = proof_->repair(p, slot);
  if (done.contact) contact(p, *done.contact);
  if (done.event) report(p, *done.event);
}

// A proof that is repaired again and again at one instant cycles: where edges are parallel several
// repairs can undo each other. It is then started anew, which is right just after the instant.
bool CollisionPairs::is_stuck(PairId p) {
  constexpr std::uint32_t kPatience = 64;
  if (!kernel_.is_exact()) return false;
  BodyPair::Repairs& repairs = pairs_[p].repairs;
  const std::uint64_t now = kernel_.instant_is_shared(id_) ? kernel_.instant_number() : 0;
  if (repairs.instant != now || now == 0) repairs = {now, 0};
  if (repairs.count >= kPatience) return true;
  if (now != 0) ++repairs.count;
  return false;
}

// After an event of the pair. If its proof does not hold yet, another event follows at this
// instant.
void CollisionPairs::look_for_touch(PairId p) {
  BodyPair& pair = pairs_[p];
  if (!kernel_.tells_sign_now() || !pair.is_apart()) return;
  const bool was_resting = pair.state == State::kResting;
  const std::optional<Features> found = proof_->touch(p, When::kNow);
  if ((!found && !was_resting) || !pairs_.holds(p)) return;
  if (found && !was_resting) {
    const auto ahead = edge_ahead(p, *found);
    report_meeting(p, CollisionEvent::kGraze, ahead ? features_at(p, *ahead) : *found);
    // This also settles the others that touch zero at this instant.
    for (std::uint32_t i = 0; i < pair.certificates; ++i) {
      const Query query = kernel_.query(pair.slots[i]);
      if (kernel_.fails_at_touch(query) && kernel_.sign(query, When::kNow) == Sign::kZero) {
        pairs_.renew(p, i);
      }
    }
  }
  const bool rests = found && proof_->touch(p, When::kRightAfter);
  pair.state = rests ? State::kResting : State::kApart;
}

void CollisionPairs::contact(PairId p, const Features& near) {
  const auto ahead = edge_ahead(p, near);
  if (kernel_.is_exact() && ahead) {
    const SumBoundary sum = pairs_.boundary(p);
    if (!overlap_proof(sum, p).is_inside(*ahead)) {
      require(proof_->start(p, nullptr),
              "no proof that two bodies are disjoint, which do not overlap");
      return report(p, CollisionEvent::kFirstOwn);
    }
  }
  report_meeting(p, CollisionEvent::kContact, ahead ? features_at(p, *ahead) : near);
  follow_overlap(p, ahead);
}

// ---- reports

void CollisionPairs::report_meeting(PairId p, std::uint8_t kind, const Features& features) {
  kernel_.report(id_, kind,
                 {pairs_[p].a, pairs_[p].b, pairs_.feature_object(p, 0, features.of_a),
                  pairs_.feature_object(p, 1, features.of_b)},
                 true);
}

// The overlaps of a new body, in the order of the other bodies.
void CollisionPairs::report_overlaps(ObjectId object) {
  std::vector<std::pair<ObjectId, PairId>> found;
  for (const PairId p : pairs_.of(object)) {
    if (pairs_[p].in_contact()) found.emplace_back(pairs_[p].a ^ pairs_[p].b ^ object, p);
  }
  std::sort(found.begin(), found.end());
  for (const auto& [other, p] : found) report(p, CollisionEvent::kOverlap, true);
}

bool CollisionPairs::in_contact(ObjectId a, ObjectId b) const {
  const PairId p = pairs_.find(a, b);
  return p != kNoPair && pairs_[p].in_contact();
}

Attribute CollisionPairs::attribute() const {
  std::vector<std::array<ObjectId, 2>> touching;
  for (PairId p = 0; p < pairs_.size(); ++p) {
    if (pairs_[p].in_contact()) touching.push_back({pairs_[p].a, pairs_[p].b});
  }
  std::sort(touching.begin(), touching.end());
  Attribute attribute;
  attribute.shape = Attribute::Shape::kTuples;
  for (const auto& [a, b] : touching) attribute.ids.insert(attribute.ids.end(), {a, b});
  return attribute;
}

// ---- checks

std::vector<BoundCheck> CollisionPairs::bounds(const BoundContext& context) const {
  const std::string own(name());
  const std::uint32_t most = std::max(proof_->most_certificates(), OverlapProof::kCertificates);
  std::vector<BoundCheck> checks{
      at_most(own + ".pair", "a constant number of certificates for a pair", counted(most),
              counted(pairs_.most_certificates())),
      at_most(
          own + ".compactness",
          "a constant number of certificates for a pair that is near, and for a body in the grid",
          counted(pairs_.most_pairs() * most + (grid_ ? 4 * most_bodies_ : 0)),
          counted(context.ledger->max_live))};
  proof_->add_bounds(context, checks);
  return checks;
}

void CollisionPairs::check_invariants(AuditReport& report) const {
  for (PairId p = 0; p < pairs_.size(); ++p) {
    const BodyPair& pair = pairs_[p];
    if (!pair.in_use()) continue;
    const auto fault = [&](const char* what) {
      return [&, what] { return what + pairs_.name(p, 0) + " and " + pairs_.name(p, 1); };
    };
    report.check(alive_[pair.a] != 0 && alive_[pair.b] != 0,
                 fault("a pair of bodies that are not there: "));
    report.check(pair.certificates > 0 || (pair.state == State::kUnproved && !kernel_.is_exact()),
                 fault("a pair without a proof: "));
    report.check(pairs_.check_tags(p), fault("a certificate with a wrong tag: "));
  }
}

std::size_t CollisionPairs::bytes() const {
  return pairs_.bytes() + proof_->bytes() + (grid_ ? grid_->bytes() : 0) + alive_.capacity();
}

}  // namespace kinex
