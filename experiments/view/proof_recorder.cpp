// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/proof_recorder.h"

#include <algorithm>
#include <array>
#include <optional>

namespace kinex::view {

std::size_t ProofRecorder::KeyHash::operator()(const GroupKey& key) const {
  std::uint64_t hash = key.first;
  for (const ObjectId id : key.second) hash = (hash ^ id) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
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
  made.feature = object.feature;
  if (object.construction == nullptr) {
    for (const auto& axis : object.trajectory.coordinates) made.coordinates.push_back(axis[0]);
  }
  return thing;
}

ProofGroup ProofRecorder::recorded(ProofGroup group) {
  for (ObjectId& id : group.about) id = recorded(id);
  for (ProofMark& mark : group.marks) {
    for (ObjectId& id : mark.objects) id = recorded(id);
  }
  return group;
}

// The farthest feature of a body in the direction of a line of the sum.
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

FrameFeature ProofRecorder::feature(const Query& query, std::size_t argument, const ClaimForm& form,
                                    bool of_sum) const {
  if (argument >= form.roles.size()) return {};
  const ArgumentRole& role = form.roles[argument];
  const bool line = role.kind == ArgumentRole::Kind::kFrameLine;
  if (!line && role.kind != ArgumentRole::Kind::kFramePoint) return {};
  const bool second = role.frame == 1;
  if (of_sum) return support(query, second);
  const DerivedObjects& derived = simulator_.kernel().derived();
  const ObjectId body = derived.object(query.ids[0]).bases[role.frame];
  const std::vector<Vertex2>& polygon = scene_.objects[body].polygon;
  std::vector<Rational> numbers;
  for (const auto& axis : derived.trajectory(query.ids[argument]).coordinates) {
    numbers.push_back(axis[0]);
  }
  numbers.resize(3);
  return line ? line_feature(polygon, second, numbers) : point_feature(polygon, second, numbers);
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
    const ClaimForm form = simulator_.arithmetic().predicate(query.predicate).form();
    for (std::size_t i = 0; i < query.arity; ++i) {
      made.features.push_back(feature(query, i, form, of_sum));
    }
  }
  return known->second;
}

void ProofRecorder::note_outlook(CertificateId id, RecordedCertificate& certificate) const {
  const EventQueue& queue = simulator_.queue();
  certificate.outlook = queue.certificate(id).outlook;
  if (!queue.queued(id)) return;
  const FailureTime time = queue.time(id);
  certificate.time = time.lo + (time.hi - time.lo) / 2;
}

// One look at a proof: compares what the structure shows with what is known.
class ProofRecorder::Visit final : public ProofVisitor {
 public:
  Visit(ProofRecorder& recorder, StructureId id, Watched& watched)
      : recorder_(recorder),
        proof_(recorder.run_.structures[id].proof),
        watched_(watched),
        look_(++watched.looks) {}

  void group(const ProofGroup& group) override {
    ++watched_.visits;
    slot_ = 0;
    of_sum_ = group.of_sum;
    if (is_as_before(group)) return;
    key_.first = group.place;
    if (group.place == ProofGroup::kNoPlace) {
      key_.second = group.about;
    } else {
      key_.second.clear();
    }
    number_ = number_of_key();
    groups_.push_back(number_);
    KnownGroup& known = watched_.groups[number_];
    known.seen = look_;
    ProofGroup now = recorder_.recorded(group);
    if (known.state != kNone && proof_.groups[known.state].state == now) return;
    known.state = static_cast<std::uint32_t>(proof_.groups.size());
    proof_.groups.push_back({number_, std::move(now)});
    change.states.push_back(known.state);
  }

  void certificate(CertificateId id, std::string_view role) override {
    ++watched_.visits;
    live_.push_back(id);
    if (watched_.certificates.size() <= id) watched_.certificates.resize(id + std::size_t{1});
    KnownCertificate& known = watched_.certificates[id];
    const Query query = recorder_.simulator_.queue().query(id);
    const std::uint32_t slot = slot_++;
    known.seen = look_;
    if (known.number != kNone) {
      RecordedCertificate& record = proof_.certificates[known.number];
      if (known.query == query && record.group == number_ && record.slot == slot &&
          record.role == role) {
        recorder_.note_outlook(id, record);
        return;
      }
      change.gone.push_back(known.number);
    }
    known.query = query;
    known.number = static_cast<std::uint32_t>(proof_.certificates.size());
    RecordedCertificate& record = proof_.certificates.emplace_back();
    record.group = number_;
    record.slot = slot;
    record.role = role;
    record.claim = recorder_.claim(query, of_sum_);
    recorder_.note_outlook(id, record);
    change.came.push_back(known.number);
  }

