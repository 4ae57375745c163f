// SPDX-License-Identifier: GPL-3.0-or-later
// CuttingCells: the trapezoids of a sample of lines, with the other lines that cross each. A part of
// incidences_cutting, without certificates: those of the trapezoids are trapezoids_2's.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_CUTTING_CELLS_H
#define KINEX_STRUCTURES_ARRANGEMENT_CUTTING_CELLS_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/motion/scene.h"
#include "structures/arrangement/trapezoids_2.h"

namespace kinex {

class CuttingCells {
 public:
  using Cell = std::uint32_t;
  using Trapezoid = FaceWalls::Trapezoid;
  static constexpr Cell kNone = 0xffffffffu;

  // The cells become the present trapezoids. One that is as it was stays, with its lines. Calls
  // gone(cell) for each that is no longer there, while its lines still are. False if the trapezoids are
  // not those of lines (FaceWalls::settle): then nothing has changed. O(r^2 log r) for r sample lines.
  template <class Gone>
  [[nodiscard]] bool renew(const Trapezoids2& trapezoids, const Gone& gone) {
    if (!collect(trapezoids)) return false;
    for (auto i = places_.begin(); i != places_.end();) {
      if (next_.contains(i->first)) {
        ++i;
        continue;
      }
      gone(i->second);
      cells_[i->second] = {};
      free_.push_back(i->second);
      i = places_.erase(i);
    }
    add_new();
    return true;
  }

  std::size_t size() const { return places_.size(); }
  const Trapezoid& trapezoid(Cell cell) const { return cells_[cell].trapezoid; }
  // Behind the wall at the right side; kNone: its face ends there.
  Cell behind(Cell cell) const { return cells_[cell].behind; }
  // The lines that cross it, ascending.
  const std::vector<ObjectId>& lines(Cell cell) const { return cells_[cell].lines; }
  bool is_crossed(Cell cell, ObjectId line) const;
  void add_line(Cell cell, ObjectId line);
  void remove_line(Cell cell, ObjectId line);
  // Calls visit(cell) for all cells, in the order of their trapezoids, until it returns true; that cell.
  template <class Found>
  Cell find(const Found& found) const {
    for (const auto& [trapezoid, cell] : places_) {
      if (found(trapezoid)) return cell;
    }
    return kNone;
  }
  template <class Visit>
  void each(const Visit& visit) const {
    for (const auto& [trapezoid, cell] : places_) visit(cell);
  }
  std::size_t bytes() const;

 private:
  struct Content {
    Trapezoid trapezoid;
    Cell behind = kNone;
    std::vector<ObjectId> lines;
  };
  bool collect(const Trapezoids2& trapezoids);
  void add_new();

  std::vector<Content> cells_;
  std::vector<Cell> free_;
  std::map<Trapezoid, Cell> places_;
  std::map<Trapezoid, Trapezoid> next_;  // each with the one behind its wall, or itself
};

}  // namespace kinex

#endif
