// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay2: the Delaunay triangulation of moving points in the plane.
//
// Certificates. The triangulation is closed to a sphere by a vertex at infinity, so hull changes
// are flips like all others. One certificate per edge uv with opposite vertices p and q, for
// motions of degree d:
//   all four finite    q is not inside the circle through u, v, p    in_circle_2,   degree 4d
//   p or q infinite    the other one is on the inner side of uv      orientation_2, degree 2d
//   u or v infinite    the hull turns left at the other end          orientation_2, degree 2d
//                      if its turn is identically zero: that end is
//                      between its neighbours on the hull            obtuse_angle_2, degree 2d
// Locally Delaunay everywhere is globally Delaunay (Delaunay 1934).
//
//          p                  p
//        1/ \4              1/|\4        The certificate of uv fails: uv is flipped to pq. The
//        /   \              / | \        four rim edges 1 .. 4 stay, but one opposite vertex of
//       u-----v    --->    u  |  v       each has changed: 5 certificates are renewed.
//        \   /              \ | /
//        2\ /3              2\|/3
//          q                  q
//
// Quality, for n points:
//   compactness     3n - 3 certificates, exactly
//   locality        not local: a point is in one certificate for each of its edges and one for each
//                   edge of its link, up to 2n
//   responsiveness  one flip, 5 certificates; up to 3 more where the hull is identically straight
//   efficiency      every event is external (ratio 1)
// Events, linear motion: each in_circle_2 changes sign at most 4 times and each orientation_2
// twice, so at most 4 C(n,4) + 2 C(n,3); growth O(n^3 2^alpha(n)) (Guibas, Mitchell, Roos 1991).
//
// Ties. The triangulation right after an instant depends on the points' motions and ids alone.
//   identically cocircular   the diagonal that contains the smallest id of the four (so k
//                            cocircular points are a fan from the smallest id)
//   identically collinear    points on a hull edge are hull vertices
//   identically equal        the smallest id is the vertex; the others are hidden behind it
//   all identically on one line, or fewer than three points: a chain along the line, see line_
//
// Degenerate instants. A certificate that fails alone is one flip. Where several fail at one
// instant, triangles may turn over though no certificate shows it (points that meet and pass
// through each other; all points on one line), or the hull may wind around twice afterwards. The
// same may happen where a single certificate fails while others that share two of its points are
// zero without a change of sign (three points that pass through one place at once). At such an
// instant a certificate of the flip's rim is zero.
//   1. A flip is then made only if its edge does not exist yet and both new triangles are upright
//      (positively oriented right after now); otherwise the edge has no certificate for the moment
//      ("blocked").
//   2. When the instant is settled, the triangles around all points that took part and the number
//      of turns of the hull are checked. If all triangles are upright, the hull turns left at every
//      vertex and it turns once in all, this is a triangulation: only then do the angles add up.
//   3. The points of triangles that have turned over are removed and inserted again. Where that is
//      not enough, or not possible, everything is rebuilt, with a reason in the ledger.
//
//           p                   p                   p                   p
//         .'|'.               .'|'.               .'|'.               .'|'.
//       .' / \ '.           .' / \ '.           .' /   '.           .' / \ '.
//      a--v---w--b         a--w===v--b         a--w------b         a--w---v--b
//       '. \ / .'           '. \ / .'           '. \   .'           '. \ / .'
//         '.|.'               '.|.'               '.|.'               '.|.'
//           q                   q                   q                   q
//        before             v has passed w:      v removed, its      v inserted again,
//                           pvw and qwv have     link filled by      where it is now
//                           turned over          ears
//
// Reported events. An external "flip", "enter" or "leave" removes one edge, adds one, or both, as
// its ids say. A "pass" exchanges its two points in every edge. When points are removed and
// inserted again, the net change of edges is reported by one "settled" at the end of the instant,
// or by the "rebuild"; flips in between are then internal. (So are flips to an edge that exists
// already, or from one that exists twice.) The net change is collected edge by edge as edges
// change, so finding it costs no more than the repair. Triangles may change though no edge does (of
// four points another one is now inside): watchers are then notified without an event.
//
// Sources: Guibas, "Kinetic data structures: a state of the art report" (1998), section 7; Guibas,
// Mitchell, Roos, "Voronoi diagrams of moving points in the plane" (1991); insertion: Bowyer
// (1981), Watson (1981); deletion by ears: Devillers (1999).
#ifndef KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_2_H
#define KINEX_STRUCTURES_TRIANGULATION_DELAUNAY_2_H

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/kernel.h"
#include "core/engine/structure.h"
#include "core/motion/scene.h"
#include "structures/parts/kinetic_list.h"
#include "structures/parts/local_pairs.h"
#include "structures/parts/tuple_changes.h"
#include "structures/triangulation/equal_points.h"
#include "structures/triangulation/triangulation_2.h"

