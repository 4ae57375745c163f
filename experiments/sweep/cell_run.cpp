// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/cell_run.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/run_report.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/child_process.h"
#include "experiments/lab/scene_run.h"

namespace kinex::sweep {

namespace {

void write_counts(formats::JsonWriter& json, const StructureLedger& ledger) {
  json.key("counters").begin_object();
  json.key("processed").number(ledger.processed).key("external").number(ledger.external);
  json.key("internal").number(ledger.internal).key("failures").number(ledger.failures);
  json.key("records").number(ledger.records).key("rebuilds").number(ledger.rebuilds);
  json.key("simultaneous_groups").number(ledger.simultaneous_groups);
  json.key("motion_updates").number(ledger.motion_updates);
  json.key("insertions").number(ledger.insertions).key("erasures").number(ledger.erasures);
  json.key("certificates_created").number(ledger.certificates_created);
  json.key("certificates_retracted").number(ledger.certificates_retracted);
  json.key("audit_checks").number(ledger.audit_checks);
  json.key("audit_violations").number(ledger.audit_violations);
  for (const auto& [kind, count] : ledger.by_kind) json.key("kind." + kind).number(count);
  for (const auto& [reason, count] : ledger.rebuild_reasons) {
    json.key("rebuild." + reason).number(count);
  }
  json.end_object().key("extremes").begin_object();
  json.key("largest_group").number(ledger.largest_group);
  json.key("certificates_live").number(ledger.max_live);
  json.key("certificates_per_object").number(ledger.max_per_object);
  json.key("created_per_event").number(ledger.created_per_event.max);
  json.key("retracted_per_event").number(ledger.retracted_per_event.max).end_object();
}

void write_bounds(formats::JsonWriter& json, const std::vector<BoundCheck>& bounds) {
  json.key("bounds").begin_array();
  for (const BoundCheck& bound : bounds) {
    json.begin_object().key("id").string(bound.id).key("bound").quoted(bound.bound);
    json.key("observed").quoted(bound.observed).key("holds").boolean(bound.holds);
    json.key("source").string(bound.source).end_object();
  }
  json.end_array();
}

std::string exact_text(const Simulator& simulator, const formats::RunOutcome& outcome,
                       const std::string& hash, const std::string& digest) {
  const formats::RunCounts counts = formats::counts_of(simulator);
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("scene").string(simulator.scene().name).key("scene_hash").string(hash);
  json.key("numbers").string(simulator.arithmetic().name()).key("objects");
  json.number(static_cast<std::uint64_t>(simulator.scene().objects.size()));
  json.key("digest").string(digest).key("ended").string(formats::status_name(outcome.status));
  json.key("run").begin_object().key("counters").begin_object();
  json.key("events").number(counts.events()).key("external").number(counts.external);
  json.key("internal").number(counts.internal).key("failures").number(counts.failures);
  json.key("records").number(counts.records).key("instants").number(counts.instants);
  json.end_object().key("extremes").begin_object();
  json.key("queue").number(simulator.ledger().max_queue).end_object().end_object();
  json.key("structures").begin_object();
  for (StructureId id = 0; id < simulator.structures(); ++id) {
    const StructureLedger& ledger = simulator.ledger(id);
    json.key(simulator.label(id)).begin_object();
    write_counts(json, ledger);
    write_bounds(json, outcome.bounds[id]);
    json.key("corrupt").string(ledger.corrupt ? ledger.corruption : "").end_object();
  }
  json.end_object().key("violations").begin_array();
  for (const std::string& violation : simulator.violations()) json.string(violation);
  json.end_array().end_object();
  return formats::canonical_json(*formats::parse_json(text, "the run's counts"));
}

CellReport run_whole(const RunCell& cell) {
  Scene scene = scene_of(cell);
  const std::string hash = formats::scene_hash(scene);
  shorten(scene, cell);
  SimulatorOptions options;
  options.audit = audit_of(cell);
  options.scheduling = scheduling_of(cell);
  options.max_events = static_cast<std::uint64_t>(cell.max_events);
  const auto simulator = lab::make_simulator(scene, cell.arithmetic, std::move(options));
  formats::EventLog log(*simulator, hash, nullptr);
  log.charge_to(simulator->clock());
  simulator->set_sink(&log, false);
  const formats::RunOutcome outcome = lab::run_scene(*simulator, {});
  if (simulator->out_of_memory()) throw std::bad_alloc();
  log.finish(outcome.status);
  CellReport report;
  report.simulate_s = simulator->seconds_simulate();
  report.exact = exact_text(*simulator, outcome, hash, log.digest());
  const std::vector<std::string> failures = formats::failures_of(*simulator, outcome);
  if (!failures.empty()) {
    report.outcome = Outcome::kFailed;
    report.message = failures.front();
  }
  return report;
}

CellReport without_counts(Outcome outcome, std::string message) {
  CellReport report;
  report.outcome = outcome;
  report.message = std::move(message);
  return report;
}

CellReport run_or_refuse(const RunCell& cell) {
  try {
    return run_whole(cell);
  } catch (const formats::InputError& error) {
    const std::string file = error.file() == "--maintain" ? "structure" : error.file();
    const formats::InputError told(file, error.place(), error.problem(), error.remedy());
    return without_counts(Outcome::kRefused, told.what());
  } catch (const std::invalid_argument& error) {
    return without_counts(Outcome::kRefused, error.what());
  } catch (const std::bad_alloc&) {
    return without_counts(Outcome::kMemory, "there is not enough memory");
  }
}

}  // namespace

CellReport run_cell(const RunCell& cell) {
  CellReport report = run_or_refuse(cell);
  report.peak_kb = lab::own_peak_kb();
  return report;
}

std::string report_text(const CellReport& report) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("status").string(outcome_name(report.outcome));
  json.key("message").string(report.message).key("simulate_s").real(report.simulate_s);
  json.key("peak_kb").number(static_cast<std::uint64_t>(report.peak_kb));
  json.key("times").string(report.times).key("exact");
  report.exact.empty() ? json.null() : json.raw(report.exact);
  json.end_object();
  return text + "\n";
}

CellReport parse_report(std::string_view text, const std::string& file) {
  const formats::JsonDocument document = formats::parse_json(text, file);
  const formats::JsonValue& tree = *document;
  const formats::JsonSource source{file, text};
  const formats::JsonNode root(tree, source);
  root.require_object({"status", "message", "simulate_s", "peak_kb", "times", "exact"});
  CellReport report;
  const formats::JsonNode status = root.member("status");
  const auto outcome = outcome_of(status.string());
  if (!outcome) status.refuse("a status", "run the cell again");
  report.outcome = *outcome;
  report.message = root.member("message").string();
  report.simulate_s =
      std::strtod(std::string(root.member("simulate_s").value().text()).c_str(), nullptr);
  report.peak_kb =
      std::strtol(std::string(root.member("peak_kb").value().text()).c_str(), nullptr, 10);
  report.times = root.member("times").string();
  const formats::JsonNode exact = root.member("exact");
  if (!exact.is(formats::JsonValue::Kind::kNull)) report.exact = formats::canonical_json(exact.value());
  return report;
}

}  // namespace kinex::sweep
