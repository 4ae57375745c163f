// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/recorder.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/engine/refused_change.h"
#include "core/numbers/check.h"
#include "core/numbers/stop.h"
#include "experiments/formats/certificate_polynomial.h"
#include "experiments/formats/claim_words.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/log_digest.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/scene_run.h"
#include "experiments/view/attribute_state.h"
#include "experiments/view/proof_recorder.h"
#include "experiments/view/watched_structure.h"
#include "structures/parts/range_search.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::view {

namespace {

// A number near now, for drawing.
std::optional<Rational> near_now(const InstantName& name, const Arithmetic& arithmetic) {
  if (!name.exact) return arithmetic.now_value();
  if (name.is_rational()) return name.lower;
  const std::optional<Rational> near = Rational::from_double(arithmetic.now_approximate());
  return near ? near : (name.lower + name.upper) / Rational(2);
}

class Recorder final : public EventSink {
 public:
  Recorder(const Scene& scene, const RecordOptions& options) : scene_(scene), options_(options) {
    auto watch = make_stage_watch(lab::arithmetic_option(options.arithmetic, scene));
    stages_ = watch.get();
    run_.arithmetic = watch->name();
    run_.exact = watch->is_exact();
    SimulatorOptions simulator_options;
    simulator_options.audit = AuditLevel::kNone;
    simulator_options.interrupt = options_.interrupt;
    simulator_options.progress = [this](const Simulator& running) {
      return !full_ && (!options_.progress || options_.progress(running));
    };
    simulator_.emplace(scene, std::move(watch), simulator_options);
    run_.objects = scene.objects.size();
    proofs_.emplace(scene, *simulator_, run_, options_.most_visits);
    add_structures();
    digest_.emplace(*simulator_);
    simulator_->set_sink(this);
  }

  RecordedRun run() {
    recording_ = !options_.from || *options_.from == scene_.start;
    run_.start = options_.from ? *options_.from : scene_.start;
    const lab::GmpGuard guard(&simulator_->deadline());
    if (!simulator_->start()) throw Stopped();  // there is nothing to show
    RunStatus status = RunStatus::kDone;
    if (!recording_) {
      status = simulator_->run_until(run_.start);
      if (simulator_->is_torn()) throw Stopped();
      run_.before = events_;
      recording_ = true;
      for (StructureId id = 0; id < run_.structures.size(); ++id) take_initial(id);
    }
    if (status == RunStatus::kDone) status = run_to_end();
    note_corruption();
    run_.complete = status == RunStatus::kDone && !full_;
    if (!run_.complete && run_.stopped.empty()) {
      run_.stopped = simulator_->out_of_memory() ? "memory was exhausted" : "it was interrupted";
    }
    if (run_.complete) check_final_states();
    run_.bound = stages_->bound();
    for (const auto& predicate : run_.bound) {
      run_.predicates.emplace_back(predicate->name());
      run_.forms.push_back(formats::claim_form(*predicate, simulator_->scene()));
    }
    run_.digest = digest_->hex();
    return std::move(run_);
  }

  void event(const Event& event, Arithmetic& arithmetic) override {
    note_corruption();
    const RecordedStructure& structure = run_.structures[event.structure];
    State& state = states_[event.structure];
    const bool common = event.kind >= structure.kinds.size() - kCommonEvents;
    if (full_) return;
    const bool record = recording_ && run_.events.size() < options_.max_events;
    const std::string& kind = structure.kinds[event.kind];
    if (recording_ && !record)
      return stop("it has more than " + std::to_string(options_.max_events) + " log records");
    name_all({event.ids.data(), event.count}, names_);
    if (options_.observe) {
      name_all(event.gone, gone_);
      name_all(event.came, came_);
      if (!options_.observe({events_ + 1, structure.label, kind, names_, gone_, came_, event,
                             arithmetic.name_now(InstantDetail::kName)})) {
        return stop(std::string(kLogEnds));
      }
    }
    ++events_;
    run_.all.push_back(as_recorded(event));
    digest_->add(event, *simulator_);
    if (!record) return;
    if (state.first_pending == 0) state.first_pending = events_;
    state.attribute->note_event({event.ids.data(), event.count}, common);
    state.changed = state.changed || event.external || common;
    record_event(event, arithmetic);
  }

 private:
  void name_all(std::span<const ObjectId> ids, std::vector<std::string_view>& names) const {
    names.clear();
    for (const ObjectId id : ids) names.push_back(simulator_->object_name(id));
  }

