// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/database.h"

#include <charconv>
#include <cstdint>
#include <map>
#include <set>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/json_document.h"
#include "experiments/lab/sqlite.h"

namespace kinex::sweep {

namespace {

constexpr const char* kSchema = R"(
PRAGMA foreign_keys = ON;
CREATE TABLE plan(id INTEGER PRIMARY KEY, name TEXT NOT NULL, hash TEXT NOT NULL UNIQUE,
  plan_json TEXT NOT NULL) STRICT;
CREATE TABLE cell(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, structure TEXT NOT NULL,
  workload TEXT NOT NULL, params_json TEXT NOT NULL, status TEXT NOT NULL,
  message TEXT NOT NULL) STRICT;
CREATE TABLE plan_cell(plan_id INTEGER NOT NULL REFERENCES plan(id),
  cell_id INTEGER NOT NULL REFERENCES cell(id), PRIMARY KEY(plan_id, cell_id)) STRICT, WITHOUT ROWID;
CREATE TABLE run(id INTEGER PRIMARY KEY, cell_id INTEGER NOT NULL UNIQUE REFERENCES cell(id),
  scene TEXT NOT NULL, scene_hash TEXT NOT NULL, number_mode TEXT NOT NULL, seed TEXT,
  objects INTEGER NOT NULL, digest TEXT NOT NULL, status TEXT NOT NULL) STRICT;
CREATE TABLE counter(run_id INTEGER NOT NULL REFERENCES run(id), structure TEXT NOT NULL,
  name TEXT NOT NULL, value INTEGER NOT NULL,
  PRIMARY KEY(run_id, structure, name)) STRICT, WITHOUT ROWID;
CREATE TABLE extreme(run_id INTEGER NOT NULL REFERENCES run(id), structure TEXT NOT NULL,
  name TEXT NOT NULL, value_text TEXT NOT NULL,
  PRIMARY KEY(run_id, structure, name)) STRICT, WITHOUT ROWID;
CREATE TABLE bound(run_id INTEGER NOT NULL REFERENCES run(id), structure TEXT NOT NULL,
  number INTEGER NOT NULL, bound_id TEXT NOT NULL, bound TEXT NOT NULL, observed TEXT NOT NULL,
  holds INTEGER NOT NULL, source TEXT NOT NULL,
  PRIMARY KEY(run_id, structure, number)) STRICT, WITHOUT ROWID;
CREATE TABLE violation(run_id INTEGER NOT NULL REFERENCES run(id), number INTEGER NOT NULL,
  what TEXT NOT NULL, PRIMARY KEY(run_id, number)) STRICT, WITHOUT ROWID;
CREATE TABLE provenance(id INTEGER PRIMARY KEY, file TEXT NOT NULL,
  plan_id INTEGER NOT NULL REFERENCES plan(id), version TEXT NOT NULL, git_commit TEXT NOT NULL,
  dirty INTEGER NOT NULL, compiler TEXT NOT NULL, flags TEXT NOT NULL, libraries TEXT NOT NULL,
  cpu TEXT NOT NULL, cores INTEGER NOT NULL, memory_kb INTEGER NOT NULL, kernel TEXT NOT NULL,
  host TEXT NOT NULL, command TEXT NOT NULL, shard TEXT NOT NULL, job TEXT NOT NULL,
  started_utc TEXT NOT NULL) STRICT;
CREATE TABLE attempt(id INTEGER PRIMARY KEY, provenance_id INTEGER NOT NULL REFERENCES provenance(id),
  line INTEGER NOT NULL, cell_id INTEGER NOT NULL REFERENCES cell(id), status TEXT NOT NULL,
  signal INTEGER NOT NULL, code INTEGER NOT NULL, message TEXT NOT NULL,
  limit_s INTEGER NOT NULL, limit_mb INTEGER NOT NULL, simulate_s REAL NOT NULL,
  cpu_s REAL NOT NULL, wall_s REAL NOT NULL, peak_kb INTEGER NOT NULL, ended_utc TEXT NOT NULL,
  UNIQUE(provenance_id, line)) STRICT;
)";

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
  explicit Writer(lab::Database& database)
      : plan_(database, "INSERT INTO plan VALUES(NULL, ?, ?, ?)"),
        cell_(database, "INSERT INTO cell VALUES(NULL, ?, ?, ?, ?, ?, ?)"),
        plan_cell_(database, "INSERT INTO plan_cell VALUES(?, ?)"),
        run_(database, "INSERT INTO run VALUES(NULL, ?, ?, ?, ?, ?, ?, ?, ?)"),
        counter_(database, "INSERT INTO counter VALUES(?, ?, ?, ?)"),
        extreme_(database, "INSERT INTO extreme VALUES(?, ?, ?, ?)"),
        bound_(database, "INSERT INTO bound VALUES(?, ?, ?, ?, ?, ?, ?, ?)"),
        violation_(database, "INSERT INTO violation VALUES(?, ?, ?)"),
        provenance_(database,
                    "INSERT INTO provenance VALUES(NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                    "?, ?, ?)"),
        attempt_(database,
                 "INSERT INTO attempt VALUES(NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)") {}

  // By key, so that ids are exact, too.
  void write_cells(const std::map<std::string, std::string>& texts, const Settled& settled) {
    for (const auto& [key, text] : texts) {
      const auto found = settled.find(key);
      write_cell(key, text, found == settled.end() ? nullptr : found->second);
    }
  }

