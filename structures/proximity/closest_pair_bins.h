// SPDX-License-Identifier: GPL-3.0-or-later
// ClosestPairBins: the closest pair of moving points in the plane, among points in near cells of a
// grid.
//
// The points never leave a box that holds all flight plans. It is cut into fewer squares than there
// are points (point_grid.h), so two points share a square. A closest pair is therefore at most two
// columns and two rows apart, as in this part of a grid:
//
//     +-----+-----+-----+-----+      b, c: one square, so |bc| <= sqrt(2) W
//     | a   |     |     | e   |      a, e: three columns apart, so |ae| >= 2 W > |bc|, and they are
//     +-----+-----+-----+-----+            no closest pair
//     |     |     | b c |     |      pairs compared: a with b and c, b with c and e, c with e
//     +-----+-----+-----+-----+
//                 |< W >|
//
// Certificates.
//   a point is on its side of the lines around its cell: at most 4n, degree d for motions of degree
//   d
//   the shortest of the pairs of points in near cells, by a ChangingExtremum: one fewer than pairs,
//   degree 2d
//
// Quality, for n points: points that are far from each other share no certificate. n points that
// spread over the box have O(n) pairs and move through O(n^(3/2)) cells in all while each crosses
// the box once; n points in one cell have all C(n, 2) pairs, as closest_pair_all. A point that moves
// to another cell renews O(log n) certificates for each pair that comes or goes. The grid is laid
// anew when there are no more points than squares, or more than four times as many.
//
// Requires a scene with an end: otherwise there is no box. The box is that of the scene's own flight plans, so
// Simulator refuses others during the run.
//
// Ties. Of pairs whose distances are identically equal the lexicographically smallest one.
//
// Source: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7, remarks
// that sorted lists pay for exchanges of points that are far from each other. The grid is ours.
#ifndef KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_BINS_H
#define KINEX_STRUCTURES_PROXIMITY_CLOSEST_PAIR_BINS_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/structure.h"
#include "structures/parts/front_pair.h"
#include "structures/parts/pair_distances.h"
#include "structures/proximity/point_grid.h"

namespace kinex {

class ClosestPairBins final : public FrontPair<PairDistances> {
 public:
  // A point has moved to another cell.
  static constexpr std::uint8_t kCell = kTie + 1;

  ClosestPairBins(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "closest_pair_bins"; }
  std::vector<std::string_view> event_kinds() const override {
    return common_event_kinds({"replace", "tie", "cell"});
  }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  // After the scene's end points may be beyond the box.
  bool holds_at(const Snapshot& snapshot) const override { return grid_.has_small_cells(snapshot); }
  bool takes_other_plans() const override { return false; }
  std::size_t bytes() const override;

 private:
  // Columns and rows between two points that may be the closest of more points than squares.
  static constexpr std::int64_t kReach = 2;

  ClosestPairBins(Kernel& kernel, StructureId id, PointGrid grid);
  std::vector<Pair> near_pairs() const;
  void lay(std::size_t squares);

  PointGrid grid_;
  std::vector<ObjectId> members_;  // ascending
  std::size_t most_lines_ = 0, layings_ = 0;
};

}  // namespace kinex

#endif
