// SPDX-License-Identifier: GPL-3.0-or-later
// BodyVolumes: cheap proofs of one certificate that two bodies are apart, or overlap, however they
// are turned: discs about their frames' origins that hold the bodies, the squares about these
// discs, and discs about the same origins within the bodies. Formulas, identities: body_gap.h.
#ifndef KINEX_PREDICATES_BODIES_BODY_VOLUMES_H
#define KINEX_PREDICATES_BODIES_BODY_VOLUMES_H

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/engine/kernel.h"
#include "core/motion/scene.h"

namespace kinex {

class BodyVolumes {
 public:
  // Keeps a reference to the scene.
  BodyVolumes(Kernel& kernel, const Scene& scene);

  // A proof of disjointness that holds right after now: a gap on x or y, or between the discs;
  // nullopt if there is none.
  std::optional<Query> proof(ObjectId a, ObjectId b);
  // An overlap proof that holds right after now: discs within the bodies overlap. nullopt if there
  // is none; always nullopt where an origin is not strictly inside its body.
  std::optional<Query> proof_of_overlap(ObjectId a, ObjectId b);
  // The opposite of the proof by discs about the bodies.
  Query discs_overlap(ObjectId a, ObjectId b);
  // What a proof by volumes says: "discs about the bodies are apart".
  std::string_view describe(const Query& proof) const;
  // The largest radius of all bodies of the scene.
  Rational largest_radius();
  std::size_t bytes() const;

 private:
  // A radius of each body, and the sums of two of them.
  class Radii {
   public:
    Radii(Kernel& kernel, const Scene& scene, bool within);
    const Rational& radius(ObjectId body);
    // The sum as a constant.
    ObjectId reach(ObjectId a, ObjectId b, std::map<Rational, ObjectId>& constants);
    std::size_t bytes() const;

   private:
    std::uint32_t size(ObjectId body);
    Kernel& kernel_;
    const Scene& scene_;
    const bool within_;                           // the disc in the body, or the one about it
    std::vector<std::optional<Rational>> radii_;  // per body, once needed
    std::vector<std::uint32_t> size_;  // per body, once needed: equal radii, equal numbers
    std::map<Rational, std::uint32_t> sizes_;
    std::unordered_map<std::uint64_t, ObjectId> reach_of_sizes_;
  };

  Kernel& kernel_;
  const Scene& scene_;
  std::array<PredicateId, 2> gap_;  // per axis
  PredicateId discs_apart_, discs_overlap_;
  Radii about_, within_;
  std::map<Rational, ObjectId> reaches_;  // constants
};

}  // namespace kinex

#endif
