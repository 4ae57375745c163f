// SPDX-License-Identifier: GPL-3.0-or-later
// ProofRecorder: reads the proofs of structures on pairs of bodies off the live certificates of a
// running simulator, and the tiles off structures that have them.
#ifndef KINEX_EXPERIMENTS_VIEW_PROOF_RECORDER_H
#define KINEX_EXPERIMENTS_VIEW_PROOF_RECORDER_H

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/view/recorded_run.h"

namespace kinex {

class ProofRecorder {
 public:
  // All must outlive it. The run's things, claims and pairs are filled in.
  ProofRecorder(const Scene& scene, Simulator& simulator, RecordedRun& run)
      : scene_(scene), simulator_(simulator), run_(run) {}

  // The number of an object in the record: its own, or its place among the things, counted on from
  // the objects of the scene.
  ObjectId recorded(ObjectId id);
  // Called after each call of the structure: changes are attributed to `event`. O(certificates).
  void look(StructureId id, const Structure& structure, std::uint64_t event);

 private:
  using Pair = std::pair<ObjectId, ObjectId>;
  struct Watched {
    std::uint64_t created = ~std::uint64_t{};  // certificates, when it was last looked at
    std::uint64_t retracted = 0;
    std::map<Pair, std::size_t> place;  // among the pairs of the structure
  };
  Pair pair_of(const Query& query) const;
  std::uint32_t claim(const Query& query, bool of_sum);
  FrameFeature feature(const Query& query, std::size_t argument, std::string_view predicate,
                       bool of_sum) const;
  FrameFeature support(const Query& query, bool second) const;

  const Scene& scene_;
  Simulator& simulator_;
  RecordedRun& run_;
  std::vector<Watched> watched_;    // per structure
  std::vector<ObjectId> thing_of_;  // per derived object, the last one seen
  // By predicate and arguments; equal ones may refer to a sum's lines or to the bodies' own.
  std::map<std::tuple<PredicateId, std::vector<ObjectId>, bool>, std::uint32_t> claims_;
};

}  // namespace kinex

#endif
