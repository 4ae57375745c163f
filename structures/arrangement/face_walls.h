// SPDX-License-Identifier: GPL-3.0-or-later
// FaceWalls: the vertical decomposition of an arrangement of lines. From every crossing a wall goes
// straight up, and one straight down, each to the next line or without end: they cut the faces into
// trapezoids. A part of trapezoids_2.
//
//            \           __--  upper chain      in the order of x: w, u, v
//             \__----u---      of a face        certificates: w before u, u before v
//              \     |    /
//               \    |   /                      the wall of w ends on the line of the upper chain
//         lower  w---+--v                       that is above w, and so on: no further claim is
//         chain       --                        needed, neighbours in a chain are so on a line
//
// The proof. In a face the crossings inside its upper chain, and those inside its lower chain, are in
// the order of x already: the crossing lists say so. Both are merged, and two neighbours from different
// chains have a certificate: slope_order_2 of their four lines as points (a, b), of degree 2d.
//
// A change of the lists changes faces, and a certificate that fails does: the owner notes what it hears
// of, and settle() merges the chains of these faces anew.
//
// Ties. Of the line of the smallest id b is larger by the largest infinitesimal, and so on
// (crossing_lists.h). The four lines of a certificate are different, and those of one crossing are not
// parallel: so of two crossings at one x identically the smallest id of the four decides.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_FACE_WALLS_H
#define KINEX_STRUCTURES_ARRANGEMENT_FACE_WALLS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "structures/arrangement/crossing_lists.h"
#include "structures/parts/slots.h"

namespace kinex {

class FaceWalls {
 public:
  enum Side : std::uint8_t { kUp, kDown };
  // From the crossing of two lines, ascending, upwards or downwards.
  struct Wall {
    ObjectId l, m;
    Side side;
    friend auto operator<=>(const Wall&, const Wall&) = default;
  };
  // Between two walls, or ends of a face, and two lines. kNoObject: it goes on without end on that side.
  struct Trapezoid {
    ObjectId floor = kNoObject, ceiling = kNoObject;
    // The crossings at its left and at its right side, each as two lines, ascending.
    std::array<ObjectId, 2> left{kNoObject, kNoObject}, right{kNoObject, kNoObject};
    friend auto operator<=>(const Trapezoid&, const Trapezoid&) = default;
  };
  // The line on which a wall ends; kNoObject: none, it has no end. kAbsent: there is no such wall.
  static constexpr ObjectId kAbsent = kNoObject - 1;

  // `crossings` outlives this part.
  FaceWalls(Kernel& kernel, StructureId id, const CrossingLists& crossings);

  bool owns(CertificateId c) const { return slots_.owns(c); }
  ObjectId end(const Wall& wall) const { return ends_[at(wall)]; }
  // The same when forget() was called last.
  ObjectId end_before(const Wall& wall) const { return before_[at(wall)]; }

  // A certificate of this part has failed: the crossing that was the left one, and the other. Their
  // faces are noted.
  std::array<ObjectId, 4> failed(CertificateId c);
  // What the lists of crossings have changed. O(1) each.
  void note_crossing(ObjectId l, ObjectId m) { notes_.push_back({l, m, What::kCrossing}); }
  void note_ends(ObjectId l) { notes_.push_back({l, l, What::kEnds}); }
  void note_line(ObjectId l) { notes_.push_back({l, l, What::kLine}); }
  void note_all() { all_ = true; }
  // New motions of these objects. Notes the faces with new ties.
  void motions_changed(std::span<const ObjectId> objects);
  bool is_settled() const { return notes_.empty() && !all_; }
  // Cuts the faces that are noted anew, right after now. `slopes`: all lines in the order of slopes,
  // of parallel ones the higher one first. False, with some faces not cut, if the lists of crossings are
  // not those of lines, which exact signs exclude. For a face of k edges O(k) comparisons.
  [[nodiscard]] bool settle(std::span<const ObjectId> slopes);
  void drop_proof();  // no certificates
  void clear();       // and no walls

  // The walls that may have another end than before, ascending.
  const std::vector<Wall>& changed();
  void forget();

  // Calls visit(wall, end) for all walls, ascending; `before`: as they were when forget() was called.
  template <class Visit>
  void each(bool before, const Visit& visit) const {
    for (std::size_t l = 0; l < numbers().count(); ++l) {
      for (std::size_t m = l + 1; m < numbers().count(); ++m) {
        for (const Side side : {kUp, kDown}) {
          const Wall wall{numbers().line(l), numbers().line(m), side};
          const ObjectId end = (before ? before_ : ends_)[at(wall)];
          if (end != kAbsent) visit(wall, end);
        }
      }
    }
  }
  // Calls visit(trapezoid, goes_on) for all trapezoids, face by face and from left to right; goes_on: the
  // next one is behind the wall at its right side. False as settle(). Requires that all is settled. O(n^2).
  template <class Visit>
  bool each_trapezoid(std::span<const ObjectId> slopes, const Visit& visit) const {
    if (slopes.empty()) visit(Trapezoid{}, false);
    return each_face(slopes, [&](const Face& face) { trapezoids_of(face, visit); });
  }
  void visit_proof(ProofVisitor& visitor) const;
  void check(std::span<const ObjectId> slopes, AuditReport& report) const;
  std::size_t bytes() const;

