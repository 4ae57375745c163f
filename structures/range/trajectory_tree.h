// SPDX-License-Identifier: GPL-3.0-or-later
// TrajectoryTree: orthogonal range search among points in linear motion, at any time, without events:
// a static tree over their trajectories.
//
// Certificates. None, and it reads no other structure. A coordinate of a point is a point of the dual
// plane, and "in this interval at time t" is "in this strip" there (dual_points.h). The primary tree
// is a conjugation tree over the x coordinates; every inner node has a secondary one of its points
// over their y coordinates.
//
//   x    all           crossed: go on below         y    ca | bd      searched with the interval of
//       /   \          inside:  search this     ->      /    \        y, for a node that is inside
//     ab     cd        outside: skip                   ca     bd      in x
//
// Quality, for n points and k reported: O(n^0.695 log n + k) nodes and points looked at, each with
// O(log n) signs; the hard bound is computed from the recurrences. Space expected O(n log n). Points
// that come, go or get another flight plan make the tree stale: the next query builds it anew in
// expected O(n log^3 n) signs of degree 0 in t. (range_tree_2 and the kd-trees take O(log^2 n) an
// event, but have up to n(n-1)/2 events an axis.)
//
// Attribute: the points, ascending. It never changes by itself, and no event is reported.
//
// Ties. Equal trajectories are separated by their ids.
//
// Source: Agarwal, Arge, Erickson, "Indexing moving points" (2003), for search among trajectories;
// Edelsbrunner, Welzl, "Halfplanar range search in linear space and O(n^0.695) query time" (1986),
// for the trees.
#ifndef KINEX_STRUCTURES_RANGE_TRAJECTORY_TREE_H
#define KINEX_STRUCTURES_RANGE_TRAJECTORY_TREE_H

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "structures/parts/range_search.h"
#include "structures/range/conjugation_tree.h"
#include "structures/range/worst_case.h"

namespace kinex {

class TrajectoryTree final : public Structure, public RangeSearch, public TracedSearch {
 public:
  // Throws std::invalid_argument for motions that are not linear.
  TrajectoryTree(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "trajectory_tree"; }
  std::vector<std::string_view> event_kinds() const override { return common_event_kinds({}); }
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override { forest_.reset(); }
  void certificate_failed(CertificateId) override {}  // it has none
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId>) override { forest_.reset(); }
  int largest_motion_degree() const override { return 1; }
  Attribute attribute() const override { return {Attribute::Shape::kSequence, objects_}; }
  // Builds the tree if it is stale.
  void report(ObjectId low, ObjectId high, std::vector<ObjectId>& out,
              QueryCounts& counts) override;
  void trace(ObjectId low, ObjectId high, std::vector<ObjectId>& out, QueryTrace& nodes) override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  void check_invariants(AuditReport& report) const override;
  // The hulls and the answers to some boxes, by exact positions. (A stale tree is built for that.)
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  // The most nodes and points that a query on n points looks at.
  static std::uint64_t most_looked_at(std::uint64_t n);
  // How often it has been built.
  std::uint64_t builds() const { return builds_; }

 private:
  struct Forest {
    ConjugationTrees by_x;  // one tree
    ConjugationTrees by_y;
    ConjugationTrees::Ref root;                 // of by_x
    std::vector<ConjugationTrees::Ref> below;   // per node of by_x: the root of its tree in by_y
    CoordinateTable y;                          // of the objects in the order of by_x
  };

  std::unique_ptr<const Forest> made() const;
  static std::uint64_t search(const Forest& forest, BoxAt& box, std::vector<ObjectId>& out,
                              QueryTrace* trace);
  const Forest& forest();

  Kernel* kernel_;
  std::array<DualPoints, 2> points_;
  std::array<PredicateId, 2> orders_;
  std::vector<ObjectId> objects_;         // ascending
  std::unique_ptr<const Forest> forest_;  // none: stale
  std::uint64_t builds_ = 0;
  WorstCase looked_at_;
};

}  // namespace kinex

#endif