namespace kinex {

class Delaunay2 final : public Structure, public LocalPairs {
 public:
  // Kinds of events and their ids. Edges are written smaller id first. The first three are external
  // (see above), and so is kPass if there are more than two points; the others are internal.
  enum Kind : std::uint8_t {
    kFlip,      // removed edge, added edge
    kEnter,     // a point becomes a hull vertex: the point, the hull edge that is removed
    kLeave,     // a point stops being a hull vertex: the point, the hull edge that is added
    kPass,      // on a line: two neighbours change places
    kBlocked,   // at a degenerate instant: no flip is possible yet; the certificate's points
    kReinsert,  // when the instant is settled: a point that was removed and inserted again
  };

  Delaunay2(Kernel& kernel, StructureId id, const Scene& scene);

  std::string_view name() const override { return "delaunay_2"; }
  std::vector<std::string_view> event_kinds() const override;
  void build(std::span<const ObjectId> objects) override;
  void rebuild() override;
  void certificate_failed(CertificateId failed) override;
  void insert(ObjectId object) override;
  void erase(ObjectId object) override;
  void motions_changed(std::span<const ObjectId> objects) override;
  void instant_settled() override;
  void instant_over() override;
  Attribute attribute() const override;
  Attribute told() const override { return untold_.undone(attribute()); }
  void visit_proof(ProofVisitor& visitor) const override;
  std::vector<BoundCheck> bounds(const BoundContext& context) const override;
  // 1000 + 8 c, the part of the limit that all structures have, is already many times the number of
  // flips at the instant at which a sheared lattice becomes square.
  std::uint64_t most_repairs(std::uint64_t) const override { return 0; }
  void check_invariants(AuditReport& report) const override;
  bool holds_at(const Snapshot& snapshot) const override;
  void audit(const Snapshot& snapshot, AuditReport& report) const override;
  std::size_t bytes() const override;

  StructureId id() const { return id_; }
  // The number of the scene's objects, alive or not.
  std::size_t objects() const { return points_.objects(); }
  // Hull vertices counter-clockwise from the smallest id; on a line, the chain.
  std::vector<ObjectId> hull() const;
  // The neighbours of a vertex, counter-clockwise from any. O(degree).
  std::vector<ObjectId> around(ObjectId vertex) const;
  // The same, ascending.
  std::vector<ObjectId> neighbours(ObjectId vertex) const override;
  // The vertex for `object`: itself, or the one it is hidden behind; kNoObject: not present.
  ObjectId representative(ObjectId object) const { return points_.vertex_of(object); }
  bool on_line() const { return on_line_; }
  // Which edges may have come or gone; nullptr: all may have, for the points are on one line.
  const EdgeJournal* journal() const { return on_line_ ? nullptr : &store_.journal(); }
  std::uint64_t hidden_changes() const { return points_.hidden_changes(); }
  // Requires that the points are not on one line. O(degree of a).
  bool has_edge(ObjectId a, ObjectId b) const { return store_.between(a, b) != kNone; }
  // The number of points removed and inserted again at degenerate instants.
  std::uint64_t reinsertions() const { return reinsertions_; }

 private:
  using HalfEdge = Triangulation2::HalfEdge;
  using Triangle = Triangulation2::Triangle;
  static constexpr std::uint32_t kNone = Triangulation2::kNone;

  // ---- delaunay_2.cpp: certificates and flips
  Query query_of(HalfEdge h) const;
  // For a hull vertex whose turn is identically zero, by its edge to infinity.
  Query straight_query_of(HalfEdge h) const;
  bool at_infinity(HalfEdge h) const {
    return store_.origin(h) == store_.infinity() || store_.target(h) == store_.infinity();
  }
  bool is_straight(HalfEdge h) const;
  void set_straight(HalfEdge h);
  void follow_turn(HalfEdge h);
  bool holds_claim(HalfEdge h) const;
  void set_certificate(HalfEdge h);
  void set_certificates(const std::array<HalfEdge, 4>& edges);
  void note_outlook(HalfEdge h, Outlook outlook);
  void drop_certificate(HalfEdge h);
  bool rim_vanishes(HalfEdge h);
  void prefetch_next() const;
  void prefetch_rim(HalfEdge h) const;
  void prefetch_points(std::array<ObjectId, 4> points) const;
  bool flippable(HalfEdge h) const;
  void flip(HalfEdge h);
  void settle_ties(bool report);
  void report_flip(ObjectId u, ObjectId v, ObjectId p, ObjectId q, bool degenerate);
  int edges_between(ObjectId a, ObjectId b) const;
  bool wants_other_diagonal(HalfEdge h) const;
  void pass(CertificateId failed);
  void blocked(HalfEdge h, bool shared);
  Sign turn(ObjectId a, ObjectId b, ObjectId c) const {
    return kernel_->sign_after(orientation_, {a, b, c});
  }
  // A ghost, or positively oriented right after now.
  bool upright(ObjectId a, ObjectId b, ObjectId c) const;
  bool upright(Triangle t) const;
  void give_up(const std::string& what);

