// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/run_record.h"

#include <algorithm>
#include <charconv>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/json_writer.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/turned_scene.h"
#include "experiments/lab/workload.h"
#include "structures/plan.h"

namespace kinex::lab {

namespace {

std::uint64_t signs_of(const ArithmeticCounters& counters) {
  std::uint64_t sum = 0;
  for (const PredicateCounters& predicate : counters.by_predicate) {
    for (const std::uint64_t count : predicate.signs) sum += count;
  }
  return sum;
}

std::uint64_t whole_number(const formats::JsonValue& value, const std::string& file, std::size_t line) {
  std::uint64_t number = 0;
  const char* end = value.text().data() + value.text().size();
  const auto [rest, error] = std::from_chars(value.text().data(), end, number);
  if (value.kind() != formats::JsonValue::Kind::kNumber || error != std::errc() || rest != end) {
    throw formats::InputError(file, "line " + std::to_string(line), formats::shown(value) + " is no count",
                     "remove the file to begin anew");
  }
  return number;
}

}  // namespace

std::string RunKey::text() const {
  std::string text = structure + " " + workload + " n=" + std::to_string(n) +
                     " d=" + std::to_string(dimension) + " seed=" + std::to_string(seed);
  if (m != 0) text += " m=" + std::to_string(m);
  if (!separation.empty()) text += " separation=" + separation;
  if (turns != -1) text += " turns=" + std::to_string(turns);
  if (turned) text += " turned";
  if (forever) text += " forever";
  if (max_events != 0) text += " events=" + std::to_string(max_events);
  return text;
}

Scene scene_for(const RunKey& key) {
  WorkloadParameters parameters;
  parameters.n = key.n;
  parameters.dimension = key.dimension;
  parameters.seed = key.seed;
  parameters.m = key.m;
  if (!key.separation.empty()) parameters.separation = Rational::parse(key.separation);
  parameters.turns = key.turns;
  Scene scene = generate_scene(key.workload, parameters, key.structure);
  if (key.turned) turn_scene(scene, static_cast<int>(key.seed) - 1);
  if (key.forever) scene.end.reset();
  return scene;
}

std::optional<RunRecord> run_record(const RunKey& key, const std::function<bool()>& go_on,
                                    const std::atomic<bool>* interrupt) {
  const Scene scene = scene_for(key);
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = key.max_events;
  options.progress = [&](const Simulator&) { return go_on(); };
  options.interrupt = interrupt;
  double begin = cpu_seconds();
  const auto simulator = make_simulator(scene, "exact", std::move(options));
  const GmpGuard guard(&simulator->deadline());
  simulator->start();
  RunRecord record;
  const std::uint64_t signs_at_start = signs_of(simulator->arithmetic().counters());
  record.key = key.text();
  record.seconds_setup = cpu_seconds() - begin;
  begin = cpu_seconds();
  const RunStatus status = simulator->run_until(std::nullopt);
  record.seconds = cpu_seconds() - begin;
  record.signs = signs_of(simulator->arithmetic().counters()) - signs_at_start;
  if (status == RunStatus::kInterrupted || !go_on()) return std::nullopt;
  const StructureId id = asked_structure(scene);
  if (status == RunStatus::kDone && !simulator->audit()) {
    record.clean = false;
    record.trouble = simulator->violations().empty() ? "audit" : simulator->violations().front();
  }
  if (simulator->is_broken()) {
    record.clean = false;
    record.trouble = simulator->out_of_memory() ? "memory" : "stopped";
  }
  for (std::size_t s = 0; s < simulator->structures(); ++s) {
    const auto other = static_cast<StructureId>(s);
    for (const BoundCheck& bound : simulator->bounds(other)) {
      if (!bound.holds) {
        record.clean = false;
        record.trouble = "bound " + bound.id;
      }
    }
    const StructureLedger& ledger = simulator->ledger(other);
    record.max_live += ledger.max_live;
    record.max_per_object += ledger.max_per_object;
  }
  const StructureLedger& ledger = simulator->ledger(id);
  record.processed = simulator->ledger().events;
  record.external = ledger.external;
  record.kinds = ledger.by_kind;
  record.solved = simulator->arithmetic().counters().polynomials_solved;
  record.peak_bytes = simulator->ledger().peak_bytes;
  return record;
}

std::string record_line(const RunRecord& record) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("run").string(record.key);
  json.key("processed").number(record.processed).key("external").number(record.external);
  json.key("max_live").number(record.max_live).key("max_per_object").number(record.max_per_object);
  json.key("signs").number(record.signs);
  json.key("solved").begin_array();
  for (const std::uint64_t count : record.solved) json.number(count);
  json.end_array().key("kinds").begin_object();
  for (const auto& [kind, count] : record.kinds) json.key(kind).number(count);
  json.end_object().key("peak_bytes").number(record.peak_bytes);
  json.key("seconds_setup").real(record.seconds_setup).key("seconds").real(record.seconds);
  json.key("clean").boolean(record.clean).key("trouble").string(record.trouble).end_object();
  return text;
}

RunRecord parse_record(std::string_view line, const std::string& file, std::size_t number) {
  const formats::JsonDocument document = formats::parse_json(line, file, number);
  const formats::JsonValue& value = *document;
  const auto member = [&](const char* name) -> const formats::JsonValue& {
    const formats::JsonValue* found = value.find(name);
    if (found == nullptr) {
      throw formats::InputError(file, "line " + std::to_string(number),
                       std::string("there is no \"") + name + "\"",
                       "remove the file to begin anew");
    }
    return *found;
  };
  const auto count = [&](const char* name) { return whole_number(member(name), file, number); };
  const auto real = [&](const char* name) {
    return std::strtod(std::string(member(name).text()).c_str(), nullptr);
  };
  RunRecord record;
  record.key = member("run").text();
  record.processed = count("processed");
  record.external = count("external");
  record.max_live = count("max_live");
  record.max_per_object = count("max_per_object");
  record.signs = count("signs");
  for (const formats::JsonValue& one : member("solved").items()) {
    record.solved.push_back(whole_number(one, file, number));
  }
  const formats::JsonValue& kinds = member("kinds");
  for (std::size_t i = 0; i < kinds.items().size(); ++i) {
    record.kinds[std::string(kinds.key(i))] = whole_number(kinds.items()[i], file, number);
  }
  record.peak_bytes = count("peak_bytes");
  record.seconds_setup = real("seconds_setup");
  record.seconds = real("seconds");
  record.clean = member("clean").boolean();
  record.trouble = member("trouble").text();
  return record;
}

}  // namespace kinex::lab
