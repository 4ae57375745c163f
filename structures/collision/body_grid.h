// SPDX-License-Identifier: GPL-3.0-or-later
// BodyGrid: the broad phase for many bodies: a uniform grid.
//
// Cells are squares as wide as the two largest bodies together (discs about their frames' origins),
// or wider where the scene is large (width_for). A body belongs to the cell of its origin and holds
// one certificate for each side of it; bodies in cells that do not touch are apart wherever they
// are inside them. A certificate fails when a body changes its cell.
//
//     +---+---+---+
//     | n | n | n |      b: a body; 4 certificates, one a side of its cell
//     +---+---+---+      n: the cells of the bodies near b, with b's own
//     | n | b | n |
//     +---+---+---+
//     | n | n | n |
//     +---+---+---+
//
// Compactness: 4 certificates a body. Responsiveness: cells are found by O(log) signs. Events: O(k)
// for a body that crosses a region of k cells; so n bodies in a box with about one a cell have
// O(n sqrt n) in one crossing time, against Theta(n^2) for sorted lists of the ends of their boxes.
#ifndef KINEX_STRUCTURES_COLLISION_BODY_GRID_H
#define KINEX_STRUCTURES_COLLISION_BODY_GRID_H

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"

namespace kinex {

class BodyGrid {
 public:
  // The tags of its certificates have this bit.
  static constexpr std::uint32_t kTag = 0x80000000u;

  // A width of cells for bodies of at most this radius: at least twice that, and large enough
  // that the ends of all flight plans lie within some 64 + n cells of the origin, so that a fast or
  // distant body costs no more than that. nullopt for a scene without an end, in which bodies would
  // cross cells for all time.
  static std::optional<Rational> width_for(const Scene& scene, const Rational& largest_radius);

  // Cells of width `width` > 0 for bodies numbered below `bodies`.
  BodyGrid(Kernel& kernel, StructureId id, Rational width, std::size_t bodies);

  void insert(ObjectId body);
  void erase(ObjectId body);
  // The certificate with this tag has failed: its body moves on to the next cell. Returns the body.
  ObjectId move_on(std::uint32_t tag);
  // The bodies in its cell and in the eight about it, in ascending order, itself excepted.
  // Valid until the next call.
  std::span<const ObjectId> near(ObjectId body);
  bool are_near(ObjectId a, ObjectId b) const;
  // The cell of each body as a group of a proof.
  void visit_proof(ProofVisitor& visitor) const;
  std::size_t bytes() const;

 private:
  using Cell = std::array<std::int64_t, 2>;
  struct Place {
    Cell cell{};
    std::array<CertificateId, 4> certificate{};  // low x, high x, low y, high y
  };
  ObjectId line(std::int64_t k);
  std::int64_t find_cell(ObjectId body, int axis);
  bool is_beyond(ObjectId body, int axis, std::int64_t k);
  Query side(ObjectId body, std::uint32_t direction);
  void enter(ObjectId body);
  void leave(ObjectId body);

  Kernel& kernel_;
  const StructureId id_;
  Rational width_;
  std::array<PredicateId, 2> beyond_, short_of_;  // per axis
  std::vector<Place> places_;                     // per body
  std::map<Cell, std::vector<ObjectId>> cells_;   // ascending ids
  std::map<std::int64_t, ObjectId> lines_;
  std::vector<ObjectId> near_;
};

}  // namespace kinex

#endif