  // ---- delaunay_2_build.cpp: the static algorithm
  void construct();
  void rebuild_because(const std::string& reason);
  void remake_line(const std::string& reason);
  void note_edges(const std::vector<Triangle>& cavity, std::uint32_t inside);
  void retract_all();
  std::vector<std::uint32_t> ranks(const std::vector<ObjectId>& objects, PredicateId order) const;
  void build_plane(const std::vector<ObjectId>& order);

  // ---- delaunay_2_points.cpp: one point more or less
  enum class Insertion { kVertex, kHidden, kFailed };
  struct Place {
    Triangle triangle = kNone;   // a triangle in conflict with the point, or
    ObjectId equal = kNoObject;  // the vertex that is equal to it
  };
  bool identical(ObjectId a, ObjectId b) const;
  bool strictly_between(ObjectId d, ObjectId a, ObjectId b) const;
  bool conflict(ObjectId a, ObjectId b, ObjectId c, ObjectId d) const;
  bool conflict(Triangle t, ObjectId d) const;
  Place locate(ObjectId d, HalfEdge hint) const;
  // `careful`: the triangulation may be invalid elsewhere; certificates are kept up to date, too.
  Insertion add_point(ObjectId d, HalfEdge hint, bool careful);
  bool remove_vertex(ObjectId v);
  bool plan_ears();
  bool is_ear(std::uint32_t corner);
  bool ears_fit();

  // ---- delaunay_2_update.cpp: changes from outside and degenerate instants
  void suspect(ObjectId v) {
    if (v != store_.infinity()) suspects_.push_back(v);
  }
  void put_in_anywhere(ObjectId object);
  void take_out_anywhere(ObjectId object);
  bool put_in(ObjectId object);
  bool take_out(ObjectId vertex);
  bool reexamine_hidden();
  bool collect_turned(std::vector<Triangle>& turned);
  bool mend();
  bool hull_turns_once() const;
  void restore_certificates();

  Kernel* kernel_;
  StructureId id_;
  bool exact_;  // the arithmetic
  PredicateId order_[2];
  PredicateId orientation_;
  PredicateId in_circle_;
  PredicateId obtuse_;
  Slots edges_;  // tag: a half-edge; the slot is its label
  Kernel::Group renewed_;  // of set_certificates(): kept, since a new one would be filled with zeros
  Ties ties_;    // edges to be compared with the rule for cocircular points

  Triangulation2 store_;
  EqualPoints points_;
  HalfEdge hint_ = kNone;  // where the last point went

  // All points on one line right after now, in order along it: by x, or by y if all x are identically
  // equal. There are no ties: equal points are hidden.
  struct AlongLine {
    PredicateId order;
    Query claim(ObjectId a, ObjectId b) const { return Query(order, {a, b}); }
    bool goes_first(ObjectId a, ObjectId b) const { return a < b; }
  };
  bool on_line_ = true;
  KineticList<AlongLine> line_;

  // The present instant.
  bool fails_now_ = false;      // a certificate was made that is negative right after now
  bool rim_is_zero_ = false;    // of the last flip: a rim certificate is zero at now
  EdgeChanges untold_;          // of the attribute, not reported by events
  bool comes_or_goes_ = false;  // during an insertion or erasure, which reports its changes itself
  std::vector<ObjectId> suspects_;
  std::vector<ObjectId> moved_;
  std::array<ObjectId, 4> last_quad_{};
  bool has_last_quad_ = false;
  bool blocked_ = false;  // a flip was impossible: an edge is without certificate
  int retries_ = 0;       // of impossible flips
  static constexpr int kMostRetries = 2;

  // Inexact arithmetics: repairs since the last ordinary flip, and the limit.
  int repairs_ = 0;
  static constexpr int kMostRepairs = 64;
  bool corrupt_ = false;
  bool certify_ = true;  // false while the static algorithm runs: certificates come at its end
  std::uint64_t tie_flips_ = 0;
  bool straight_ = false;  // a hull vertex has had a turn that was identically zero
  std::uint64_t reinsertions_ = 0;
  bool mended_ = false;  // at this instant points were put in or taken out

  // scratch
  std::vector<std::uint32_t> mark_;  // per triangle
  std::uint32_t epoch_ = 0;
  std::vector<Triangle> cavity_, filled_;
  std::vector<HalfEdge> rim_, link_;
  std::vector<ObjectId> corners_;
  std::vector<std::uint32_t> corner_next_, corner_previous_, witness_;
  std::vector<ObjectId> beyond_;
  std::vector<Triangulation2::Ear> ears_;
};

}  // namespace kinex

#endif