  // What was there at the last look and is no longer shown.
  void finish() {
    for (const CertificateId id : watched_.live) {
      KnownCertificate& known = watched_.certificates[id];
      if (known.seen == look_) continue;
      change.gone.push_back(known.number);
      known.number = kNone;
    }
    for (const std::uint32_t number : watched_.live_groups) {
      KnownGroup& known = watched_.groups[number];
      if (known.seen == look_) continue;
      change.ended.push_back(number);
      known.state = kNone;
    }
    watched_.live = std::move(live_);
    watched_.live_groups = std::move(groups_);
  }

  ProofChange change;

 private:
  // Mostly it is the group that was shown at this place at the last look, and nothing of it has changed. It
  // is then compared as it is; one with derived objects has other numbers in the record.
  bool is_as_before(const ProofGroup& group) {
    if (groups_.size() >= watched_.live_groups.size()) return false;
    const std::uint32_t last = watched_.live_groups[groups_.size()];
    KnownGroup& known = watched_.groups[last];
    if (known.state == kNone || has_derived(group)) return false;
    if (!(proof_.groups[known.state].state == group)) return false;
    number_ = last;
    groups_.push_back(last);
    known.seen = look_;
    return true;
  }
  bool has_derived(const ProofGroup& group) const {
    const auto derived = [&](ObjectId id) { return id >= recorder_.scene_.objects.size(); };
    return std::any_of(group.about.begin(), group.about.end(), derived) ||
           std::any_of(group.marks.begin(), group.marks.end(), [&](const ProofMark& mark) {
             return std::any_of(mark.objects.begin(), mark.objects.end(), derived);
           });
  }

  std::uint32_t number_of_key() {
    if (groups_.size() < watched_.live_groups.size()) {
      const std::uint32_t last = watched_.live_groups[groups_.size()];
      if (*watched_.groups[last].key == key_) return last;
    }
    const auto [place, is_new] =
        watched_.numbers.try_emplace(key_, static_cast<std::uint32_t>(watched_.groups.size()));
    if (is_new) watched_.groups.emplace_back().key = &place->first;
    return place->second;
  }

  ProofRecorder& recorder_;
  RecordedProof& proof_;
  Watched& watched_;
  const std::uint64_t look_;
  GroupKey key_;
  std::uint32_t number_ = 0, slot_ = 0;
  bool of_sum_ = false;
  std::vector<CertificateId> live_;
  std::vector<std::uint32_t> groups_;
};

// Two changes at one event are one: the second one has the result.
void ProofRecorder::add(StructureId id, ProofChange change) {
  std::vector<ProofChange>& changes = run_.structures[id].proof.changes;
  if (changes.empty() || changes.back().event != change.event) {
    changes.push_back(std::move(change));
    return;
  }
  ProofChange& last = changes.back();
  for (const std::uint32_t c : change.gone) {
    const auto brief = std::find(last.came.begin(), last.came.end(), c);
    if (brief == last.came.end()) {
      last.gone.push_back(c);
    } else {
      last.came.erase(brief);
    }
  }
  const std::vector<RecordedGroup>& groups = run_.structures[id].proof.groups;
  const auto of_group = [&](std::uint32_t number) {
    return [&groups, number](std::uint32_t state) { return groups[state].group == number; };
  };
  for (const std::uint32_t number : change.ended) {
    std::erase_if(last.states, of_group(number));
    last.ended.push_back(number);
  }
  for (const std::uint32_t state : change.states) {
    std::erase_if(last.states, of_group(groups[state].group));
    std::erase(last.ended, groups[state].group);
    last.states.push_back(state);
  }
  last.came.insert(last.came.end(), change.came.begin(), change.came.end());
}

void ProofRecorder::look(StructureId id, const Structure& structure, std::uint64_t event,
                         bool reported) {
  if (watched_.size() <= id) watched_.resize(run_.structures.size());
  Watched& watched = watched_[id];
  if (run_.structures[id].proof.ends) return;
  const StructureLedger& ledger = simulator_.ledger(id);
  if (!reported && watched.created == ledger.certificates_created &&
      watched.retracted == ledger.certificates_retracted) {
    return;
  }
  watched.created = ledger.certificates_created;
  watched.retracted = ledger.certificates_retracted;
  if (watched.visits > most_visits_) {
    run_.structures[id].proof.ends = event == 0 ? 0 : event - 1;
    return;
  }
  Visit visit(*this, id, watched);
  structure.visit_proof(visit);
  visit.finish();
  visit.change.event = event;
  if (!visit.change.empty()) add(id, std::move(visit.change));
}

}  // namespace kinex::view
