// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/bounding_volumes.h"

#include <algorithm>

#include "predicates/body_gap.h"

namespace kinex {
namespace {

Rational radius_about_origin(const std::vector<Vertex2>& polygon) {
  Rational most;
  for (const Vertex2& v : polygon) most = std::max(most, v[0] * v[0] + v[1] * v[1]);
  return root_above(most);
}

}  // namespace

BoundingVolumes::BoundingVolumes(Kernel& kernel, StructureId id, const Scene& scene)
    : ClosestFeatures(kernel, id, scene),
      gap_{kernel.bind(make_axis_gap(0)), kernel.bind(make_axis_gap(1))},
      discs_apart_(kernel.bind(make_discs_apart(false))),
      discs_overlap_(kernel.bind(make_discs_apart(true))) {}

std::vector<std::string_view> BoundingVolumes::event_kinds() const {
  return common_event_kinds({"contact", "change", "volume"});
}

ObjectId BoundingVolumes::make_reach(PairId p) {
  const Rational sum = radius_about_origin(scene_.objects[pair(p).a].polygon) +
                       radius_about_origin(scene_.objects[pair(p).b].polygon);
  const auto [place, is_new] = reaches_.try_emplace(sum, kNoObject);
  if (is_new) place->second = kernel_.constant(sum.to_string(), {sum});
  return place->second;
}

bool BoundingVolumes::put_volume(PairId p) {
  const ObjectId a = pair(p).a, b = pair(p).b, far = reach_[p];
  const std::array<Query, 5> proofs{Query(gap_[0], {a, b, far}), Query(gap_[0], {b, a, far}),
                                    Query(gap_[1], {a, b, far}), Query(gap_[1], {b, a, far}),
                                    Query(discs_apart_, {a, b, far})};
  for (const Query& proof : proofs) {
    if (kernel_.arithmetic().sign_after(proof) != Sign::kPositive) continue;
    near_[p] = 0;
    set_certificates(p, {&proof, 1});
    return true;
  }
  near_[p] = 1;
  return false;
}

bool BoundingVolumes::start(PairId p) {
  if (near_.size() <= p) near_.resize(p + std::size_t{1}, 0);
  if (reach_.size() <= p) reach_.resize(p + std::size_t{1}, kNoObject);
  reach_[p] = make_reach(p);
  return put_volume(p) || ClosestFeatures::start(p);
}

std::optional<Query> BoundingVolumes::extra(PairId p) {
  return Query(discs_overlap_, {pair(p).a, pair(p).b, reach_[p]});
}

void BoundingVolumes::fail(PairId p, std::uint32_t slot) {
  const bool parted = near_[p] != 0 && slot == extra_slot(p);
  if (near_[p] != 0 && !parted) {
    ClosestFeatures::fail(p, slot);
    return;
  }
  if (!put_volume(p) && !ClosestFeatures::start(p)) {
    kernel_.corrupt(id_, "the bodies meet although a volume was between them");
    return;
  }
  report(p, kVolume);
}

std::size_t BoundingVolumes::bytes() const {
  return ClosestFeatures::bytes() + near_.capacity() + reach_.capacity() * sizeof(ObjectId) +
         reaches_.size() * (sizeof(Rational) + sizeof(ObjectId) + 48);
}

}  // namespace kinex
