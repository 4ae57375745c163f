// SPDX-License-Identifier: GPL-3.0-or-later
// RectangleDirections: the rectangle of least area or perimeter around moving points of the plane,
// to a proven error: the best of k rectangles with sides along fixed directions.
//
// Certificates. The extreme objects of 4k directions (DirectionMaxima), degree d in t for motions of
// degree d, and a tournament of k boxes, one for each direction u_i with 0 <= i < k and its turn by
// 90 degrees: "the box along u_i is no larger than that along u_j", degree d for the perimeter and
// 2d for the area. (The exact rectangles need 6d.)
//
//        t
//      .----.            a box: its four sides are across the direction and along it, through the
//     l      `----.      extreme objects r, l, t, b
//      \      u ->  r
//       `----.     \     .
//             `----b
//
// Quality. Let p be the least half perimeter, A the least area, and D the diameter of the points. At
// all times the half perimeter p' or the area A' of the rectangle found satisfies
//
//   p <= p' <= p (k + 1) / sqrt(k^2 + 1)
//   A <= A' <= A + 2 D^2 k / (k^2 + 1)
//
// since the best rectangle (W by H), turned by the angle y <= atan(1/k) to the nearest direction, has
// the extents H cos y + W sin y and W cos y + H sin y. The tournament has k - 1 certificates; a failure
// renews O(log k) of them. For n points that move linearly the rectangle changes O(k^2 n) times: the sides
// of the boxes do 2kn times, and the order of two boxes 4n + 1 times (perimeter) or twice that (area).
//
// Attribute. The extreme objects in the direction of the best box, in the opposite one, and in both
// turned by 90 degrees; empty if all points coincide.
//
// Ties. Of objects that are identically level in a direction the smallest id is extreme; of boxes
// that are identically equal the one of the first direction counts.
//
// Source: Agarwal, Har-Peled, "Maintaining approximate extent measures of moving points" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_RECTANGLE_DIRECTIONS_H
#define KINEX_STRUCTURES_EXTENT_RECTANGLE_DIRECTIONS_H

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/extent/box_claims.h"
#include "structures/extent/direction_maxima.h"
#include "structures/parts/attribute_events.h"
#include "structures/parts/changing_extremum.h"

namespace kinex {

class RectangleDirections final : public Structure {
 public:
  // kReplace: in a direction, or in a duel of its tournament, another object is ahead: the old one,
  // the new one. kOvertake: another box wins a duel: the four objects of the old one, then those of
  // the new one. kTie: either of these, because the two have become identically level.
  enum Kind : std::uint8_t { kReplace, kOvertake, kTie };

  // k >= 1.
  RectangleDirections(Kernel& kernel, StructureId id, const Scene& scene, int k,
                      BoxMeasure measure);

  std::string_view name() const override {
    return is_area() ? "min_area_rectangle_directions" : "min_perimeter_rectangle_directions";
  }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "overtake", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { events_.over(touched()); }
  int largest_motion_degree() const override { return maxima_->largest_motion_degree(); }
  Attribute attribute() const override { return {Attribute::Shape::kSequence, touched()}; }
  Attribute told() const override { return events_.told(); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return maxima_->bytes() + boxes_.bytes() + events_.bytes() +
           current_.capacity() * sizeof(BoxClaims::Value);
  }

 private:
  using Value = BoxClaims::Value;
  DirectionMaxima::Tied level() {
    return [this](const DirectionMaxima::Duel& duel) {
      kernel_->report(id_, kTie, {duel.before, duel.after}, false);
    };
  }
  auto equal() {
    return [this](const Value& a, const Value& b) {
      kernel_->report(id_, kTie, {a[1], a[2], a[3], a[4], b[1], b[2], b[3], b[4]}, false);
    };
  }
  bool is_area() const { return boxes_.claims().measure() == BoxMeasure::kArea; }
  std::size_t boxes() const { return maxima_->size() / 4; }
  Value box(std::size_t i) const;
  // Then all points are.
  bool is_point(const Value& box) const {
    return box[1] == box[2] && box[1] == box[3] && box[1] == box[4];
  }
  void read(std::size_t i);
  void read_all();
  std::vector<ObjectId> touched() const;
  void begin();
  Integer most_changes(const Integer& n) const;  // of the rectangle, for n points in linear motion

  Kernel* kernel_;
  StructureId id_;
  int k_;
  std::unique_ptr<DirectionMaxima> maxima_;
  ChangingExtremum<BoxClaims> boxes_;
  std::vector<Value> current_;  // by direction, those that are in boxes_ and those of one object
  AttributeEvents events_;
};

}  // namespace kinex

#endif