 private:
  enum class What : std::uint8_t { kCrossing, kEnds, kLine, kWall };
  struct Note {  // faces: about a crossing, at the ends of a line, along a line, of a wall
    ObjectId l, m;
    What what;
    Side side = kUp;
  };
  // Of a line, from the crossing at a place in its list to the next one; at the place of the line itself
  // it has no left end.
  struct Edge {
    ObjectId line;
    std::size_t place;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  // The edges of a face above or below it, from left to right.
  struct Chain {
    std::vector<Edge> edges;
    std::optional<Edge> left, right;  // of the other chain, where both meet
  };
  struct Face {
    std::array<Chain, 2> chains;  // kUp: those that the face is above
  };
  struct Far {  // the line above, and the line below, far to the right; kNoObject: none
    ObjectId above = kNoObject, below = kNoObject;
  };

  const LineNumbers& numbers() const { return crossings_->numbers(); }
  std::size_t at(const Wall& wall) const {
    return 2 * (std::size_t{numbers()[wall.l]} * numbers().count() + numbers()[wall.m]) + wall.side;
  }
  Wall wall_of(std::size_t place) const {
    return {numbers().line(place / 2 / numbers().count()),
            numbers().line(place / 2 % numbers().count()), place % 2 == 0 ? kUp : kDown};
  }
  bool crosses(ObjectId l, ObjectId m) const;
  Edge edge_after(ObjectId line, ObjectId m) const { return {line, crossings_->place(line, m)}; }
  Edge edge_before(ObjectId line, ObjectId m) const {
    return {line, crossings_->place(line, m) - 1};
  }
  Edge first_edge(ObjectId line) const { return {line, crossings_->place(line, line)}; }
  Edge last_edge(ObjectId line) const { return {line, crossings_->order(line).size() - 1}; }
  std::vector<Far> far_right(std::span<const ObjectId> slopes) const;
  bool walk(const Edge& start, Side side, Chain& chain) const;
  bool face_at(const Edge& edge, Side side, std::span<const Far> far, Face& face) const;
  // Of the crossings inside a chain the one behind edge i.
  Wall wall_at(const Face& face, Side side, std::size_t i) const;

  // "The first crossing is before the second one."
  Query claim(const Wall& first, const Wall& second) const;
  bool goes_first(const Wall& first, const Wall& second) const;
  bool is_before(const Wall& first, const Wall& second) const;
  void set_end(const Wall& wall, ObjectId end);
  void link(const Wall& wall, const Wall& next);
  void cut(const Face& face);
  bool settle_at(const Edge& edge, Side side, std::span<const Far> far);
  bool settle_along(ObjectId line, std::span<const Far> far);
  bool settle_note(const Note& note, std::span<const Far> far);
  std::uint32_t& mark(const Edge& edge, Side side) {
    return marks_[2 * (numbers()[edge.line] * (std::size_t{numbers().count()} + 1) + edge.place) +
                  side];
  }
  // Calls visit(face) for all faces. False as settle(). Every face has an edge that it is above, or one
  // that it is below, as its first one.
  template <class Visit>
  bool each_face(std::span<const ObjectId> slopes, const Visit& visit) const {
    const std::vector<Far> far = far_right(slopes);
    Face face;
    for (const ObjectId line : crossings_->lines()) {
      for (Edge edge = first_edge(line); edge.place <= last_edge(line).place; ++edge.place) {
        for (const Side side : {kUp, kDown}) {
          if (!face_at(edge, side, far, face)) return false;
          const bool is_first = face.chains[side].edges.front() == edge;
          if (is_first && (side == kUp || face.chains[kUp].edges.empty())) visit(face);
        }
      }
    }
    return true;
  }
  // The walls of a face from left to right, by their ends: one from above is behind all crossings of the
  // lower chain to the left of the line on which it ends. It may lack some if the ends are wrong.
  std::vector<Wall> order_of(const Face& face) const;
  template <class Visit>
  void trapezoids_of(const Face& face, const Visit& visit) const {
    const std::vector<Edge>&lower = face.chains[kUp].edges, &upper = face.chains[kDown].edges;
    const bool closed = !lower.empty() && !upper.empty();
    const auto meet = [](ObjectId l, ObjectId m) {
      return std::array<ObjectId, 2>{std::min(l, m), std::max(l, m)};
    };
    Trapezoid one;
    std::size_t i = 0, j = 0;
    if (closed && face.chains[kUp].left) one.left = meet(lower.front().line, upper.front().line);
    const auto between = [&] {
      one.floor = lower.empty() ? kNoObject : lower[i].line;
      one.ceiling = upper.empty() ? kNoObject : upper[j].line;
    };
    for (const Wall& wall : order_of(face)) {
      between();
      one.right = {wall.l, wall.m};
      visit(one, true);
      one.left = one.right;
      ++(wall.side == kUp ? i : j);
    }
    between();
    one.right = {kNoObject, kNoObject};
    if (closed && face.chains[kUp].right) one.right = meet(lower.back().line, upper.back().line);
    visit(one, false);
  }
  void check_face(const Face& face, AuditReport& report) const;

  Kernel* kernel_;
  const CrossingLists* crossings_;
  PredicateId order_;
  Slots slots_;
  std::vector<ObjectId> ends_, before_;      // by wall
  std::vector<CertificateId> certificates_;  // by wall: of it and the next one
  std::vector<std::uint32_t> nexts_;         // by wall: that one, where there is a certificate
  std::vector<std::uint32_t> marks_;         // by edge and side: when its face was cut last
  std::uint32_t round_ = 0;
  std::vector<Note> notes_;
  bool all_ = false;
  std::vector<Wall> changed_;
};

}  // namespace kinex

#endif
