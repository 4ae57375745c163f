// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/collision_pairs.h"

#include <algorithm>
#include <stdexcept>

#include "core/numbers/check.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {

CollisionPairs::CollisionPairs(Kernel& kernel, StructureId id, const Scene& scene, CutPolicy policy)
    : kernel_(kernel),
      id_(id),
      scene_(scene),
      frames_(kernel, scene, policy),
      volumes_(kernel, scene),
      predicates_(kernel),
      pose_(make_pose_2()),
      pairs_of_(scene.objects.size()),
      alive_(scene.objects.size(), 0) {
  if (scene.objects.size() <= 2) return;
  const auto width = BodyGrid::width_for(scene, volumes_.largest_radius());
  if (width) grid_.emplace(kernel, id, *width, scene.objects.size());
}

std::vector<std::string_view> CollisionPairs::collision_kinds(std::vector<std::string_view> own) {
  own.insert(own.begin(),
             {"contact", "graze", "separation", "inside", "volume", "grid", "overlap"});
  return common_event_kinds(std::move(own));
}

void CollisionPairs::build(std::span<const ObjectId> objects) {
  for (const ObjectId object : objects) {
    add_body(object);
    report_overlaps(object);
  }
}

void CollisionPairs::rebuild() {
  for (PairId p = 0; p < pairs_.size(); ++p) {
    if (pairs_[p].a == kNoObject) continue;
    if (!pairs_[p].apart && !pairs_[p].touching) stop(p);
    drop_certificates(p);
    follow_near(p);
  }
}

void CollisionPairs::certificate_failed(CertificateId failed) {
  const std::uint32_t tag = kernel_.tag(failed);
  if ((tag & BodyGrid::kTag) != 0) {
    const ObjectId body = grid_->move_on(tag);
    update_pairs(body);
    kernel_.report(id_, kGrid, {body}, false);
    // In an inexact arithmetic the body may overlap one that was far away.
    for (const PairId p : pairs_of_[body]) {
      if (pairs_[p].touching && std::find(had_.begin(), had_.end(), p) == had_.end()) {
        report_overlap(p);
      }
    }
    return;
  }
  const PairId p = tag / kMostCertificates;
  failed_ = failed;
  if (pairs_[p].touching) {
    fail_in_contact(p, tag % kMostCertificates);
  } else if (pairs_[p].apart) {
    follow_near(p);
    pairs_[p].resting = false;
    report(p, kVolume);
    if (pairs_[p].touching && pairs_[p].certificates > 0) {  // the proof held up to the contact
      report_meeting(p, kContact, features_at(p, pairs_[p].ahead));
    } else if (pairs_[p].touching) {
      report_overlap(p);
    }
  } else if (!only_touches(failed)) {
    if (is_stuck(p)) {
      start_anew(p);
    } else {
      fail(p, tag % kMostCertificates);
    }
  }
  failed_ = kNoCertificate;
  look_for_touch(p);
}

bool CollisionPairs::only_touches(CertificateId failed) {
  const Query query = kernel_.query(failed);
  if (!kernel_.tells_sign_now() || !kernel_.fails_at_touch(query) ||
      kernel_.sign_after(query) == Sign::kNegative) {
    return false;
  }
  kernel_.replace(failed, query, kernel_.tag(failed));
  return true;
}

bool CollisionPairs::holds(PairId p) const {
  const Pair& pair = pairs_[p];
  for (std::uint8_t i = 0; i < pair.certificates; ++i) {
    const Query& query = kernel_.query(pair.certificate[i]);
    if (kernel_.sign_after(query) == Sign::kNegative) return false;
  }
  return true;
}

// After an event of the pair. If its proof does not hold yet, another event follows at this
// instant.
void CollisionPairs::look_for_touch(PairId p) {
  Pair& pair = pairs_[p];
  if (!kernel_.tells_sign_now() || pair.touching || pair.apart) return;
  const std::optional<Features> found = touch(p, When::kNow);
  if (!found && !pair.resting) return;
  if (!holds(p)) return;
  if (found && !pair.resting) {
    const auto ahead = edge_ahead(p, *found);
    report_meeting(p, kGraze, ahead ? features_at(p, *ahead) : *found);
    // This also settles the others that touch zero at this instant.
    for (std::uint8_t i = 0; i < pair.certificates; ++i) {
      const CertificateId id = pair.certificate[i];
      const Query query = kernel_.query(id);
      if (kernel_.fails_at_touch(query) && kernel_.sign(query, When::kNow) == Sign::kZero) {
        kernel_.replace(id, query, kernel_.tag(id));
      }
    }
  }
  pair.resting = found && touch(p, When::kRightAfter);
}

