// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/collision/pair_table.h"

#include <algorithm>
#include <utility>

#include "core/numbers/check.h"
#include "predicates/bodies/pose_2.h"

namespace kinex {

PairTable::PairTable(Kernel& kernel, StructureId id, const Scene& scene, CutPolicy policy)
    : kernel_(kernel),
      id_(id),
      scene_(scene),
      frames_(kernel, scene, policy),
      volumes_(kernel, scene),
      predicates_(kernel),
      by_volume_(kernel, id, "volumes"),
      pose_(make_pose_2()),
      of_body_(scene.objects.size()) {}

// ---- pairs

PairId PairTable::find(ObjectId a, ObjectId b) const {
  const auto [low, high] = std::minmax(a, b);
  for (const PairId p : of_body_[low]) {
    if (pairs_[p].a == low && pairs_[p].b == high) return p;
  }
  return kNoPair;
}

PairId PairTable::add(ObjectId a, ObjectId b) {
  PairId p = static_cast<PairId>(pairs_.size());
  if (free_.empty()) {
    pairs_.emplace_back();
  } else {
    p = free_.back();
    free_.pop_back();
  }
  pairs_[p].a = std::min(a, b);
  pairs_[p].b = std::max(a, b);
  pairs_[p].state = BodyPair::State::kApart;
  for (const ObjectId body : {pairs_[p].a, pairs_[p].b}) of_body_[body].push_back(p);
  most_pairs_ = std::max(most_pairs_, ++live_pairs_);
  return p;
}

void PairTable::remove(PairId p) {
  drop(p);
  BodyPair& pair = pairs_[p];
  for (const ObjectId body : {pair.a, pair.b}) std::erase(of_body_[body], p);
  if (pair.pose != kNoObject) free_poses_.push_back(pair.pose);
  pair = BodyPair{};
  free_.push_back(p);
  --live_pairs_;
}

void PairTable::make_pose(PairId p) {
  BodyPair& pair = pairs_[p];
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

SumBoundary PairTable::boundary(PairId p) {
  return SumBoundary(kernel_, predicates_, pairs_[p].pose,
                     {&frames_.frame(pairs_[p].a, false), &frames_.frame(pairs_[p].b, true)});
}

// ---- certificates

void PairTable::set(PairId p, Slots& part, std::span<const Query> queries) {
  require(queries.size() <= BodyPair::kMostCertificates, "a proof has too many certificates");
  BodyPair& pair = pairs_[p];
  if (pair.part != &part) drop(p);
  std::array<CertificateId, BodyPair::kMostCertificates> before = pair.slots;
  const std::span<CertificateId> old(before.data(), pair.certificates);
  std::fill_n(pair.slots.begin(), old.size(), kNoCertificate);
  pair.part = &part;
  pair.certificates = static_cast<std::uint8_t>(queries.size());
  most_certificates_ = std::max(most_certificates_, static_cast<std::uint32_t>(queries.size()));
  for (std::size_t slot = 0; slot < queries.size(); ++slot) {
    for (CertificateId& c : old) {
      // The failed one has left the queue: if its query is needed again, a new one is made.
      if (c == kNoCertificate || c == failed_ || !kernel_.claims(c, queries[slot])) continue;
      kernel_.set_tag(c, tag(p, slot));
      pair.slots[slot] = std::exchange(c, kNoCertificate);
      break;
    }
  }
  auto next = old.begin();
  for (std::size_t slot = 0; slot < queries.size(); ++slot) {
    if (pair.slots[slot] != kNoCertificate) continue;
    next = std::find_if(next, old.end(), [](CertificateId c) { return c != kNoCertificate; });
    if (next != old.end()) pair.slots[slot] = std::exchange(*next, kNoCertificate);
    part.set(pair.slots[slot], queries[slot], tag(p, slot));
  }
  for (CertificateId& c : old) part.drop(c);
}

bool PairTable::set_volume(PairId p) {
  const auto query = volumes_.proof(pairs_[p].a, pairs_[p].b);
  if (query) set(p, by_volume_, {&*query, 1});
  return query.has_value();
}

void PairTable::drop(PairId p) {
  BodyPair& pair = pairs_[p];
  for (std::size_t i = 0; i < pair.certificates; ++i) pair.part->drop(pair.slots[i]);
  pair.certificates = 0;
  pair.part = nullptr;
}

bool PairTable::holds(PairId p) const {
  const std::span<const CertificateId> proof = pairs_[p].proof();
  return std::all_of(proof.begin(), proof.end(), [this](CertificateId c) {
    return kernel_.sign_after(kernel_.query(c)) != Sign::kNegative;
  });
}

PairTable::Place PairTable::failed(CertificateId c) {
  failed_ = c;
  const PairId p = kernel_.tag(c) / BodyPair::kMostCertificates;
  return {p, pairs_[p].part->failed(c) % BodyPair::kMostCertificates};
}

// ---- names

PolygonFeature PairTable::feature(PairId p, std::uint8_t z, const Feature& feature) const {
  const ObjectId body = z == 0 ? pairs_[p].a : pairs_[p].b;
  return {body, feature.edge, frames_.place(body, z == 1, feature.i)};
}

std::string PairTable::feature_name(const PolygonFeature& feature) const {
  return scene_.objects[feature.body].id + (feature.edge ? ".e" : ".v") +
         std::to_string(feature.place);
}

ObjectId PairTable::feature_object(PairId p, std::uint8_t z, const Feature& feature) {
  if (features_.empty()) features_.resize(scene_.objects.size());
  const ObjectId body = z == 0 ? pairs_[p].a : pairs_[p].b;
  std::vector<ObjectId>& of_body = features_[body];
  if (of_body.empty()) of_body.resize(4 * scene_.objects[body].polygon.size(), kNoObject);
  ObjectId& known = of_body[4 * feature.i + 2u * z + (feature.edge ? 1u : 0u)];
  if (known != kNoObject) return known;
  const PolygonFeature named = this->feature(p, z, feature);
  return known = kernel_.feature(feature_name(named), named);
}

PairTable::Roles PairTable::describe_volumes(PairId p, ProofGroup& group) const {
  const std::string_view says = volumes_.describe(kernel_.query(pairs_[p].slots[0]));
  if (group.kind.empty()) group.kind = "volumes";
  group.text = says;
  return {says};
}

// ---- checks

bool PairTable::check_tags(PairId p) const {
  const std::span<const CertificateId> proof = pairs_[p].proof();
  for (std::size_t i = 0; i < proof.size(); ++i) {
    if (!pairs_[p].part->owns(proof[i]) || kernel_.tag(proof[i]) != tag(p, i)) return false;
  }
  return true;
}

std::size_t PairTable::bytes() const {
  std::size_t total =
      frames_.bytes() + volumes_.bytes() + free_poses_.capacity() * sizeof(ObjectId) +
      pairs_.capacity() * sizeof(BodyPair) + free_.capacity() * sizeof(PairId) +
      of_body_.capacity() * sizeof(of_body_[0]) + features_.capacity() * sizeof(features_[0]);
  for (const auto& list : features_) total += list.capacity() * sizeof(ObjectId);
  for (const auto& list : of_body_) total += list.capacity() * sizeof(PairId);
  return total;
}

}  // namespace kinex
