// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/proof_recorder.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "predicates/bodies/pose_2.h"
#include "structures/collision/body_grid.h"
#include "structures/collision/collision_pairs.h"
#include "structures/collision/separation_minkowski.h"
#include "structures/collision/separation_mixed.h"

namespace kinex {

namespace {

// The roles of the arguments of a predicate on a pose: lines and points of the first body or of the
// second one, which is negated.
enum class Role : std::uint8_t { kNone, kLine, kPoint };
struct Argument {
  Role role = Role::kNone;
  bool second = false;
};
Argument argument_of(std::string_view predicate, std::size_t i) {
  if (i == 0) return {};
  if (predicate.starts_with("normal_order")) return {Role::kLine, i == 2};
  // The first two are points inside of the polygons.
  if (predicate.ends_with("_of_ray")) return {i > 2 ? Role::kPoint : Role::kNone, i == 4};
  if (predicate != "side_a" && predicate != "inside_a" && predicate != "side_b" &&
      predicate != "inside_b") {
    return {};
  }
  const bool line_of_second = predicate.back() == 'b';
  return {i == 1 ? Role::kLine : Role::kPoint, (i == 1) == line_of_second};
}

}  // namespace

const PairProof* proof_after(const PairHistory& history, std::uint64_t event) {
  const auto next = std::upper_bound(
      history.proofs.begin(), history.proofs.end(), event,
      [](std::uint64_t number, const PairProof& proof) { return number < proof.event; });
  return next == history.proofs.begin() ? nullptr : &*(next - 1);
}

ObjectId ProofRecorder::recorded(ObjectId id) {
  const std::size_t objects = scene_.objects.size();
  if (id < objects) return id;
  const std::size_t place = id - objects;
  if (thing_of_.size() <= place) thing_of_.resize(place + 1, kNoObject);
  const DerivedObjects::Object& object = simulator_.kernel().derived().object(id);
  ObjectId& thing = thing_of_[place];
  if (thing != kNoObject && run_.things[thing - objects].name == object.name) return thing;
  thing = static_cast<ObjectId>(objects + run_.things.size());
  RecordedThing& made = run_.things.emplace_back();
  made.name = object.name;
  if (object.construction == nullptr) {
    for (const auto& axis : object.trajectory.coordinates) made.coordinates.push_back(axis[0]);
  }
  return thing;
}

// The pair that a certificate is about: the bases of its pose, or the two bodies it names.
ProofRecorder::Pair ProofRecorder::pair_of(const Query& query) const {
  const DerivedObjects& derived = simulator_.kernel().derived();
  ObjectId a = query.ids[0], b = query.ids[1];
  if (derived.is_derived(a)) {
    const std::vector<ObjectId>& bases = derived.object(a).bases;
    a = bases[0];
    b = bases[1];
  }
  return {std::min(a, b), std::max(a, b)};
}

// Without turning: the farthest feature of the body in the direction of a line of the sum.
FrameFeature ProofRecorder::support(const Query& query, bool second) const {
  const DerivedObjects& derived = simulator_.kernel().derived();
  const std::vector<ObjectId>& bases = derived.object(query.ids[0]).bases;
  const auto& line = derived.trajectory(query.ids[1]).coordinates;
  std::array<Rational, 2> m{line[0][0], line[1][0]};
  if (second) {  // R^T m, up to a positive factor
    const Trajectory& pose = derived.trajectory(query.ids[0]);
    const Rational t = simulator_.reached();
    if (pose.position(4, t).is_zero()) return {};
    const Rational c = pose.position(5, t), s = pose.position(6, t);
    m = {c * m[0] + s * m[1], c * m[1] - s * m[0]};
  }
  return support_feature(scene_.objects[bases[second ? 1 : 0]].polygon, second, m);
}

FrameFeature ProofRecorder::feature(const Query& query, std::size_t argument,
                                    std::string_view predicate, bool of_sum) const {
  const Argument is = argument_of(predicate, argument);
  if (is.role == Role::kNone) return {};
  if (of_sum) return support(query, is.second);
  const DerivedObjects& derived = simulator_.kernel().derived();
  const ObjectId body = derived.object(query.ids[0]).bases[is.second ? 1 : 0];
  const std::vector<Vertex2>& polygon = scene_.objects[body].polygon;
  std::vector<Rational> numbers;
  for (const auto& axis : derived.trajectory(query.ids[argument]).coordinates) {
    numbers.push_back(axis[0]);
  }
  numbers.resize(3);
  return is.role == Role::kLine ? line_feature(polygon, is.second, numbers)
                                : point_feature(polygon, is.second, numbers);
}

std::uint32_t ProofRecorder::claim(const Query& query, bool of_sum) {
  std::vector<ObjectId> arguments;
  for (std::size_t i = 0; i < query.arity; ++i) arguments.push_back(recorded(query.ids[i]));
  const auto [known, is_new] = claims_.try_emplace({query.predicate, arguments, of_sum},
                                                   static_cast<std::uint32_t>(run_.claims.size()));
  if (is_new) {
    RecordedClaim& made = run_.claims.emplace_back();
    made.predicate = query.predicate;
    made.arguments = std::move(arguments);
    const std::string_view name =
        simulator_.arithmetic().predicate(query.predicate).name();
    for (std::size_t i = 0; i < query.arity; ++i) {
      made.features.push_back(feature(query, i, name, of_sum));
    }
  }
  return known->second;
}

void ProofRecorder::look(StructureId id, const Structure& structure, std::uint64_t event) {
  if (watched_.size() <= id) watched_.resize(run_.structures.size());
  Watched& watched = watched_[id];
  const StructureLedger& ledger = simulator_.ledger(id);
  if (watched.created == ledger.certificates_created &&
      watched.retracted == ledger.certificates_retracted)
    return;
  watched.created = ledger.certificates_created;
  watched.retracted = ledger.certificates_retracted;
  const EventQueue& queue = simulator_.queue();
  std::vector<std::pair<std::uint32_t, CertificateId>> live;
  for (CertificateId c = 0; c < queue.capacity(); ++c) {
    const Certificate& certificate = queue.certificate(c);
    if (!certificate.live || certificate.structure != id) continue;
    if ((certificate.tag & BodyGrid::kTag) == 0) live.emplace_back(certificate.tag, c);
  }
  std::sort(live.begin(), live.end());
  const auto* sums = dynamic_cast<const SeparationMinkowski*>(&structure);
  const auto* tiles = dynamic_cast<const SeparationMixed*>(&structure);
  std::vector<PairHistory>& histories = run_.structures[id].pairs;
  std::vector<PairProof> now(histories.size());
  for (const auto& [tag, c] : live) {
    const Query& query = queue.certificate(c).query;
    const Pair pair = pair_of(query);
    const auto [known, is_new] = watched.place.try_emplace(pair, histories.size());
    if (is_new) {
      histories.push_back({pair.first, pair.second, {}});
      now.emplace_back();
    }
    PairProof& proof = now[known->second];
    if (tiles != nullptr && simulator_.kernel().derived().is_derived(query.ids[0])) {
      proof.tile = tiles->tile(pair.first, pair.second);
    }
    // While two bodies overlap the lines are their own.
    const bool of_sum = sums != nullptr && !sums->in_contact(pair.first, pair.second);
    proof.claims.push_back(claim(query, of_sum));
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::vector<PairProof>& proofs = histories[i].proofs;
    if (!proofs.empty() && proofs.back().claims == now[i].claims &&
        proofs.back().tile == now[i].tile) {
      continue;
    }
    now[i].event = event;
    // Two looks at one event: the second one sees its result.
    if (!proofs.empty() && proofs.back().event == event) proofs.pop_back();
    proofs.push_back(std::move(now[i]));
  }
}

}  // namespace kinex
