// SPDX-License-Identifier: GPL-3.0-or-later
// LineWays: the way of each of some lines through the cells of a cutting, from left to right, with its
// proof. A part of incidences_cutting.
//
//      \      |     /            the line g enters a cell through its left wall, floor or ceiling. It
//       \     |  _-'- g          leaves it
//   c ---\----+'------             through the ceiling, above the upper corner at the right side, or
//         \_-'|\                   through the floor, below the lower corner, or
//       _-'   | \                  through the wall at the right side, between both.
//   f ----\---+-----             Behind the ceiling it is in the cell above whose lower corner at the
//          \  |                  left side it is below; behind the floor likewise.
//
// A corner is the point of a line h, floor or ceiling, at the x of the crossing of two sample lines; or
// the end of h, far to the left or to the right.
//
// Certificates. A line that leaves a cell through a wall has two claims about corners, one that leaves it
// through its floor or ceiling has one, and one more about the cell that it enters; two where it begins.
// A corner that is the crossing itself: orientation_2 of three lines as points (a, b); another one:
// slope_order_2 of four (degree 2d both); at the ends: order_x, or order_y for parallel lines (degree d).
//
// Ties. Of the line of the smallest id b is larger by the largest infinitesimal, and so on
// (crossing_lists.h). So no line passes through a corner, and those of a cell do not contradict each other.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_LINE_WAYS_H
#define KINEX_STRUCTURES_ARRANGEMENT_LINE_WAYS_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/arrangement/cutting_cells.h"
#include "structures/parts/slots.h"

namespace kinex {

class LineWays {
 public:
  using Cell = CuttingCells::Cell;

  // `cells` outlives this part. `objects`: of the scene.
  LineWays(Kernel& kernel, StructureId id, CuttingCells& cells, std::size_t objects);

  bool owns(CertificateId c) const { return slots_.owns(c); }
  // The cells of a line from left to right; none if it has not been led.
  const std::vector<Cell>& cells(ObjectId line) const { return ways_[line].cells; }
  // Leads the line through the cells anew, right after now. `slopes`: the sample lines in the order of
  // slopes, `lines`: the lists of their crossings. False if it cannot be: the cells are not those of the
  // sample lines. Then it has no way. O(r + k) comparisons for r sample lines and k cells with the floors
  // and ceilings that it passes.
  [[nodiscard]] bool lead(ObjectId line, const std::vector<ObjectId>& slopes,
                          const CrossingLists& lines);
  void forget(ObjectId line);
  // A cell of the line is about to go: the line has no way until it is led again.
  void leave_cells(ObjectId line);
  // A certificate of this part has failed: its line.
  ObjectId failed(CertificateId c);

  void visit_proof(ProofVisitor& visitor) const;
  void check(ObjectId line, AuditReport& report) const;
  std::size_t bytes() const;

 private:
  enum class At : std::uint8_t { kCrossing, kLeftEnd, kRightEnd };
  struct Corner {
    At at;
    std::array<ObjectId, 2> crossing;
    ObjectId on;
  };
  struct Claim {
    Query query;
    CertificateId certificate = kNoCertificate;
  };
  struct Way {
    std::vector<Cell> cells;
    std::vector<Claim> claims;
  };
  struct Step {  // being led
    ObjectId line;
    const CrossingLists* lines;
    std::vector<Cell> cells;
    std::vector<Query> claims;
  };

  int slope_order(ObjectId l, ObjectId m) const;  // of m beyond l
  Query claim(const Step& step, const Corner& corner, bool above) const;
  bool is_tied_above(const Step& step, const Corner& corner) const;
  bool is_above(const Step& step, const Corner& corner) const;
  static Corner corner(const std::array<ObjectId, 2>& crossing, bool right, ObjectId on);
  void prove(Step& step, const Corner& corner, bool above) const;
  Cell begin(Step& step, const std::vector<ObjectId>& slopes) const;
  Cell next(Step& step, Cell cell, bool& ends) const;
  Cell behind(Step& step, ObjectId line, bool up) const;
  void keep(ObjectId line, Step&& step);

  Kernel* kernel_;
  CuttingCells* cells_;
  PredicateId slope_, height_, orientation_, order_;
  Slots slots_;
  std::vector<Way> ways_;  // by object
};

}  // namespace kinex

#endif
