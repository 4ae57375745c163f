// SPDX-License-Identifier: GPL-3.0-or-later
// Directions2: the extreme objects in 4k directions, as a polygon: the convex hull of moving points
// to a proven error, for the price of 4k maxima.
//
// Certificates. Those of DirectionMaxima, in the directions of unit_directions.h: degree d for
// motions of degree d. That the extreme objects are a convex polygon follows from their being
// extreme, in the order of the directions. An object that is extreme in one direction only, and
// there identically level with the two beside it, lies on the edge between them and is left out.
//
//              c______b            k = 1: a, b, c, d are extreme in the four directions of the axes;
//             /  e     \           e, on the line from c to a, is extreme in none
//            d_____     \          .
//                  `-----a
//
// Quality. For the true diameter D and the width w of the points, D' and w' of this polygon, at all
// times:
//
//   D^2 k^2 / (k^2 + 1) <= D'^2 <= D^2
//   w' <= w <= w' + D / k
//
// and the least circle around the polygon, grown by a factor of at most sqrt(1 + 1/k^2) about the
// same centre, holds all points. For n points that move linearly: 4k certificates, at most one of
// each direction a point; a failure renews one and costs O(1) signs and O(k) time; at most 2kn
// failures, against Theta(n^2) changes of the hull in the worst case. Otherwise: 4k(n - 1)
// certificates of tournaments, 4k ceil(log2 n) a point; a failure renews O(log n). The polygon
// changes by jumps: a vertex that enters may be far from the edge that it replaces.
//
// Ties. Of objects that are identically level in a direction the smallest id is extreme; only
// strict vertices are on the polygon.
//
// Source: Agarwal, Har-Peled, "Maintaining approximate extent measures of moving points" (2001).
#ifndef KINEX_STRUCTURES_EXTENT_DIRECTIONS_2_H
#define KINEX_STRUCTURES_EXTENT_DIRECTIONS_2_H

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/extent/direction_maxima.h"
#include "structures/hull/hull_source.h"

namespace kinex {

class Directions2 final : public HullSource {
 public:
  // kReplace: in a direction, or in a duel of its tournament, another object is ahead: the old one,
  // the new one. kTie: the same, because they have become identically level.
  enum Kind : std::uint8_t { kReplace = HullEvents::kKinds, kTie };

  // k >= 1.
  Directions2(Kernel& kernel, StructureId id, const Scene& scene, int k, MaximaChoice choice);

  std::string_view name() const override { return name_; }
  std::vector<std::string_view> event_kinds() const override {
    return HullEvents::kinds({"replace", "tie"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_over() override { settle(); }
  int largest_motion_degree() const override { return maxima_->largest_motion_degree(); }
  int fineness() const override { return k_; }
  // The extreme object in every direction; kNoObject if there is none.
  const std::vector<ObjectId>& extremes() const { return maxima_->winners(); }
  void visit_proof(ProofVisitor& visitor) const override { maxima_->visit_proof(visitor); }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override {
    return maxima_->bytes() + events_.bytes() + between_.capacity() + stale_.capacity();
  }

 private:
  DirectionMaxima::Tied tied() {
    return [this](const DirectionMaxima::Duel& duel) {
      kernel_->report(id_, kTie, {duel.before, duel.after}, false);
    };
  }
  bool is_between(std::size_t direction) const;
  void look_around(std::size_t direction);
  void look_everywhere();
  std::vector<ObjectId> cycle();
  std::vector<ObjectId> polygon() const;
  void begin();
  void settle();

  std::string_view name_;
  int k_;
  std::unique_ptr<DirectionMaxima> maxima_;
  // By direction: its extreme object is level with those of both neighbours, and is no vertex.
  std::vector<std::uint8_t> between_;
  std::vector<std::uint8_t> stale_;  // by direction: between_ has to be found again
};

}  // namespace kinex

#endif
