// SPDX-License-Identifier: GPL-3.0-or-later
// BodyGrid: the broad phase for more than two bodies: a uniform grid.
//
// Around every body's origin there is a disc that holds the body however it turns. Cells are
// squares at least as wide as the largest of these discs, wider where the scene is large
// (predicates/bodies/body_grid_lines.h). A body belongs to the cell of its origin and has one
// certificate for each side of the cell. Bodies in cells that do not touch are apart. A certificate
// fails when its body moves to another cell.
//
//     +---+---+---+
//     | n | n | n |      b: the cell of a body; 4 certificates, one for each side
//     +---+---+---+      n: together with b the cells of the bodies near it
//     | n | b | n |
//     +---+---+---+
//     | n | n | n |
//     +---+---+---+
//
// Compactness: 4 certificates per body. Responsiveness: a cell is found by a number of signs
// logarithmic in its distance, counted in cells. Events: O(k) for a body that crosses a region of k
// cells. So n bodies in a box with about one per cell have O(n sqrt n) events while each crosses
// the box once, against Theta(n^2) for sorted lists of the ends of their boxes.
#ifndef KINEX_STRUCTURES_COLLISION_BODY_GRID_H
#define KINEX_STRUCTURES_COLLISION_BODY_GRID_H

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "predicates/bodies/body_grid_lines.h"
#include "structures/parts/slots.h"

namespace kinex {

class BodyGrid {
 public:
  // For bodies numbered below `bodies`.
  BodyGrid(Kernel& kernel, StructureId id, BodyGridLines lines, std::size_t bodies);

  void insert(ObjectId body);
  void erase(ObjectId body);
  bool owns(CertificateId failed) const { return slots_.owns(failed); }
  // This certificate has failed: moves its body to the next cell. Returns the body.
  ObjectId move_on(CertificateId failed);
  // The bodies in its cell and in the eight around it, in ascending order, without itself.
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
    std::array<CertificateId, 4> certificate{kNoCertificate, kNoCertificate, kNoCertificate,
                                             kNoCertificate};  // low x, high x, low y, high y
  };
  std::int64_t find_cell(ObjectId body, int axis);
  bool is_beyond(ObjectId body, int axis, std::int64_t k);
  Query side(ObjectId body, std::uint32_t direction);
  void certify(ObjectId body, std::uint32_t direction);
  void enter(ObjectId body);
  void leave(ObjectId body);

  Kernel& kernel_;
  Slots slots_;
  BodyGridLines lines_;
  std::array<PredicateId, 2> beyond_, short_of_;  // per axis
  std::vector<Place> places_;                     // per body
  std::map<Cell, std::vector<ObjectId>> cells_;   // ascending ids
  std::vector<ObjectId> near_;
};

}  // namespace kinex

#endif
