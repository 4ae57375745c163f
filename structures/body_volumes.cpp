// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/body_volumes.h"

#include <algorithm>

#include "predicates/body_gap.h"
#include "predicates/frame_geometry.h"

namespace kinex {
namespace {

constexpr std::uint32_t kNoSize = 0xffffffffu;

}  // namespace

BodyVolumes::BodyVolumes(Kernel& kernel, const Scene& scene)
    : kernel_(kernel),
      scene_(scene),
      gap_{kernel.bind(make_axis_gap(0)), kernel.bind(make_axis_gap(1))},
      discs_apart_(kernel.bind(make_discs_apart(false))),
      discs_overlap_(kernel.bind(make_discs_apart(true))),
      radii_(scene.objects.size()),
      size_(scene.objects.size(), kNoSize) {}

const Rational& BodyVolumes::radius(ObjectId body) {
  std::optional<Rational>& known = radii_[body];
  if (!known) {
    Rational most;
    for (const Vertex2& v : scene_.objects[body].polygon) {
      most = std::max(most, v[0] * v[0] + v[1] * v[1]);
    }
    known = root_above(most);
  }
  return *known;
}

Rational BodyVolumes::largest_radius() {
  Rational largest;
  for (ObjectId body = 0; body < radii_.size(); ++body) largest = std::max(largest, radius(body));
  return largest;
}

std::uint32_t BodyVolumes::size(ObjectId body) {
  std::uint32_t& known = size_[body];
  if (known == kNoSize) {
    known =
        sizes_.try_emplace(radius(body), static_cast<std::uint32_t>(sizes_.size())).first->second;
  }
  return known;
}

ObjectId BodyVolumes::reach(ObjectId a, ObjectId b) {
  const auto [small, large] = std::minmax({size(a), size(b)});
  const auto known =
      reach_of_sizes_.try_emplace(std::uint64_t{large} << 32 | small, kNoObject).first;
  if (known->second != kNoObject) return known->second;
  const Rational sum = radius(a) + radius(b);
  const auto [place, is_new] = reaches_.try_emplace(sum, kNoObject);
  if (is_new) place->second = kernel_.constant(sum.to_string(), {sum});
  return known->second = place->second;
}

std::optional<Query> BodyVolumes::proof(ObjectId a, ObjectId b) {
  const ObjectId apart = reach(a, b);
  for (const Query& query :
       {Query(gap_[0], {a, b, apart}), Query(gap_[0], {b, a, apart}), Query(gap_[1], {a, b, apart}),
        Query(gap_[1], {b, a, apart}), Query(discs_apart_, {a, b, apart})}) {
    if (kernel_.arithmetic().sign_after(query) == Sign::kPositive) return query;
  }
  return std::nullopt;
}

Query BodyVolumes::discs_overlap(ObjectId a, ObjectId b) {
  return Query(discs_overlap_, {a, b, reach(a, b)});
}

std::size_t BodyVolumes::bytes() const {
  return radii_.capacity() * sizeof(radii_[0]) + size_.capacity() * sizeof(size_[0]) +
         (reaches_.size() + sizes_.size() + reach_of_sizes_.size()) *
             (sizeof(Rational) + sizeof(ObjectId) + 48);
}

}  // namespace kinex