  // A change that cannot be made is ignored if nothing more is to be recorded.
  RunStatus run_to_end() {
    try {
      const RunStatus status = ask_queries();
      return status == RunStatus::kDone ? simulator_->run_until(std::nullopt) : status;
    } catch (const RefusedChange&) {
      if (!full_) throw;
      return RunStatus::kInterrupted;
    }
  }

  // The queries from here on, in the order of their times.
  RunStatus ask_queries() {
    std::vector<BoxQuery> queries = scene_.queries;
    std::stable_sort(queries.begin(), queries.end(),
                     [](const BoxQuery& a, const BoxQuery& b) { return a.at < b.at; });
    for (const BoxQuery& query : queries) {
      if (query.at < run_.start) continue;
      const RunStatus status = simulator_->run_until(query.at);
      if (status != RunStatus::kDone || full_) return status;
      ask(query);
    }
    return RunStatus::kDone;
  }

  void ask(const BoxQuery& query) {
    std::array<std::vector<Rational>, 2> corners;
    for (const auto& side : query.box) {
      corners[0].push_back(side[0]);
      corners[1].push_back(side[1]);
    }
    Kernel& kernel = simulator_->kernel();
    const ObjectId low = kernel.constant("low corner", corners[0]);
    const ObjectId high = kernel.constant("high corner", corners[1]);
    RecordedQuery recorded{query, {}};
    for (StructureId id = 0; id < states_.size(); ++id) {
      auto* const tree = dynamic_cast<TracedSearch*>(searched_[id]);
      if (tree == nullptr || simulator_->ledger(id).corrupt) continue;
      RecordedQuery::Answer answer{id, {}, {}, 0};
      tree->trace(low, high, answer.ids, answer.nodes);
      if (auto* const search = dynamic_cast<RangeSearch*>(searched_[id])) {
        std::vector<ObjectId> again;
        QueryCounts counts;
        search->report(low, high, again, counts);
        answer.looked_at = counts.nodes;
      }
      std::sort(answer.ids.begin(), answer.ids.end());
      recorded.answers.push_back(std::move(answer));
    }
    run_.queries.push_back(std::move(recorded));
  }

  // The state between two looks at a structure.
  struct State {
    const Structure* structure = nullptr;
    bool begun = false;
    std::optional<AttributeState> attribute;
    std::uint64_t first_pending = 0;  // the first event that it reported since; 0: none
    bool changed = false;             // one of them may have changed the attribute
  };

  void add_structures() {
    const std::vector<PlannedStructure> plan = plan_structures(scene_);
    run_.structures.resize(plan.size());
    states_.resize(plan.size());
    for (std::size_t i = 0; i < plan.size(); ++i) {
      const PlannedStructure& planned = plan[i];
      const StructureId id = simulator_->reserve();
      std::vector<const Structure*> watched;
      for (const StructureId read : planned.watches) watched.push_back(states_[read].structure);
      std::unique_ptr<Structure> structure = make_structure(
          planned.request, scene_, simulator_->kernel(), id, watched, planned.watches);
      states_[i].structure = structure.get();
      states_[i].attribute.emplace(*structure);
      searched_.push_back(structure.get());
      RecordedStructure& record = run_.structures[i];
      record.label = planned.request.label;
      record.name = std::string(structure->name());
      record.key = planned.request.key;
      const StructureInfo* info = find_structure_info(planned.request.structure);
      record.has_key = (info != nullptr && info->uses_key) || scene_.dimension == 1;
      if (info != nullptr) {
        record.role = std::string(info->role);
        record.directions = directions_of(*info, planned.request, scene_.dimension);
        if (info->query)
          record.query = planned.request.query == kNoObject ? 0 : planned.request.query;
      }
      record.members = planned.members;
      if (!planned.watches.empty()) record.proof.reads = planned.watches.front();
      simulator_->add(id,
                      std::make_unique<WatchedStructure>(
                          std::move(structure), [this, id](bool failure) { look(id, failure); }),
                      planned.request.label, planned.watches, planned.members);
      for (const std::string_view kind : simulator_->event_kinds(id)) {
        record.kinds.emplace_back(kind);
        record.meanings.emplace_back(info != nullptr ? meaning_of_kind(*info, kind) : "");
      }
    }
  }

  void stop(std::string why) {
    full_ = true;
    run_.stopped = std::move(why);
  }

