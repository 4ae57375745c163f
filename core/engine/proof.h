// SPDX-License-Identifier: GPL-3.0-or-later
// A structure's proof as data: its certificates in groups, with the role of each in its group.
//
//   group    what a few certificates are about: an edge, a match of a tournament, a pair of bodies.
//            It may have a place in a tree, its state in words, and marks.
//   mark     something that belongs to the picture of a group and is no certificate
//   role     what a certificate is to its group. (Its predicate gives the roles of the
//            arguments in the certificate: core/arithmetic/claim_form.h.)
//
// A group is identified by its place in a tree, or else by the objects that it is about; no two
// groups of a proof have the same. Viewers draw proofs from this alone; they know no structure.
#ifndef KINEX_CORE_ENGINE_PROOF_H
#define KINEX_CORE_ENGINE_PROOF_H

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/certificate.h"
#include "core/motion/derived_objects.h"
#include "core/numbers/rational.h"

namespace kinex {

struct ProofMark {  // a drawing that shows a part of a proof
  enum class Shape : std::uint8_t {
    kChain,    // `objects`, joined in this order
    kJoin,     // the shortest segment between `features`
    kThrough,  // the line through `features`, which are vertices
    kLine,     // the line objects[0] of the body about[body]
    kOutline,  // `outline` in the frame of the body about[body]
  };
  Shape shape = Shape::kChain;
  std::string_view name;  // in the legend
  std::vector<ObjectId> objects;
  std::array<PolygonFeature, 2> features{};  // of about[0] and of about[1]
  std::uint8_t body = 0;
  // Points of the plane as (x, y, w): (x / w, y / w).
  std::vector<std::vector<Rational>> outline;
  friend bool operator==(const ProofMark&, const ProofMark&) = default;
};

struct ProofGroup {  // certificates that prove one thing together
  static constexpr std::uint64_t kNoPlace = ~std::uint64_t{};
  std::string_view kind = {};        // "edge", "match", "tile"
  std::vector<ObjectId> about = {};  // objects of the scene
  std::string text = {};             // its state in words; empty: kind and objects say everything
  // Its place in a tree (or in one of several), and that of its parent; kNoPlace: none.
  std::uint64_t place = kNoPlace, parent = kNoPlace;
  std::uint32_t branch = 0;  // the order among siblings
  // The lines in its certificates are those of the Minkowski sum of the two bodies, not their own.
  bool of_sum = false;
  std::vector<ProofMark> marks = {};
  friend bool operator==(const ProofGroup&, const ProofGroup&) = default;
};

class ProofVisitor {  // receives a proof group by group
 public:
  virtual ~ProofVisitor() = default;
  // The certificates that follow belong to this group. It may have none.
  virtual void group(const ProofGroup& group) = 0;
  // `id` is live: a claim that has no certificate between two calls of an instant is left out. `role`
  // lives as long as the run.
  virtual void certificate(CertificateId id, std::string_view role) = 0;
};

}  // namespace kinex

#endif