  void write_plan(const Plan& plan) {
    const std::int64_t id = plan_.text(plan.name).text(plan.hash).text(plan.text).run();
    plan_ids_[plan.hash] = id;
    std::set<std::int64_t> cells;
    for (const Cell& cell : plan.cells) cells.insert(cell_ids_.at(cell.key));
    for (const std::int64_t cell : cells) plan_cell_.integer(id).integer(cell).run();
  }

  void write_attempt(const Attempt& attempt) {
    const Provenance& of = attempt.provenance;
    provenance_.text(attempt.path).integer(plan_ids_.at(of.plan_hash)).text(of.build.program);
    provenance_.text(of.build.commit).integer(of.build.dirty).text(of.build.compiler);
    provenance_.text(of.build.flags).text(of.build.libraries).text(of.machine.cpu);
    provenance_.integer(of.machine.cores).integer(of.machine.memory_kb).text(of.machine.kernel);
    provenance_.text(of.host).text(of.command).text(of.shard).text(of.job).text(of.started);
    const std::int64_t id = provenance_.run();
    std::int64_t line = 2;
    for (const Record& record : attempt.records) {
      attempt_.integer(id).integer(line++).integer(cell_ids_.at(record.key));
      attempt_.text(outcome_name(record.outcome)).integer(record.signal).integer(record.code);
      attempt_.text(record.message).integer(record.limits.seconds);
      attempt_.integer(record.limits.megabytes).real(record.simulate_s).real(record.cpu_s);
      attempt_.real(record.wall_s).integer(record.peak_kb).text(record.ended).run();
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
    cell_.text(key).text(structure == nullptr ? ""
                         : is_name            ? std::string(structure->text())
                                              : formats::canonical_json(*structure));
    cell_.text(text_of(within, "workload")).text(text);
    cell_.text(record == nullptr ? "missing" : outcome_name(record->outcome));
    // The messages of others depend on the machine: they are with the attempt.
    const bool has_verdict = record != nullptr && is_verdict(record->outcome);
    const std::int64_t id = cell_.text(has_verdict ? record->message : "").run();
    cell_ids_[key] = id;
    if (has_verdict && !record->exact.empty() && &within == &cell)
      write_run(id, cell, record->exact);
  }

  void write_run(std::int64_t cell_id, const formats::JsonValue& cell, const std::string& text) {
    const formats::JsonDocument exact_document = formats::parse_json(text, "exact fields");
    const formats::JsonValue& exact = *exact_document;
    run_.integer(cell_id).text(text_of(exact, "scene")).text(text_of(exact, "scene_hash"));
    run_.text(text_of(exact, "numbers"));
    const formats::JsonValue* seed = cell.find("seed");  // up to 2^64 - 1: TEXT
    seed == nullptr ? run_.null() : run_.text(seed->text());
    run_.integer(whole(text_of(exact, "objects"))).text(text_of(exact, "digest"));
    const std::int64_t id = run_.text(text_of(exact, "ended")).run();
    if (const formats::JsonValue* run = exact.find("run")) write_counts(id, "", *run);
    for_members(exact.find("structures"), [&](std::string_view label, const formats::JsonValue& of) {
      write_counts(id, label, of);
    });
    if (const formats::JsonValue* violations = exact.find("violations")) {
      std::int64_t number = 0;
      for (const formats::JsonValue& one : violations->items()) {
        violation_.integer(id).integer(++number).text(one.text()).run();
      }
    }
  }

  void write_counts(std::int64_t id, std::string_view label, const formats::JsonValue& of) {
    for_members(of.find("counters"), [&](std::string_view name, const formats::JsonValue& value) {
      counter_.integer(id).text(label).text(name).integer(whole(value.text())).run();
    });
    for_members(of.find("extremes"), [&](std::string_view name, const formats::JsonValue& value) {
      extreme_.integer(id).text(label).text(name).text(value.text()).run();
    });
    const formats::JsonValue* bounds = of.find("bounds");
    if (bounds == nullptr) return;
    std::int64_t number = 0;
    for (const formats::JsonValue& bound : bounds->items()) {
      bound_.integer(id).text(label).integer(++number).text(text_of(bound, "id"));
      bound_.text(text_of(bound, "bound")).text(text_of(bound, "observed"));
      bound_.integer(bound.find("holds")->boolean());
      bound_.text(text_of(bound, "source")).run();
    }
  }

  std::map<std::string, std::int64_t> plan_ids_, cell_ids_;  // by hash, by key
  lab::Statement plan_, cell_, plan_cell_, run_, counter_, extreme_, bound_, violation_, provenance_,
      attempt_;
};

}  // namespace

std::string sweep_database(const std::vector<Attempt>& attempts, const Experiments& experiments) {
  const std::vector<Plan> plans = plans_of(attempts, experiments);
  const Settled settled = settle(attempts);
  std::map<std::string, std::string> texts;
  for (const Plan& plan : plans) {
    for (const Cell& cell : plan.cells) texts.emplace(cell.key, cell.text);
  }
  for (const auto& [key, record] : settled) texts.emplace(key, record->cell);
  lab::Database database;
  database.execute(kSchema);
  database.execute("BEGIN");
  {
    Writer writer(database);
    writer.write_cells(texts, settled);
    for (const Plan& plan : plans) writer.write_plan(plan);
    for (const Attempt& attempt : attempts) writer.write_attempt(attempt);
  }
  database.execute("COMMIT");
  return database.serialise();
}

}  // namespace kinex::sweep
