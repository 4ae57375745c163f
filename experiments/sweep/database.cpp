// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/database.h"

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/json_document.h"
#include "experiments/lab/result_database.h"

namespace kinex::sweep {

namespace {

std::string_view text_of(const formats::JsonValue& object, std::string_view name) {
  const formats::JsonValue* found = object.find(name);
  return found == nullptr ? std::string_view() : found->text();
}

std::int64_t whole(std::string_view text) {
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// Member by member, (name, value).
template <class Take>
void for_members(const formats::JsonValue* object, const Take& take) {
  if (object == nullptr) return;
  for (std::size_t i = 0; i < object->items().size(); ++i) take(object->key(i), object->items()[i]);
}

class Writer {
 public:
  explicit Writer(lab::ResultDatabase& database) : database_(database) {}

  // By key, so that ids are exact, too.
  void write_cells(const std::map<std::string, std::string>& texts, const Settled& settled) {
    for (const auto& [key, text] : texts) {
      const auto found = settled.find(key);
      write_cell(key, text, found == settled.end() ? nullptr : found->second);
    }
  }

  void write_plan(const Plan& plan) {
    const std::int64_t id = database_.insert("plan", nullptr, plan.name, plan.hash, plan.text);
    plan_ids_[plan.hash] = id;
    std::set<std::int64_t> cells;
    for (const PlanCell& cell : plan.cells) cells.insert(cell_ids_.at(cell.key));
    for (const std::int64_t cell : cells) database_.insert("plan_cell", id, cell);
  }

  void write_attempt(const Attempt& attempt) {
    const AttemptProvenance& of = attempt.provenance;
    const std::int64_t id = database_.insert(
        "provenance", nullptr, attempt.path, plan_ids_.at(of.plan_hash), of.build.program,
        of.build.commit, of.build.dirty, of.build.compiler, of.build.flags, of.build.libraries,
        of.machine.cpu, of.machine.cores, of.machine.memory_kb, of.machine.kernel, of.host, of.command,
        of.shard, of.job, of.started);
    std::int64_t line = 2;
    for (const Record& record : attempt.records) {
      database_.insert("attempt", nullptr, id, line++, cell_ids_.at(record.key),
                       outcome_name(record.outcome), record.signal, record.code, record.message,
                       record.limits.seconds, record.limits.megabytes, record.simulate_s, record.cpu_s,
                       record.wall_s, record.peak_kb, record.ended);
    }
  }

 private:
  void write_cell(const std::string& key, const std::string& text, const Record* record) {
    const formats::JsonDocument document = formats::parse_json(text, "a cell");
    const formats::JsonValue& cell = *document;
    // A cell of an experiment has them inside, if it has them.
    const formats::JsonValue* structure = cell.find("structure");
    const formats::JsonValue& within = structure == nullptr ? cell.items().front() : cell;
    if (structure == nullptr) structure = within.find("structure");
    const bool is_name =
        structure == nullptr || structure->kind() == formats::JsonValue::Kind::kString;
    const std::string name = structure == nullptr ? ""
                             : is_name            ? std::string(structure->text())
                                                  : formats::canonical_json(*structure);
    // The messages of others depend on the machine: they are with the attempt.
    const bool has_verdict = record != nullptr && is_verdict(record->outcome);
    const std::int64_t id =
        database_.insert("cell", nullptr, key, name, text_of(within, "workload"), text,
                         record == nullptr ? "missing" : outcome_name(record->outcome),
                         has_verdict ? record->message : "");
    cell_ids_[key] = id;
    if (has_verdict && !record->exact.empty() && &within == &cell)
      write_run(id, cell, record->exact);
  }

  void write_run(std::int64_t cell_id, const formats::JsonValue& cell, const std::string& text) {
    const formats::JsonDocument exact_document = formats::parse_json(text, "exact fields");
    const formats::JsonValue& exact = *exact_document;
    std::optional<std::string> seed;  // up to 2^64 - 1: TEXT
    if (const formats::JsonValue* given = cell.find("seed")) seed = given->text();
    const std::int64_t id = database_.insert(
        "run", nullptr, cell_id, text_of(exact, "scene"), text_of(exact, "scene_hash"),
        text_of(exact, "numbers"), seed, whole(text_of(exact, "objects")), text_of(exact, "digest"),
        text_of(exact, "ended"));
    if (const formats::JsonValue* run = exact.find("run")) write_counts(id, "", *run);
    for_members(exact.find("structures"), [&](std::string_view label, const formats::JsonValue& of) {
      write_counts(id, label, of);
    });
    if (const formats::JsonValue* violations = exact.find("violations")) {
      std::int64_t number = 0;
      for (const formats::JsonValue& one : violations->items()) {
        database_.insert("violation", id, ++number, one.text());
      }
    }
  }

  void write_counts(std::int64_t id, std::string_view label, const formats::JsonValue& of) {
    for_members(of.find("counters"), [&](std::string_view name, const formats::JsonValue& value) {
      database_.insert("counter", id, label, name, whole(value.text()));
    });
    for_members(of.find("extremes"), [&](std::string_view name, const formats::JsonValue& value) {
      database_.insert("extreme", id, label, name, value.text());
    });
    const formats::JsonValue* bounds = of.find("bounds");
    if (bounds == nullptr) return;
    std::int64_t number = 0;
    for (const formats::JsonValue& bound : bounds->items()) {
      database_.insert("bound", id, label, ++number, text_of(bound, "id"), text_of(bound, "bound"),
                       text_of(bound, "observed"), bound.find("holds")->boolean(),
                       text_of(bound, "source"));
    }
  }

  std::map<std::string, std::int64_t> plan_ids_, cell_ids_;  // by hash, by key
  lab::ResultDatabase& database_;
};

}  // namespace

std::string sweep_database(const std::vector<Attempt>& attempts, const Experiments& experiments) {
  const std::vector<Plan> plans = plans_of(attempts, experiments);
  const Settled settled = settle(attempts);
  std::map<std::string, std::string> texts;
  for (const Plan& plan : plans) {
    for (const PlanCell& cell : plan.cells) texts.emplace(cell.key, cell.text);
  }
  for (const auto& [key, record] : settled) texts.emplace(key, record->cell);
  lab::ResultDatabase database(lab::sweep_schema());
  Writer writer(database);
  writer.write_cells(texts, settled);
  for (const Plan& plan : plans) writer.write_plan(plan);
  for (const Attempt& attempt : attempts) writer.write_attempt(attempt);
  return database.bytes();
}

}  // namespace kinex::sweep
