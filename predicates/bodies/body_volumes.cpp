// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/body_volumes.h"

#include <algorithm>

#include "predicates/bodies/body_gap.h"
#include "predicates/bodies/frame_geometry.h"

namespace kinex {
namespace {

constexpr std::uint32_t kNoSize = 0xffffffffu;

Rational radius_about(const std::vector<Vertex2>& polygon) {
  Rational most;
  for (const Vertex2& v : polygon) most = std::max(most, v[0] * v[0] + v[1] * v[1]);
  return root_above(most);
}

// A lower bound on the distance from the origin to the nearest side; zero if the origin is not
// strictly inside.
Rational radius_within(const std::vector<Vertex2>& polygon) {
  std::optional<Rational> least;  // the square of that distance
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex2& p = polygon[i];
    const Vertex2& q = polygon[(i + 1) % polygon.size()];
    const Rational cross = p[0] * q[1] - p[1] * q[0];
    if (cross.sign() <= 0) return Rational();
    const Rational x = q[0] - p[0], y = q[1] - p[1];
    const Rational square = cross * cross / (x * x + y * y);
    if (!least || square < *least) least = square;
  }
  // Rounded down to a dyadic number of some ten bits: short constants make short certificates.
  const Rational radius = Rational(1) / root_above(Rational(1) / *least);
  const std::size_t above = radius.numerator().bit_length(),
                    below = radius.denominator().bit_length();
  const unsigned long k = above < below + 10 ? static_cast<unsigned long>(below + 10 - above) : 0;
  return Rational(floor_divide(radius.numerator() << k, radius.denominator()), Integer(1) << k);
}

}  // namespace

BodyVolumes::Radii::Radii(Kernel& kernel, const Scene& scene, bool within)
    : kernel_(kernel),
      scene_(scene),
      within_(within),
      radii_(scene.objects.size()),
      size_(scene.objects.size(), kNoSize) {}

const Rational& BodyVolumes::Radii::radius(ObjectId body) {
  std::optional<Rational>& known = radii_[body];
  if (!known) {
    const std::vector<Vertex2>& polygon = scene_.objects[body].polygon;
    known = within_ ? radius_within(polygon) : radius_about(polygon);
  }
  return *known;
}

std::uint32_t BodyVolumes::Radii::size(ObjectId body) {
  std::uint32_t& known = size_[body];
  if (known == kNoSize) {
    known =
        sizes_.try_emplace(radius(body), static_cast<std::uint32_t>(sizes_.size())).first->second;
  }
  return known;
}

ObjectId BodyVolumes::Radii::reach(ObjectId a, ObjectId b,
                                   std::map<Rational, ObjectId>& constants) {
  const auto [small, large] = std::minmax({size(a), size(b)});
  const auto known =
      reach_of_sizes_.try_emplace(std::uint64_t{large} << 32 | small, kNoObject).first;
  if (known->second != kNoObject) return known->second;
  const Rational sum = radius(a) + radius(b);
  const auto [place, is_new] = constants.try_emplace(sum, kNoObject);
  if (is_new) place->second = kernel_.constant(sum.to_string(), {sum});
  return known->second = place->second;
}

std::size_t BodyVolumes::Radii::bytes() const {
  return radii_.capacity() * sizeof(radii_[0]) + size_.capacity() * sizeof(size_[0]) +
         (sizes_.size() + reach_of_sizes_.size()) * (sizeof(Rational) + sizeof(ObjectId) + 48);
}

BodyVolumes::BodyVolumes(Kernel& kernel, const Scene& scene)
    : kernel_(kernel),
      scene_(scene),
      gap_{kernel.bind(make_axis_gap(0)), kernel.bind(make_axis_gap(1))},
      discs_apart_(kernel.bind(make_discs_apart(false))),
      discs_overlap_(kernel.bind(make_discs_apart(true))),
      about_(kernel, scene, false),
      within_(kernel, scene, true) {}

Rational BodyVolumes::largest_radius() {
  Rational largest;
  for (ObjectId body = 0; body < scene_.objects.size(); ++body) {
    largest = std::max(largest, about_.radius(body));
  }
  return largest;
}

std::string_view BodyVolumes::describe(const Query& proof) const {
  if (proof.predicate == discs_apart_) return "discs about the bodies are apart";
  if (proof.predicate == discs_overlap_) return "discs within the bodies overlap";
  return "boxes about the bodies are apart";
}

std::optional<Query> BodyVolumes::proof(ObjectId a, ObjectId b) {
  const ObjectId apart = about_.reach(a, b, reaches_);
  for (const Query& query :
       {Query(gap_[0], {a, b, apart}), Query(gap_[0], {b, a, apart}), Query(gap_[1], {a, b, apart}),
        Query(gap_[1], {b, a, apart}), Query(discs_apart_, {a, b, apart})}) {
    if (kernel_.sign_after(query) == Sign::kPositive) return query;
  }
  return std::nullopt;
}

std::optional<Query> BodyVolumes::proof_of_overlap(ObjectId a, ObjectId b) {
  if (within_.radius(a).sign() == 0 || within_.radius(b).sign() == 0) return std::nullopt;
  const Query query(discs_overlap_, {a, b, within_.reach(a, b, reaches_)});
  if (kernel_.sign_after(query) != Sign::kPositive) return std::nullopt;
  return query;
}

Query BodyVolumes::discs_overlap(ObjectId a, ObjectId b) {
  return Query(discs_overlap_, {a, b, about_.reach(a, b, reaches_)});
}

std::size_t BodyVolumes::bytes() const {
  return about_.bytes() + within_.bytes() +
         reaches_.size() * (sizeof(Rational) + sizeof(ObjectId) + 48);
}

}  // namespace kinex
