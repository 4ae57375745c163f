// SPDX-License-Identifier: GPL-3.0-or-later
// PointGrid: moving points in the cells of a grid over a box that they never leave: at most m
// squares, of side W.
//
//     line 1   line 2           The outer cells have no outer sides: no point is beyond the box. A
//   +---+--------+----+         cell is at most W wide and high within the box, and just W between
//   |   |        |    |  1      two lines. So of more than m points two share a cell, less than 2W
//   +---+--------+----+         apart, and two points three columns or rows apart, or more, have a
//   |   |        |    |  0      distance of 2W at least.
//   +---+--------+----+
//     0     1      2
//
// Certificates: a point is on its side of each line beside its cell, at most four, of degree d for
// motions of degree d. One that fails moves its point to the next cell. A point on a line
// identically is in either cell.
#ifndef KINEX_STRUCTURES_PROXIMITY_POINT_GRID_H
#define KINEX_STRUCTURES_PROXIMITY_POINT_GRID_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"
#include "core/numbers/rational.h"
#include "structures/parts/slots.h"

namespace kinex {

// A box that holds all flight plans of a scene from its start to its end, in the plane.
struct FlightBox {
  std::array<Rational, 2> low, high;

  // Tight for linear motions. Requires an end.
  static FlightBox of(const Scene& scene);
};

class PointGrid {
 public:
  // The cells of a point are nearer than this to each other, in columns and in rows, if the two may
  // be the closest of more than `squares` points.
  static constexpr std::int64_t kReach = 2;

  PointGrid(Kernel& kernel, StructureId id, FlightBox box, std::size_t points);

  // Lays the lines anew, at most `squares` >= 1 cells, and puts these points into them. O(squares)
  // and, for each point, O(log squares) signs.
  void lay(std::size_t squares, std::span<const ObjectId> points);
  // As laid last.
  std::size_t squares() const { return squares_; }
  std::size_t lines() const { return lines_[0].size() + lines_[1].size(); }

  void insert(ObjectId point);
  void erase(ObjectId point);
  bool owns(CertificateId failed) const { return slots_.owns(failed); }
  // The point of a certificate that has failed, which is still in its cell.
  ObjectId point_of(CertificateId failed) const { return slots_.kernel().tag(failed) / kSides; }
  // Moves it to the next cell.
  void move_on(CertificateId failed);
  // The points whose cells are at most kReach columns and rows from its own, in ascending order,
  // without itself.
  std::vector<ObjectId> near(ObjectId point) const;

  void visit_proof(ProofVisitor& visitor) const;
  void check(AuditReport& report) const;
  // The points are in their cells, at exact positions.
  void audit(const Snapshot& snapshot, AuditReport& report) const;
  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t kSides = 4;  // low x, high x, low y, high y
  using Cell = std::array<std::int64_t, 2>;
  struct Place {
    Cell cell{};
    std::array<CertificateId, kSides> certificate{kNoCertificate, kNoCertificate, kNoCertificate,
                                                  kNoCertificate};
  };
  ObjectId line(std::size_t axis, const Rational& at);
  bool has_side(ObjectId point, std::uint32_t side) const;
  Query query(ObjectId point, std::uint32_t side) const;
  void certify(ObjectId point);
  void enter(ObjectId point);
  void leave(ObjectId point);

  Slots slots_;
  FlightBox box_;
  std::array<PredicateId, 2> order_;                   // per axis
  std::array<std::map<Rational, ObjectId>, 2> known_;  // all lines so far
  std::array<std::vector<ObjectId>, 2> lines_;         // line k is between cells k, k + 1
  std::array<std::vector<Rational>, 2> at_;            // the places of the lines
  std::size_t squares_ = 0;
  std::vector<Place> places_;                    // per point
  std::map<Cell, std::vector<ObjectId>> cells_;  // ascending ids; no empty ones
};

}  // namespace kinex

#endif
