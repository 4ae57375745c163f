// SPDX-License-Identifier: GPL-3.0-or-later
// DirectionMaxima: the extreme object in each of a set of directions, which come in opposite pairs.
//
// It holds the certificates of the structure that maintains them, which passes failures and changes
// on to it. Certificates: "the winner is at least as far in direction u_i as that one", degree d in
// t for motions of degree d.
//
//   LineMaxima         the dual hull of linear motions (LineHull): one certificate a direction; a
//                      failure is another winner, O(1); an insertion, erasure or new flight plan
//                      O(log^2 n) signs a direction
//   TournamentMaxima   a KineticTournament a direction, for motions of any degree: n - 1
//                      certificates each; a failure O(log n)
//
// Ties. Of objects that are identically level in a direction the smallest id is extreme there.
#ifndef KINEX_STRUCTURES_EXTENT_DIRECTION_MAXIMA_H
#define KINEX_STRUCTURES_EXTENT_DIRECTION_MAXIMA_H

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/engine/audit.h"
#include "core/engine/bound.h"
#include "core/engine/kernel.h"
#include "core/engine/proof.h"
#include "core/motion/scene.h"
#include "predicates/points/unit_directions.h"
#include "structures/parts/key_order.h"

namespace kinex {

class DirectionMaxima {
 public:
  // Two objects that have changed places in a direction: the one that was in front, and the one
  // that is. They are winners only where the winner has changed.
  struct Duel {
    std::size_t direction;
    ObjectId before, after;
  };
  using Tied = std::function<void(const Duel&)>;

  virtual ~DirectionMaxima() = default;
  // The number of directions. Direction i + size() / 2 is the opposite of direction i.
  std::size_t size() const { return winners_.size(); }
  std::size_t opposite(std::size_t i) const { return (i + size() / 2) % size(); }
  // The extreme object; kNoObject if there is none.
  ObjectId winner(std::size_t i) const { return winners_[i]; }
  const std::vector<ObjectId>& winners() const { return winners_; }
  // True if a and b are identically level in direction i.
  virtual bool level(std::size_t i, ObjectId a, ObjectId b) const = 0;

  // `tied` is called for objects that are identically level from now on and change places.
  void build(std::span<const ObjectId> objects, const Tied& tied) {
    for (std::size_t i = 0; i < size(); ++i) winners_[i] = built(i, objects, tied);
  }
  void rebuild(const Tied& tied) {
    for (std::size_t i = 0; i < size(); ++i) winners_[i] = rebuilt(i, tied);
  }
  // A certificate for which owns() is true has failed.
  virtual bool owns(CertificateId certificate) const = 0;
  virtual Duel failed(CertificateId certificate, const Tied& tied) = 0;
  void insert(ObjectId object, const Tied& tied) {
    for (std::size_t i = 0; i < size(); ++i) winners_[i] = inserted(i, object, tied);
  }
  void erase(ObjectId object, const Tied& tied) {
    for (std::size_t i = 0; i < size(); ++i) winners_[i] = erased(i, object, tied);
  }
  void motions_changed(std::span<const ObjectId> objects, const Tied& tied) {
    for (std::size_t i = 0; i < size(); ++i) winners_[i] = moved(i, objects, tied);
  }

  virtual int largest_motion_degree() const = 0;
  // Hard bounds: on live certificates, on those of one object, on failures so far.
  virtual Integer most_certificates(const BoundContext& context) const = 0;
  virtual Integer most_per_object(const BoundContext& context) const = 0;
  virtual Integer most_failures(const BoundContext& context) const = 0;
  virtual void visit_proof(ProofVisitor& visitor) const = 0;
  virtual void check(AuditReport& report) const = 0;
  virtual std::size_t bytes() const = 0;

 protected:
  explicit DirectionMaxima(std::size_t directions) : winners_(directions, kNoObject) {}

  // Of each direction in its order: the position along it, and which end of the order wins.
  template <class Visit>
  static void each_direction(const std::vector<DirectionVector>& half, const Visit& visit) {
    for (const Extremum extremum : {Extremum::kMaximum, Extremum::kMinimum}) {
      for (const DirectionVector& u : half) {
        Key key;
        key.kind = Key::Kind::kDirection;
        key.direction = u;
        visit(key, extremum);
      }
    }
  }
  // The changes of one direction. Each returns its winner.
  virtual ObjectId built(std::size_t i, std::span<const ObjectId> objects, const Tied& tied) = 0;
  virtual ObjectId rebuilt(std::size_t i, const Tied& tied) = 0;
  virtual ObjectId inserted(std::size_t i, ObjectId object, const Tied& tied) = 0;
  virtual ObjectId erased(std::size_t i, ObjectId object, const Tied& tied) = 0;
  virtual ObjectId moved(std::size_t i, std::span<const ObjectId> objects, const Tied& tied) = 0;

  std::vector<ObjectId> winners_;  // by direction
};

// Do scenes of linear motion have their maxima by LineMaxima?
enum class MaximaChoice { kByDegree, kTournaments };

// `half`: one of each pair of opposite directions. Throws std::invalid_argument for more than a
// structure has parts for (Kernel::add_part).
std::unique_ptr<DirectionMaxima> make_direction_maxima(Kernel& kernel, StructureId structure,
                                                       const Scene& scene,
                                                       const std::vector<DirectionVector>& half,
                                                       MaximaChoice choice);

}  // namespace kinex

#endif
