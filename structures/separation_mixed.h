// SPDX-License-Identifier: GPL-3.0-or-later
// SeparationMixed: separation-sensitive collision detection by the mixed hierarchy, and, for
// translation alone, by the hierarchy of the Minkowski sum itself.
//
// B as seen from A is one point moving outside the Minkowski sum M of A and R B'. The proof is the
// tile of the exterior's hierarchy that holds the point (structures/mixed_tiles.h): far from M
// tiles are large.
//   separation_mixed      the mixed hierarchy, for rigid motions; never built whole
//   separation_minkowski  the hierarchy of M (separation_minkowski.h); only where nothing turns
//
// Quality. Compactness: at most 6 certificates a pair, O(n) for the trees. Responsiveness: O(depth)
// signs and at most 6 new certificates an event. In numbers: a failure takes at most 2 (l + 1) + 33
// signs, l the larger level of the tile that is left and that which is entered (kSignsPerLevel,
// kSigns), and 24 more where the bodies touch (kSignsOfTouch); unless the point is located anew,
// which may be at a contact. Events, for motions of constant degree at distance
// sigma or more, mu = min(n, sqrt(D / sigma)): O(mu^2) for rigid motion, O(mu) for translation; for
// separation_minkowski on a line at most 2 per level, O(log mu).
//
// Source: Erickson, Guibas, Stolfi, Zhang, Separation-sensitive collision detection for convex
// objects (1999).
#ifndef KINEX_STRUCTURES_SEPARATION_MIXED_H
#define KINEX_STRUCTURES_SEPARATION_MIXED_H

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "structures/collision_pairs.h"
#include "structures/hierarchy_bounds.h"
#include "structures/mixed_tiles.h"

namespace kinex {

class SeparationMixed : public CollisionPairs {
 public:
  enum Kind : std::uint8_t {
    kSide = kFirstOwn,  // the point has crossed a side
    kFlip,              // the two tiles about it were divided anew
    kCell,              // it has moved between half-planes, into the boxes or out of them
  };
  // Of one failure. A descent asks at most for two signs at each level of one polygon. The rest: 1
  // and 2 for the certificate that failed and its tile, 4 to choose one of two sides that fail
  // together, 1 for the neighbour and at most 5 for edges without length (a vertex has no more than
  // two of these) and at the descent's end, 2 and 1 at the boundary of M, 9 for the certificates of
  // the new tile and of a slide, 8 to see whether the bodies touch. Where they do: 8 to see that
  // the proof holds, 8 for its other certificates that touch zero, 8 to see whether they rest; or,
  // at a contact, a few orders of normals to find the edge of M that is ahead.
  static constexpr std::uint64_t kSignsPerLevel = 2, kSigns = 33, kSignsOfTouch = 24;

  SeparationMixed(Kernel& kernel, StructureId id, const Scene& scene,
                  CutPolicy policy = CutPolicy::kBalancedDudley);

  std::string_view name() const override { return "separation_mixed"; }
  void certificate_failed(CertificateId failed) override;
  std::vector<std::string_view> event_kinds() const override;
  // Also those of the hierarchies that were built (structures/hierarchy_bounds.h).
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  std::size_t bytes() const override;

  // The tile of the pair (a, b), a < b; nullopt if it is not followed.
  std::optional<Tile> tile(ObjectId a, ObjectId b) const;

 protected:
  bool start(PairId p) override;
  bool leave(PairId p, const SumBoundary::Edge& edge) override;
  void fail(PairId p, std::uint32_t slot) override;
  std::uint32_t most_certificates() const override {
    return MixedTiles::kMost + slide_certificates();
  }
  std::optional<Features> touch(PairId p, SignNow* now) override;
  // The features of the two bodies that meet.
  virtual Features features(PairId p, const MixedTiles::Move& contact);
  // The two hierarchies of a pair.
  virtual std::array<BodyFrame*, 2> frames_of(PairId p);
  virtual void add_hierarchies(HierarchyBounds& bounds) const;

  void moved(PairId p) override;
  // More, where a point stays on the line of a side of M.
  std::uint32_t slide_certificates() const { return slides_ ? 2 : 0; }

 private:
  // Signs of this structure's predicates that have been asked for.
  std::uint64_t signs_asked() const;
  MixedTiles tiles(PairId p);
  // The certificates of the tile, and of a slide along its side; their number.
  using Proof = std::array<Query, kMostCertificates>;
  std::uint32_t prove(const MixedTiles& about, const Tile& tile, Proof& queries);
  void enter(PairId p, const MixedTiles& about, const Tile& tile);

  std::vector<Tile> tile_;  // per pair
  bool slides_ = false;     // a point has stayed on the line of a side of M
  // While a failure is handled: the level it has to do with, if it is a tile's and the point need
  // not be located; whether the bodies touch.
  std::optional<int> level_;
  bool touches_ = false;
  // The failure that came nearest to its bound.
  std::uint64_t most_signs_ = 0, signs_bound_ = kSigns;
};

}  // namespace kinex

#endif