// Doubles cannot decide whether two bodies only touch.
void CollisionPairs::insert(ObjectId object) {
  add_body(object);
  if (kernel_.is_exact() && scene_.overlapping_starts == OverlappingStarts::kRefused) {
    for (const PairId p : pairs_of_[object]) {
      if (!pairs_[p].touching) continue;
      const ObjectId other = pairs_[p].a == object ? pairs_[p].b : pairs_[p].a;
      throw std::invalid_argument(scene_.objects[object].id + " appears at " + kernel_.now_text() +
                                  " in contact with " + scene_.objects[other].id +
                                  "; let it come, or jump, to where it is apart from all others, "
                                  "or say \"overlapping_starts\": \"contact\" (not \"refused\", the "
                                  "default) in the scene");
    }
  }
  report_overlaps(object);
}

// The overlaps of a new body, in the order of the other bodies.
void CollisionPairs::report_overlaps(ObjectId object) {
  std::vector<std::pair<ObjectId, PairId>> found;
  for (const PairId p : pairs_of_[object]) {
    if (pairs_[p].touching) found.emplace_back(pairs_[p].a ^ pairs_[p].b ^ object, p);
  }
  std::sort(found.begin(), found.end());
  for (const auto& [other, p] : found) report_overlap(p);
}

void CollisionPairs::report_overlap(PairId p) {
  kernel_.report(id_, kOverlap, {pairs_[p].a, pairs_[p].b}, true);
}

void CollisionPairs::add_body(ObjectId object) {
  most_bodies_ = std::max(most_bodies_, ++bodies_);
  if (grid_) {
    alive_[object] = 1;
    grid_->insert(object);
    update_pairs(object);
    return;
  }
  for (ObjectId other = 0; other < alive_.size(); ++other) {
    if (alive_[other] == 0) continue;
    follow(add_pair(std::min(object, other), std::max(object, other)));
  }
  alive_[object] = 1;
}

void CollisionPairs::erase(ObjectId object) {
  alive_[object] = 0;
  --bodies_;
  if (grid_) grid_->erase(object);
  const std::vector<PairId> gone = pairs_of_[object];
  for (const PairId p : gone) remove_pair(p);
}

void CollisionPairs::update_pairs(ObjectId body) {
  had_ = pairs_of_[body];
  for (const PairId p : had_) {
    if (!pairs_[p].touching && !grid_->are_near(pairs_[p].a, pairs_[p].b)) remove_pair(p);
  }
  had_.erase(
      std::remove_if(had_.begin(), had_.end(), [this](PairId p) { return !pairs_[p].touching; }),
      had_.end());
  for (const ObjectId other : grid_->near(body)) {
    const ObjectId a = std::min(body, other), b = std::max(body, other);
    if (find_pair(a, b) == kNoPair) follow_near(add_pair(a, b));
  }
}

PairId CollisionPairs::find_pair(ObjectId a, ObjectId b) const {
  for (const PairId p : pairs_of_[a]) {
    if (pairs_[p].a == a && pairs_[p].b == b) return p;
  }
  return kNoPair;
}

bool CollisionPairs::in_contact(ObjectId a, ObjectId b) const {
  const PairId p = find_pair(std::min(a, b), std::max(a, b));
  return p != kNoPair && pairs_[p].touching;
}

