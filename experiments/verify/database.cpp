// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/database.h"

#include <array>
#include <string_view>
#include <vector>

#include "experiments/formats/json_writer.h"
#include "experiments/lab/facts_tables.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/sqlite.h"

namespace kinex {

namespace {

constexpr const char* kSchema = R"(
CREATE TABLE cell(id INTEGER PRIMARY KEY, structure TEXT NOT NULL, workload TEXT NOT NULL,
  family TEXT NOT NULL, params_json TEXT NOT NULL, question TEXT NOT NULL, verdict TEXT NOT NULL,
  exact_over_double TEXT, wall_s REAL NOT NULL,
  UNIQUE(structure, workload, params_json)) STRICT;
CREATE TABLE run(id INTEGER PRIMARY KEY, cell_id INTEGER NOT NULL REFERENCES cell(id),
  build_id INTEGER NOT NULL REFERENCES build(id),
  machine_id INTEGER NOT NULL REFERENCES machine(id), scene TEXT NOT NULL,
  scene_hash TEXT NOT NULL, structure TEXT NOT NULL, number_mode TEXT NOT NULL,
  seed INTEGER NOT NULL, objects INTEGER NOT NULL, status TEXT NOT NULL,
  started_utc TEXT NOT NULL, cpu_s REAL NOT NULL, peak_kb INTEGER NOT NULL,
  UNIQUE(cell_id, seed, number_mode)) STRICT;
CREATE TABLE counter(run_id INTEGER NOT NULL REFERENCES run(id), name TEXT NOT NULL,
  stage TEXT NOT NULL, value INTEGER NOT NULL,
  PRIMARY KEY(run_id, name, stage)) STRICT, WITHOUT ROWID;
CREATE TABLE extreme(run_id INTEGER NOT NULL REFERENCES run(id), name TEXT NOT NULL,
  value_text TEXT NOT NULL, PRIMARY KEY(run_id, name)) STRICT, WITHOUT ROWID;
CREATE TABLE claim_result(claim_id TEXT NOT NULL, cell_id INTEGER NOT NULL REFERENCES cell(id),
  quantity TEXT NOT NULL, kind TEXT NOT NULL, run_id INTEGER REFERENCES run(id),
  expected TEXT NOT NULL, observed TEXT NOT NULL, verdict TEXT NOT NULL, source TEXT NOT NULL,
  PRIMARY KEY(claim_id, cell_id, quantity)) STRICT, WITHOUT ROWID;
CREATE TABLE growth(claim_id TEXT NOT NULL, structure TEXT NOT NULL, family TEXT NOT NULL,
  quantity TEXT NOT NULL, points INTEGER NOT NULL, expected TEXT NOT NULL, exponent TEXT,
  lower_95 TEXT, upper_95 TEXT, chi_square TEXT, degrees INTEGER, verdict TEXT NOT NULL,
  source TEXT NOT NULL, PRIMARY KEY(claim_id, structure)) STRICT, WITHOUT ROWID;
CREATE TABLE study(name TEXT NOT NULL, claim_id TEXT NOT NULL, expected TEXT NOT NULL,
  observed TEXT NOT NULL, verdict TEXT NOT NULL, source TEXT NOT NULL,
  PRIMARY KEY(name, claim_id)) STRICT, WITHOUT ROWID;
)";

constexpr std::array<const char*, kStages> kStageNames{"double", "wide", "multiprecision", "exact"};

std::string parameters_json(const CellResult& cell) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("n").number(cell.cell.parameters.n);
  json.key("degree").number(cell.cell.parameters.degree);
  json.key("dimension").number(cell.cell.parameters.dimension);
  json.key("first_seed").number(cell.cell.parameters.seed);
  json.key("seeds").number(static_cast<std::uint64_t>(cell.trials.size()));
  if (cell.cell.parameters.m != 0) json.key("m").number(cell.cell.parameters.m);
  if (cell.cell.parameters.separation) {
    json.key("separation").string(cell.cell.parameters.separation->to_string());
  }
  if (cell.cell.parameters.turns != -1) json.key("turns").number(cell.cell.parameters.turns);
  if (cell.cell.turned) json.key("turned").boolean(true);
  json.key("mirrored").boolean(cell.cell.mirrored).end_object();
  return text;
}

