// SPDX-License-Identifier: GPL-3.0-or-later
// trapezoids_2: the vertical decomposition of the arrangement of moving lines y = a x + b. From every
// crossing a wall goes straight up to the next line, and one straight down: they cut the faces into
// trapezoids, 3 C(n,2) + n + 1 of them for n lines of which no two are parallel.
//
// Attribute (kSequence). For each two lines that cross, ascending: both, the line on which the wall
// from their crossing upwards ends, and that of the wall downwards; the first line again where there is
// none. External events, when the instant is over, by crossing, upwards first:
//   wall_up, wall_down   the two lines that cross, the line on which their wall ended, the one on which
//                        it ends now (the first line again: it has no end)
//   settled              new motions made two lines parallel identically, or parallel lines cross; with
//                        both attributes
// Internal events: "wall_pass", the crossing of the first two lines was to the left of that of the other
// two, its neighbour in a face, and is so no longer.
//
// It reads line_arrangement_2, whose lists say which crossings bound a face, in which order: a triangle
// that collapses is an event of those. It is a structure of its own: it has another attribute, with many
// more events, and a scene that asks for the arrangement alone has none of its certificates.
//
// Certificates. At most one for each wall: it and the next one of its face, if that comes from the other
// side (face_walls.h); slope_order_2 of four lines, degree 2d. A passage fails one and changes two walls;
// a triangle that turns over changes six.
//
// Bound. A wall ends on another line only where a line passes its crossing, where two crossings are one
// above the other, where its own lines are parallel, and where parallel lines pass through each other:
// O(n^4) roots of polynomials. (For linear motion near-cubic, says the report.)
//
// Cost: for each face that an event changes, of k edges, O(k) comparisons and at most 3 new certificates
// for a passage; k is less than 4 on average. An insertion or erasure O(n^2).
//
// Ties. Lines are raised by infinitesimals, more so the smaller the id: crossing_lists.h.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7.
#ifndef KINEX_STRUCTURES_ARRANGEMENT_TRAPEZOIDS_2_H
#define KINEX_STRUCTURES_ARRANGEMENT_TRAPEZOIDS_2_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/arrangement/face_walls.h"
#include "structures/arrangement/line_arrangement_2.h"

namespace kinex {

// The trapezoids between the lines of an arrangement.
class Trapezoids2 final : public Structure {
 public:
  // Ranks in event_kinds().
  enum Kind : std::uint8_t { kWallUp, kWallDown, kWallPass };

  // `lines` outlives this structure and is watched by it.
  Trapezoids2(Kernel& kernel, StructureId id, const LineArrangement2& lines);

  std::string_view name() const override { return "trapezoids_2"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"wall_up", "wall_down", "wall_pass"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override { settle(); }
  void instant_over() override;
  void watched_changed(const Event* event) override;
  Attribute attribute() const override { return attribute_of(false); }
  Attribute told() const override { return attribute_of(true); }
  void visit_proof(ProofVisitor& visitor) const override { walls_.visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::uint64_t most_repairs(std::uint64_t certificates) const override { return certificates; }
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override { return walls_.bytes(); }

  // The number of trapezoids, counted face by face. O(n^2).
  std::size_t trapezoids() const;

  // For structures that read it.
  const LineArrangement2& lines() const { return *lines_; }
  const FaceWalls& walls() const { return walls_; }

 private:
  bool settle();
  void settle_all();  // nothing is left to be reported
  Attribute attribute_of(bool told) const;

  static constexpr int kMostTries = 100;
  Kernel* kernel_;
  StructureId id_;
  const LineArrangement2* lines_;
  FaceWalls walls_;
  int tries_ = 0;  // in a row, to cut faces that do not close
};

}  // namespace kinex

#endif