void CollisionPairs::motions_changed(std::span<const ObjectId> objects) {
  std::vector<PairId> changed;
  for (const ObjectId object : objects) {
    changed.insert(changed.end(), pairs_of_[object].begin(), pairs_of_[object].end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const PairId p : changed) {
    if (pairs_[p].touching) {
      move_in_contact(p);
    } else if (!pairs_[p].apart) {
      moved(p);
    }
    look_for_touch(p);
  }
}

// By a volume if one is a proof, else by the derived class's proof.
void CollisionPairs::follow_near(PairId p) {
  if (grid_) {
    if (const auto query = volumes_.proof(pairs_[p].a, pairs_[p].b)) {
      pairs_[p].apart = true;
      set_certificates(p, {&*query, 1});
      return;
    }
  }
  follow(p);
}

void CollisionPairs::follow(PairId p) {
  add_pose(p);
  pairs_[p].apart = false;
  pairs_[p].touching = !start(p);
  if (pairs_[p].touching) follow_overlap(p, edge_ahead(p, {}));
  pairs_[p].resting = !pairs_[p].touching && touch(p, When::kRightAfter);
}

PairId CollisionPairs::add_pair(ObjectId a, ObjectId b) {
  PairId p = static_cast<PairId>(pairs_.size());
  if (free_.empty()) {
    pairs_.emplace_back();
  } else {
    p = free_.back();
    free_.pop_back();
  }
  pairs_[p].a = a;
  pairs_[p].b = b;
  pairs_[p].touching = pairs_[p].apart = pairs_[p].resting = false;
  pairs_of_[a].push_back(p);
  pairs_of_[b].push_back(p);
  most_pairs_ = std::max(most_pairs_, ++live_pairs_);
  return p;
}

void CollisionPairs::add_pose(PairId p) {
  Pair& pair = pairs_[p];
  if (pair.pose != kNoObject) return;
  const std::array<ObjectId, 2> bases{pair.a, pair.b};
  std::string name = scene_.objects[pair.a].id + "|" + scene_.objects[pair.b].id;
  if (free_poses_.empty()) {
    pair.pose = kernel_.derive(std::move(name), pose_, bases);
  } else {
    pair.pose = free_poses_.back();
    free_poses_.pop_back();
    kernel_.rederive(pair.pose, std::move(name), bases);
  }
}

void CollisionPairs::remove_pair(PairId p) {
  Pair& pair = pairs_[p];
  if (!pair.apart && !pair.touching) stop(p);
  drop_certificates(p);
  for (const ObjectId body : {pair.a, pair.b}) {
    std::vector<PairId>& list = pairs_of_[body];
    list.erase(std::find(list.begin(), list.end(), p));
  }
  if (pair.pose != kNoObject) free_poses_.push_back(pair.pose);
  pair = Pair{};
  free_.push_back(p);
  --live_pairs_;
}

void CollisionPairs::drop_certificates(PairId p) {
  Pair& pair = pairs_[p];
  for (std::uint8_t i = 0; i < pair.certificates; ++i) kernel_.retract(pair.certificate[i]);
  pair.certificates = 0;
}

void CollisionPairs::set_certificates(PairId p, std::span<const Query> queries) {
  require(queries.size() <= kMostCertificates, "a proof has too many certificates");
  Pair& pair = pairs_[p];
  most_of_pair_ = std::max(most_of_pair_, static_cast<std::uint32_t>(queries.size()));
  const std::array<CertificateId, kMostCertificates> old = pair.certificate;
  const std::uint32_t before = pair.certificates;
  std::uint32_t used = 0;  // bit i: old certificate i stays or is replaced
  std::array<CertificateId, kMostCertificates> now{};
  now.fill(kNoCertificate);
  const auto tag = [p](std::size_t slot) {
    return p * kMostCertificates + static_cast<std::uint32_t>(slot);
  };
  for (std::size_t slot = 0; slot < queries.size(); ++slot) {
    for (std::uint32_t i = 0; i < before; ++i) {
      // The failed one has left the queue: if its query is needed again, a new one is made.
      if ((used >> i & 1) != 0 || old[i] == failed_) continue;
      if (!kernel_.claims(old[i], queries[slot])) continue;
      used |= 1u << i;
      now[slot] = old[i];
      kernel_.set_tag(old[i], tag(slot));
      break;
    }
  }
  std::uint32_t next = 0;
  for (std::size_t slot = 0; slot < queries.size(); ++slot) {
    if (now[slot] != kNoCertificate) continue;
    while (next < before && (used >> next & 1) != 0) ++next;
    if (next < before) {
      used |= 1u << next;
      now[slot] = old[next];
      kernel_.replace(old[next], queries[slot], tag(slot));
    } else {
      now[slot] = kernel_.create(id_, queries[slot], tag(slot)).id;
    }
  }
  for (std::uint32_t i = 0; i < before; ++i) {
    if ((used >> i & 1) == 0) kernel_.retract(old[i]);
  }
  pair.certificate = now;
  pair.certificates = static_cast<std::uint8_t>(queries.size());
}

// The place of the feature in the scene's list of vertices; a frame's list begins elsewhere.
ObjectId CollisionPairs::feature_object(ObjectId body, bool negated, Feature feature) {
  if (features_.empty()) features_.resize(scene_.objects.size());
  std::vector<ObjectId>& of_body = features_[body];
  if (of_body.empty()) of_body.resize(4 * scene_.objects[body].polygon.size(), kNoObject);
  ObjectId& known = of_body[4 * feature.i + (negated ? 2u : 0u) + (feature.edge ? 1u : 0u)];
  if (known != kNoObject) return known;
  const std::uint32_t place = frames_.place(body, negated, feature.i);
  const PolygonFeature named{body, feature.edge, place};
  return known = kernel_.feature(feature_name(named), named);
}

void CollisionPairs::report_meeting(PairId p, std::uint8_t kind, const Features& features) {
  const ObjectId a = pairs_[p].a, b = pairs_[p].b;
  kernel_.report(
      id_, kind,
      {a, b, feature_object(a, false, features.of_a), feature_object(b, true, features.of_b)},
      true);
}

Attribute CollisionPairs::attribute() const {
  std::vector<std::pair<ObjectId, ObjectId>> touching;
  for (const Pair& pair : pairs_) {
    if (pair.a != kNoObject && pair.touching) touching.emplace_back(pair.a, pair.b);
  }
  std::sort(touching.begin(), touching.end());
  Attribute attribute;
  attribute.shape = Attribute::Shape::kTuples;
  for (const auto& [a, b] : touching) attribute.ids.insert(attribute.ids.end(), {a, b});
  return attribute;
}

std::vector<BoundCheck> CollisionPairs::bounds(const BoundContext& context) const {
  const std::string own(name());
  const std::uint32_t most = std::max(most_certificates(), OverlapProof::kCertificates);
  return {
      at_most(own + ".pair", "a constant number of certificates for a pair",
              Integer(std::int64_t{most}), Integer(std::int64_t{most_of_pair_})),
      at_most(
          own + ".compactness",
          "a constant number of certificates for a pair that is near, and for a body in the grid",
          Integer(static_cast<std::int64_t>(most_pairs_ * most + (grid_ ? 4 * most_bodies_ : 0))),
          Integer(static_cast<std::int64_t>(context.ledger->max_live)))};
}

void CollisionPairs::check_invariants(AuditReport& report) const {
  for (PairId p = 0; p < pairs_.size(); ++p) {
    const Pair& pair = pairs_[p];
    if (pair.a == kNoObject) continue;
    const std::string who = scene_.objects[pair.a].id + " and " + scene_.objects[pair.b].id;
    report.check(alive_[pair.a] != 0 && alive_[pair.b] != 0,
                 [&] { return "a pair of bodies that are not there: " + who; });
    report.check(pair.certificates > 0 || (pair.touching && !kernel_.is_exact()),
                 [&] { return "a pair without a proof: " + who; });
    for (std::uint32_t i = 0; i < pair.certificates; ++i) {
      report.check(kernel_.tag(pair.certificate[i]) == p * kMostCertificates + i,
                   [&] { return "a certificate with a wrong tag: " + who; });
    }
  }
}

std::size_t CollisionPairs::bytes() const {
  std::size_t total = frames_.bytes() + volumes_.bytes() + (grid_ ? grid_->bytes() : 0) +
                      free_poses_.capacity() * sizeof(ObjectId) + pairs_.capacity() * sizeof(Pair) +
                      free_.capacity() * sizeof(PairId) + alive_.capacity() +
                      pairs_of_.capacity() * sizeof(pairs_of_[0]) +
                      features_.capacity() * sizeof(features_[0]);
  for (const auto& list : features_) total += list.capacity() * sizeof(ObjectId);
  for (const auto& list : pairs_of_) total += list.capacity() * sizeof(PairId);
  return total;
}

}  // namespace kinex