  // Without its reason and its difference, and with derived objects as the record numbers them.
  Event as_recorded(Event event) {
    event.reason = {};
    event.gone = event.came = {};
    for (std::size_t i = 0; i < event.count; ++i) event.ids[i] = proofs_->recorded(event.ids[i]);
    for (std::size_t i = 0; i < event.certificate.arity; ++i) {
      event.certificate.ids[i] = proofs_->recorded(event.certificate.ids[i]);
    }
    return event;
  }

  Polynomial polynomial(const Query& query) const {
    return formats::certificate_polynomial(stages_->predicate(query.predicate), query,
                                           simulator_->kernel().derived());
  }

  void record_event(const Event& event, Arithmetic& arithmetic) {
    const InstantName& instant = arithmetic.name_now(InstantDetail::kName);
    RecordedEvent record;
    record.event = as_recorded(event);
    record.reason = std::string(event.reason);
    if (event.external && event.certificate.arity == 0) {
      for (const ObjectId id : event.gone) record.gone.push_back(proofs_->recorded(id));
      for (const ObjectId id : event.came) record.came.push_back(proofs_->recorded(id));
    }
    if (event.certificate.arity > 0) {
      Polynomial p = polynomial(event.certificate);
      record.stages = stages_->stages(event.certificate);
      if (instant.exact && p == instant.polynomial) {
        record.sign = 1;
      } else if (instant.exact && -p == instant.polynomial) {
        record.sign = -1;
      } else {
        record.polynomial = std::move(p);
      }
    }
    if (run_.instants.empty() || run_.instants.back().name.number != instant.number) {
      run_.instants.push_back({instant, near_now(instant, arithmetic)});
    }
    record.instant = run_.instants.size() - 1;
    run_.events.push_back(std::move(record));
  }

  void take_initial(StructureId id) {
    State& state = states_[id];
    state.begun = true;
    state.first_pending = 0;
    state.changed = false;
    if (simulator_->ledger(id).corrupt) return;
    run_.structures[id].initial = state.attribute->begin();
    proofs_->look(id, *state.structure, events_, true);
  }

  // The structure has returned from a call. `failure`: from certificate_failed.
  void look(StructureId id, bool failure) {
    if (!recording_) return;
    note_corruption();
    State& state = states_[id];
    if (!state.begun) return take_initial(id);
    const std::uint64_t first = std::exchange(state.first_pending, 0);
    const bool changed = std::exchange(state.changed, false);
    state.attribute->note_call(failure);
    if (simulator_->ledger(id).corrupt) return;
    if (!full_) proofs_->look(id, *state.structure, first != 0 ? first : events_, first != 0);
    if (first == 0 ? full_ : !changed) return;
    AttributeChange change = state.attribute->read();
    if (change.empty()) return;
    change.event = first != 0 ? first : events_;
    run_.structures[id].changes.push_back(std::move(change));
  }

  void note_corruption() {
    if (full_) return;
    for (StructureId id = 0; id < run_.structures.size(); ++id) {
      const StructureLedger& ledger = simulator_->ledger(id);
      RecordedStructure& structure = run_.structures[id];
      if (!ledger.corrupt || structure.corrupt_after) continue;
      structure.corrupt_after = events_;
      structure.corruption = ledger.corruption;
    }
  }

  // Detects an event that changes the attribute without reporting it.
  void check_final_states() const {
    for (StructureId id = 0; id < run_.structures.size(); ++id) {
      if (run_.structures[id].corrupt_after) continue;
      if (states_[id].attribute->value() == states_[id].structure->attribute()) continue;
      throw MisreportedEvents("structure \"" + simulator_->label(id) +
                               "\": its external events do not lead to its attribute at the end: one "
                               "was not reported, or not as external; kinex run --audit events finds it");
    }
  }

  const Scene& scene_;
  const RecordOptions& options_;
  RecordedRun run_;
  StageWatch* stages_ = nullptr;
  std::vector<State> states_;
  std::vector<Structure*> searched_;  // the same structures
  std::optional<Simulator> simulator_;
  std::optional<ProofRecorder> proofs_;
  std::vector<std::string_view> names_;  // of the present event's objects
  std::vector<std::string_view> gone_, came_;
  std::uint64_t events_ = 0;
  bool recording_ = false;
  bool full_ = false;
  std::optional<formats::LogDigest> digest_;
};

}  // namespace

RecordedRun record_run(const Scene& scene, const RecordOptions& options) {
  Recorder recorder(scene, options);
  return recorder.run();
}

}  // namespace kinex::view
