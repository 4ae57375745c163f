// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationMinkowski: separation-sensitive collision detection of bodies that do not turn against
// each other, by the hierarchy of their Minkowski sum M itself.
//
// Seen from A, B is a point that moves outside the fixed convex polygon M. The proof is the tile of
// the exterior's hierarchy that holds the point: a triangle, 3 certificates, or a half-plane beyond
// the box, 1 certificate. The ring between two stages is the difference of two convex sets, so a
// straight line meets it in at most two intervals, each inside one triangle: events, while a pair
// is followed, are at most 2 per level and 8 beyond the box.
//
// Certificates, ties and sources: separation_mixed.h, of which this is the special case where the
// second polygon is a point. Cost: O(n) to build M and O(n depth) for its hierarchy, for every
// pair.
#ifndef KINEX_STRUCTURES_COLLISION_SEPARATION_MINKOWSKI_H
#define KINEX_STRUCTURES_COLLISION_SEPARATION_MINKOWSKI_H

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "predicates/bodies/minkowski_sum.h"
#include "structures/collision/separation_mixed.h"

namespace kinex {

class SeparationMinkowski final : public SeparationMixed {
 public:
  SeparationMinkowski(Kernel& kernel, StructureId id, const Scene& scene,
                      CutPolicy policy = CutPolicy::kBalancedDudley);

  std::string_view name() const override { return "separation_minkowski"; }
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::size_t bytes() const override;

 protected:
  Roles describe(PairId p, ProofGroup& group) const override;
  std::string tile_text(PairId p, const Tile& tile) const override;
  // Throws std::invalid_argument if the bodies turn against each other.
  bool start(PairId p) override;
  bool leave(PairId p, const SumBoundary::Edge& edge) override {
    static_cast<void>(edge);
    return start(p);
  }
  void fail(PairId p, std::uint32_t slot) override;
  void stop(PairId p) override;
  std::uint32_t most_certificates() const override { return 3 + slide_certificates(); }
  std::array<BodyFrame*, 2> frames_of(PairId p) override {
    return {sums_[p]->frame.get(), &point_};
  }
  Features features(PairId p, const MixedTiles::Move& move) override;
  void add_hierarchies(HierarchyBounds& bounds) const override;

 private:
  struct Sum {
    MinkowskiSum sum;
    std::unique_ptr<BodyFrame> frame;
    bool is_line = false;  // the point moves on a straight line
    std::int64_t failures = 0;
  };
  // The failures while a pair was followed, and their bound.
  struct Line {
    std::int64_t failures = 0, most = 0;
  };

  void note_line(const Sum& sum);

  CutPolicy policy_;
  BodyFrame point_;
  std::vector<std::unique_ptr<Sum>> sums_;  // per pair
  HierarchyBounds past_;                    // of sums that are gone
  std::optional<Line> line_;                // the one that came nearest to its bound
};

}  // namespace kinex

#endif