class Writer {
 public:
  explicit Writer(Database& database)
      : cell_(database, "INSERT INTO cell VALUES(NULL, ?, ?, ?, ?, ?, ?, ?, ?)"),
        run_(database, "INSERT INTO run VALUES(NULL, ?, 1, 1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        counter_(database, "INSERT INTO counter VALUES(?, ?, ?, ?)"),
        extreme_(database, "INSERT INTO extreme VALUES(?, ?, ?)"),
        claim_(database, "INSERT INTO claim_result VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        study_(database, "INSERT INTO study VALUES(?, ?, ?, ?, ?, ?)"),
        growth_(database, "INSERT INTO growth VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)") {}

  void write(const CellResult& cell) {
    cell_.text(cell.cell.structure).text(cell.cell.workload).text(cell.cell.family);
    cell_.text(parameters_json(cell)).text(cell.cell.question);
    cell_.text(check_word(cell.verdict()));
    if (cell.contest && cell.contest->ratio) {
      cell_.text(number_text(*cell.contest->ratio, 4));
    } else {
      cell_.null();
    }
    const std::int64_t id = cell_.real(cell.seconds).run();
    std::vector<std::int64_t> runs;
    for (const Trial& trial : cell.trials) runs.push_back(write(id, cell, trial.measurement));
    if (cell.contest) write(id, cell, cell.contest->rival);
    for (const Check& check : cell.checks) {
      claim_.text(check.claim).integer(id).text(check.quantity).text(check.kind);
      if (check.trial && *check.trial < runs.size()) {
        claim_.integer(runs[*check.trial]);
      } else {
        claim_.null();
      }
      claim_.text(check.expected).text(check.observed).text(check_word(check.verdict));
      claim_.text(check.source).run();
    }
  }

  void write(const StudyResult& study) {
    for (const Check& check : study.checks) {
      study_.text(study.name).text(check.claim).text(check.expected).text(check.observed);
      study_.text(check_word(check.verdict)).text(check.source).run();
    }
  }

  void write(const GrowthResult& growth) {
    growth_.text(growth.claim.claim).text(growth.claim.structure).text(growth.claim.family);
    growth_.text(growth.claim.quantity).count(growth.points.size()).text(growth.check.expected);
    if (growth.fit) {
      for (const double value : {growth.fit->b, growth.fit->lower, growth.fit->upper}) {
        growth_.text(number_text(value, 8));
      }
      if (growth.fit->weighted) {
        growth_.text(number_text(growth.fit->chi_square, 8));
      } else {
        growth_.null();
      }
      growth_.integer(growth.fit->degrees);
    } else {
      for (int i = 0; i < 5; ++i) growth_.null();
    }
    growth_.text(check_word(growth.check.verdict)).text(growth.check.source).run();
  }

 private:
  std::int64_t write(std::int64_t cell_id, const CellResult& cell, const Measurement& run) {
    run_.integer(cell_id).text(run.scene_name).text(run.scene_hash).text(cell.cell.structure);
    run_.text(run.arithmetic).count(run.seed).count(run.objects).text(status_name(run.status));
    run_.text(run.started).real(run.seconds).count(run.run.peak_bytes / 1024);
    const std::int64_t id = run_.run();
    write_ledger(id, run);
    write_numbers(id, run);
    return id;
  }

  void write_ledger(std::int64_t id, const Measurement& run) {
    const StructureLedger& ledger = run.costs;
    count(id, "processed", ledger.processed);
    count(id, "external", run.ledger.external);
    count(id, "internal", ledger.internal);
    for (const auto& [kind, value] : ledger.by_kind) count(id, "kind." + kind, value);
    count(id, "instants", run.run.instants);
    count(id, "rebuilds", ledger.rebuilds);
    for (const auto& [reason, value] : ledger.rebuild_reasons)
      count(id, "rebuild." + reason, value);
    count(id, "simultaneous_groups", ledger.simultaneous_groups);
    count(id, "certificates_created", ledger.certificates_created);
    count(id, "certificates_retracted", ledger.certificates_retracted);
    count(id, "audit_checks", ledger.audit_checks);
    count(id, "audit_violations", ledger.audit_violations);
    extreme(id, "largest_group", ledger.largest_group);
    extreme(id, "certificates_live", ledger.max_live);
    extreme(id, "certificates_per_object", ledger.max_per_object);
    extreme(id, "created_per_event", ledger.created_per_event.max);
    extreme(id, "retracted_per_event", ledger.retracted_per_event.max);
    extreme(id, "queue", run.run.max_queue);
    extreme(id, "bytes", run.run.peak_bytes);
    extreme(id, "coefficient_bits", run.numbers.max_bits);
  }

  void write_numbers(std::int64_t id, const Measurement& run) {
    const ArithmeticCounters& numbers = run.numbers;
    for (std::size_t p = 0; p < numbers.by_predicate.size(); ++p) {
      for (std::size_t s = 0; s < kStages; ++s) {
        count(id, "signs." + run.predicates[p], numbers.by_predicate[p].signs[s], kStageNames[s]);
        count(id, "failures." + run.predicates[p], numbers.by_predicate[p].failures[s],
              kStageNames[s]);
        count(id, "looks." + run.predicates[p], numbers.by_predicate[p].looks[s], kStageNames[s]);
        count(id, "comparisons." + run.predicates[p], numbers.by_predicate[p].comparisons[s],
              kStageNames[s]);
      }
    }
    for (std::size_t s = 0; s < kStages; ++s) {
      count(id, "comparisons", numbers.comparisons[s], kStageNames[s]);
    }
    for (std::size_t d = 0; d < numbers.polynomials_solved.size(); ++d) {
      count(id, "polynomials_solved", numbers.polynomials_solved[d], std::to_string(d));
    }
    count(id, "roots_made_exact", numbers.roots_made_exact);
    count(id, "refinements", numbers.refinements);
    count(id, "gcds", numbers.gcds);
  }

  void count(std::int64_t id, std::string_view name, std::uint64_t value,
             std::string_view stage = "") {
    if (value != 0) counter_.integer(id).text(name).text(stage).count(value).run();
  }
  void extreme(std::int64_t id, std::string_view name, std::uint64_t value) {
    extreme_.integer(id).text(name).text(std::to_string(value)).run();
  }

  Statement cell_, run_, counter_, extreme_, claim_, study_, growth_;
};

}  // namespace

std::string verify_database(const VerifyResult& result, const BuildFacts& build,
                            const MachineFacts& machine) {
  Database database;
  write_facts(database, build, machine);
  database.execute(kSchema);
  database.execute("BEGIN");
  {
    Writer writer(database);
    for (const CellResult& cell : result.cells) writer.write(cell);
    for (const GrowthResult& growth : result.growths) writer.write(growth);
    for (const StudyResult& study : result.studies) writer.write(study);
  }
  database.execute("COMMIT");
  return database.serialise();
}

}  // namespace kinex
