// SPDX-License-Identifier: GPL-3.0-or-later
// PointGrid: moving points, in 1 to 3 axes, in the cells of a grid over a box that they never leave:
// at most m cubes of side W, which is larger than the largest diameter of a disc, if there are discs.
//
//     line 1   line 2           The outer cells have no outer sides: no point is beyond the box. A
//   +---+--------+----+         cell is at most W wide and high within the box, and just W between
//   |   |        |    |  1      two lines. So of more than m points two share a cell, and two
//   +---+--------+----+         points two columns or rows apart, or more, have a distance of W at
//   |   |        |    |  0      least; in the plane those of one cell are less than 2W apart.
//   +---+--------+----+
//     0     1      2
//
// Certificates: a point is on its side of each line beside its cell, at most two an axis, of degree
// d for motions of degree d. One that fails moves its point to the next cell. A point on a line
// identically is in either cell.
#ifndef KINEX_STRUCTURES_PROXIMITY_POINT_GRID_H
#define KINEX_STRUCTURES_PROXIMITY_POINT_GRID_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"
#include "predicates/points/point_grid_lines.h"
#include "structures/parts/slots.h"

namespace kinex {

class PointGrid {
 public:
  // Two points are near each other if their cells are at most `reach` columns, rows and layers apart.
  PointGrid(Kernel& kernel, StructureId id, FlightBox box, std::size_t points, std::int64_t reach);

  // Lays the lines anew, at most `cells` >= 1 cells, and puts these points into them. O(cells), in
  // space O(cells log cells), and, for each point, O(log cells) signs.
  void lay(std::size_t cells, std::span<const ObjectId> points);
  // As asked for last.
  std::size_t cells() const { return cells_asked_; }
  std::size_t lines() const;
  std::size_t axes() const { return lines_.axes(); }

  void insert(ObjectId point);
  void erase(ObjectId point);
  bool owns(CertificateId failed) const { return slots_.owns(failed); }
  // The point of a certificate that has failed, which is still in its cell.
  ObjectId point_of(CertificateId failed) const { return slots_.kernel().tag(failed) / sides(); }
  // Moves it to the next cell.
  void move_on(CertificateId failed);
  // The points that are near this one, in ascending order, without itself.
  std::vector<ObjectId> near(ObjectId point) const;

  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  // At exact positions, which may be beyond the box, after the scene's end: no two points of a cell are
  // farther apart than 5/4 W on an axis, or there are no lines. So they are less than 2W apart in the plane.
  bool has_small_cells(const Snapshot& snapshot) const;
  // No two of these discs touch that are two columns apart or more; or there are no lines.
  bool is_wide_enough(const Snapshot& snapshot) const;
  // The points are in their cells, at exact positions.
  void audit(const Snapshot& snapshot, AuditReport& report) const;
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kMostAxes = 3;
  static constexpr std::uint32_t kMostSides = 2 * kMostAxes;  // low x, high x, low y, ..
  using Cell = std::array<std::int64_t, kMostAxes>;           // 0 on axes that are not there
  struct Place {
    Cell cell{};
    std::array<CertificateId, kMostSides> certificate{kNoCertificate, kNoCertificate,
                                                      kNoCertificate, kNoCertificate,
                                                      kNoCertificate, kNoCertificate};
  };
  std::uint32_t sides() const { return static_cast<std::uint32_t>(2 * axes()); }
  bool has_side(ObjectId point, std::uint32_t side) const;
  Query query(ObjectId point, std::uint32_t side) const;
  void certify(ObjectId point);
  void enter(ObjectId point);
  void leave(ObjectId point);
  void add_near(std::size_t axis, const Cell& own, Cell& from, std::vector<ObjectId>& result) const;

  Slots slots_;
  PointGridLines lines_;
  std::int64_t reach_;
  std::vector<PredicateId> orders_;  // per axis
  std::size_t cells_asked_ = 0;
  std::vector<Place> places_;                    // per point
  std::map<Cell, std::vector<ObjectId>> cells_;  // ascending ids; no empty ones
};

}  // namespace kinex

#endif
