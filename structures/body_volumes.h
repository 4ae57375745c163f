// SPDX-License-Identifier: GPL-3.0-or-later
// BodyVolumes: cheap proofs, of one certificate, that two bodies are apart, whatever way they are
// turned: squares about discs about their frames' origins, and the discs themselves.
#ifndef KINEX_STRUCTURES_BODY_VOLUMES_H
#define KINEX_STRUCTURES_BODY_VOLUMES_H

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/kernel.h"
#include "core/scene.h"

namespace kinex {

class BodyVolumes {
 public:
  // Keeps a reference to the scene.
  BodyVolumes(Kernel& kernel, const Scene& scene);

  // A proof that holds right after now: a gap on x or y, or between the discs; nullopt if there is
  // none.
  std::optional<Query> proof(ObjectId a, ObjectId b);
  // The opposite of the proof by discs.
  Query discs_overlap(ObjectId a, ObjectId b);
  // The largest radius of all bodies of the scene.
  Rational largest_radius();
  std::size_t bytes() const;

 private:
  ObjectId reach(ObjectId a, ObjectId b);
  std::uint32_t size(ObjectId body);
  const Rational& radius(ObjectId body);

  Kernel& kernel_;
  const Scene& scene_;
  std::array<PredicateId, 2> gap_;  // per axis
  PredicateId discs_apart_, discs_overlap_;
  std::vector<std::optional<Rational>> radii_;  // per body, once needed
  std::map<Rational, ObjectId> reaches_;        // constants
  std::vector<std::uint32_t> size_;             // per body, once needed: equal radii, equal numbers
  std::map<Rational, std::uint32_t> sizes_;
  std::unordered_map<std::uint64_t, ObjectId> reach_of_sizes_;
};

}  // namespace kinex

#endif
