// SPDX-License-Identifier: GPL-3.0-or-later
// ProofRecorder: records the proofs of all structures of a running simulator, through
// Structure::visit_proof (core/engine/proof.h).
#ifndef KINEX_EXPERIMENTS_VIEW_PROOF_RECORDER_H
#define KINEX_EXPERIMENTS_VIEW_PROOF_RECORDER_H

#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/engine/simulator.h"
#include "experiments/view/recorded_run.h"

namespace kinex::view {

class ProofRecorder {
 public:
  // The recording of a structure's proof ends after this many visits of certificates and groups, so
  // that pages stay small enough for browsers and recordings end.
  static constexpr std::uint64_t kMostVisits = 30'000'000;

  // All arguments must outlive it. It fills in the run's things, claims and proofs.
  ProofRecorder(const Scene& scene, Simulator& simulator, RecordedRun& run,
                std::uint64_t most_visits = kMostVisits)
      : scene_(scene), simulator_(simulator), run_(run), most_visits_(most_visits) {}

  // The number of an object in the record: its id if it is one of the scene; a derived object is
  // numbered after those; one that got another name gets another number.
  ObjectId recorded(ObjectId id);
  // To be called after each call of the structure. Changes are attributed to `event`. `reported`:
  // the call reported an event. O(certificates), if anything may have changed.
  void look(StructureId id, const Structure& structure, std::uint64_t event, bool reported);

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  using GroupKey = std::pair<std::uint64_t, std::vector<ObjectId>>;  // its place, or its objects
  struct KeyHash {
    std::size_t operator()(const GroupKey& key) const;
  };
  struct KnownGroup {
    std::uint32_t state = kNone;  // place of its present state; kNone: it is not there
    std::uint64_t seen = 0;       // at this look
    const GroupKey* key = nullptr;
  };
  struct KnownCertificate {
    std::uint32_t number = kNone;  // in the record; kNone: it is not there
    Query query;
    std::uint64_t seen = 0;
  };
  struct Watched {
    std::uint64_t created = ~std::uint64_t{};  // certificates, when it was last looked at
    std::uint64_t retracted = 0;
    std::uint64_t looks = 0, visits = 0;
    std::unordered_map<GroupKey, std::uint32_t, KeyHash> numbers;  // of groups
    std::vector<KnownGroup> groups;              // by number
    std::vector<KnownCertificate> certificates;  // by CertificateId
    std::vector<std::uint32_t> live_groups;
    std::vector<CertificateId> live;
  };
  class Visit;

  void add(StructureId id, ProofChange change);
  ProofGroup recorded(ProofGroup group);
  std::uint32_t claim(const Query& query, bool of_sum);
  FrameFeature feature(const Query& query, std::size_t argument, const ClaimForm& form,
                       bool of_sum) const;
  FrameFeature support(const Query& query, bool second) const;
  void note_outlook(CertificateId id, RecordedCertificate& certificate) const;

  const Scene& scene_;
  Simulator& simulator_;
  RecordedRun& run_;
  const std::uint64_t most_visits_;
  std::vector<Watched> watched_;    // per structure
  std::vector<ObjectId> thing_of_;  // per derived object, the last one seen
  // By predicate and arguments; equal ones may refer to a sum's lines or to the bodies' own.
  std::map<std::tuple<PredicateId, std::vector<ObjectId>, bool>, std::uint32_t> claims_;
};

}  // namespace kinex::view

#endif
