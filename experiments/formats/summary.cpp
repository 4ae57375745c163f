// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/summary.h"

#include <utility>

#include "experiments/formats/attribute_json.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/run_report.h"

namespace kinex::formats {

namespace {

// Certificates changed per event: histogram[k] counts the events with k; its last place, if it has
// all of ChangeStatistics::kBins, those with that many or more.
void write_changes(JsonWriter& json, const ChangeStatistics& changes) {
  json.begin_object().key("mean");
  json.real(changes.events == 0
                ? 0.0
                : static_cast<double>(changes.total) / static_cast<double>(changes.events));
  json.key("max").number(changes.max).key("histogram").begin_array();
  std::size_t used = changes.histogram.size();
  while (used != 0 && changes.histogram[used - 1] == 0) --used;
  for (std::size_t k = 0; k < used; ++k) json.number(changes.histogram[k]);
  json.end_array().end_object();
}

void write_counts(JsonWriter& json, const StructureLedger& ledger) {
  json.key("processed").number(ledger.processed).key("external").number(ledger.external);
  json.key("internal").number(ledger.internal).key("failures").number(ledger.failures);
  json.key("records").number(ledger.records);
  json.key("rebuilds").number(ledger.rebuilds);
  json.key("simultaneous_groups").number(ledger.simultaneous_groups);
  json.key("largest_group").number(ledger.largest_group);
  json.key("rebuild_reasons").begin_object();
  for (const auto& [reason, count] : ledger.rebuild_reasons) json.key(reason).number(count);
  json.end_object();
  json.key("motion_updates").number(ledger.motion_updates);
  json.key("insertions").number(ledger.insertions).key("erasures").number(ledger.erasures);
  json.key("by_kind").begin_object();
  for (const auto& [kind, count] : ledger.by_kind) json.key(kind).number(count);
  json.end_object();
  json.key("certificates").begin_object();
  json.key("created").number(ledger.certificates_created);
  json.key("retracted").number(ledger.certificates_retracted);
  json.key("max_live").number(ledger.max_live).key("max_per_object").number(ledger.max_per_object);
  json.end_object();
  json.key("responsiveness").begin_object().key("created");
  write_changes(json, ledger.created_per_event);
  json.key("retracted");
  write_changes(json, ledger.retracted_per_event);
  json.end_object().key("scheduling").begin_object().key("failures_found");
  json.number(ledger.failures_found).key("failures_unused").number(ledger.failures_unused);
  json.key("windows").number(ledger.windows).end_object();
  json.key("efficiency").real(ledger.efficiency());
  json.key("audit").begin_object().key("checks").number(ledger.audit_checks);
  json.key("violations").number(ledger.audit_violations).end_object();
  json.key("corrupt");
  if (ledger.corrupt) {
    json.string(ledger.corruption);
  } else {
    json.boolean(false);
  }
}

// None if they are not judged: Simulator::bounds.
void write_bounds(JsonWriter& json, const std::vector<BoundCheck>& bounds) {
  json.key("bounds").begin_array();
  for (const BoundCheck& bound : bounds) {
    json.begin_object().key("id").string(bound.id).key("bound").string(bound.bound.to_string());
    json.key("observed").string(bound.observed.to_string()).key("holds").boolean(bound.holds);
    json.key("source").string(bound.source).end_object();
  }
  json.end_array();
}

// None if nothing was asked.
void write_answers(JsonWriter& json, const Sample& sample, const Simulator& simulator) {
  if (sample.queries.empty()) return;
  json.key("queries").begin_array();
  for (const BoxAnswer& query : sample.queries) {
    json.begin_object().key("box").begin_array();
    for (const auto& [low, high] : query.box) {
      json.begin_array().quoted(low).quoted(high).end_array();
    }
    json.end_array();
    for (const BoxAnswer::OfStructure& answer : query.answers) {
      json.key(simulator.label(answer.structure)).begin_object().key("ids");
      write_attribute(json, {Attribute::Shape::kSequence, answer.ids}, simulator.scene());
      json.key("nodes").number(answer.counts.nodes).key("signs").number(answer.counts.signs);
      json.end_object();
    }
    json.end_object();
  }
  json.end_array();
}

void write_stages(JsonWriter& json, const StageCounts& counts) {
  json.begin_array();
  for (const std::uint64_t count : counts) json.number(count);
  json.end_array();
}

// By stage, in the order of Stage: [double, wide, multiprecision, exact].
void write_numbers(JsonWriter& json, const Arithmetic& arithmetic) {
  const ArithmeticCounters& counters = arithmetic.counters();
  json.key("numbers").begin_object().key("predicates").begin_array();
  for (std::size_t id = 0; id < counters.by_predicate.size(); ++id) {
    json.begin_object().key("name");
    json.string(arithmetic.predicate(static_cast<PredicateId>(id)).name()).key("signs");
    write_stages(json, counters.by_predicate[id].signs);
    json.key("failures");
    write_stages(json, counters.by_predicate[id].failures);
    json.key("looks");
    write_stages(json, counters.by_predicate[id].looks);
    json.key("comparisons");
    write_stages(json, counters.by_predicate[id].comparisons);
    json.end_object();
  }
  json.end_array().key("comparisons");
  write_stages(json, counters.comparisons);
  json.key("polynomials_solved").begin_array();
  for (const std::uint64_t count : counters.polynomials_solved) json.number(count);
  json.end_array().key("roots_made_exact").number(counters.roots_made_exact);
  json.key("refinements").number(counters.refinements).key("gcds").number(counters.gcds);
  json.key("max_bits").number(counters.max_bits).end_object();
}

void write_phases(JsonWriter& json, const Simulator& simulator, double Seconds::*clock) {
  for (const auto& [name, phase] : {std::pair("setup", RunPhase::kSetup),
                                    {"simulate", RunPhase::kSimulate},
                                    {"report", RunPhase::kReport},
                                    {"audit", RunPhase::kAudit}}) {
    json.key(name).real(simulator.seconds(phase).*clock);
  }
}

}  // namespace

std::string write_summary(const Simulator& simulator, const RunOutcome& outcome,
                          const std::string& scene_hash, const std::string& log_digest,
                          const Provenance& provenance) {
  const Scene& scene = simulator.scene();
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("scene").string(scene.name).key("scene_hash").string(scene_hash);
  json.key("arithmetic").string(simulator.arithmetic().name());
  json.key("build").string(build_name()).key("status").string(status_name(outcome.status));
  json.key("time").begin_object().key("start").string(scene.start.to_string()).key("end");
  if (scene.end) {
    json.string(scene.end->to_string());
  } else {
    json.null();
  }
  json.end_object().key("objects").number(static_cast<std::uint64_t>(scene.objects.size()));
  const RunCounts counts = counts_of(simulator);
  json.key("events").number(counts.events()).key("external").number(counts.external);
  json.key("internal").number(counts.internal).key("failures").number(counts.failures);
  json.key("records").number(counts.records).key("instants").number(counts.instants);
  json.key("max_queue").number(simulator.ledger().max_queue);
  json.key("log_digest").string(log_digest);
  json.line(1).key("structures").begin_object();
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    json.line(2).key(simulator.label(id)).begin_object();
    write_counts(json, simulator.ledger(id));
    write_bounds(json, outcome.bounds[id]);
    json.key("attribute");
    write_attribute(json, value_now(simulator, id), scene);
    json.end_object();
  }
  json.end_object();
  json.line(1).key("samples").begin_array();
  for (const Sample& sample : outcome.samples) {
    json.line(2).begin_object().key("t").string(sample.t.to_string());
    for (StructureId id = 0; id < simulator.structures(); ++id) {
      json.key(simulator.label(id));
      write_attribute(json, sample.values[id], scene);
    }
    write_answers(json, sample, simulator);
    json.end_object();
  }
  json.end_array().line(1);
  write_numbers(json, simulator.arithmetic());
  json.line(1).key("violations").begin_array();
  for (const std::string& violation : simulator.violations()) json.string(violation);
  json.end_array();
  json.line(1).key("seconds").begin_object();
  write_phases(json, simulator, &Seconds::cpu);
  json.key("structures").begin_object();
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    json.key(simulator.label(id)).real(simulator.ledger(id).seconds);
  }
  json.end_object().key("per_event").begin_object();
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    json.key(simulator.label(id));
    json.real(ledger.processed == 0 ? 0.0 : ledger.seconds / static_cast<double>(ledger.processed));
  }
  json.end_object().key("wall").begin_object();
  write_phases(json, simulator, &Seconds::wall);
  json.end_object().end_object();
  json.key("peak_bytes").number(simulator.ledger().peak_bytes);
  write_provenance(json.line(1).key("provenance"), provenance);
  json.end_object();
  text += '\n';
  return text;
}

}  // namespace kinex::formats
