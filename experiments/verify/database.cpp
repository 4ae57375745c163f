// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/database.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/formats/json_writer.h"
#include "experiments/lab/facts_tables.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/sqlite.h"

namespace kinex::verify {

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
  lower_95 TEXT, upper_95 TEXT, chi_square TEXT, degrees INTEGER, corrected_law TEXT,
  corrected_exponent TEXT, corrected_lower_95 TEXT, corrected_upper_95 TEXT,
  corrected_chi_square TEXT, corrected_degrees INTEGER, verdict TEXT NOT NULL,
  source TEXT NOT NULL, PRIMARY KEY(claim_id, structure)) STRICT, WITHOUT ROWID;
CREATE TABLE neighbour(claim_id TEXT NOT NULL, structure TEXT NOT NULL, law TEXT NOT NULL,
  standing TEXT NOT NULL, chi_square TEXT, degrees INTEGER NOT NULL, scatter TEXT NOT NULL,
  lead TEXT NOT NULL, PRIMARY KEY(claim_id, structure, law),
  FOREIGN KEY(claim_id, structure) REFERENCES growth(claim_id, structure)) STRICT, WITHOUT ROWID;
CREATE TABLE study(name TEXT NOT NULL, claim_id TEXT NOT NULL, expected TEXT NOT NULL,
  observed TEXT NOT NULL, verdict TEXT NOT NULL, source TEXT NOT NULL,
  PRIMARY KEY(name, claim_id)) STRICT, WITHOUT ROWID;
)";

constexpr std::array<const char*, kStages> kStageNames{"double", "wide", "multiprecision", "exact"};

std::string parameters_json(const lab::CellResult& cell) {
  std::string text;
  formats::JsonWriter json(text);
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
  explicit Writer(lab::Database& database)
      : cell_(database, "INSERT INTO cell VALUES(NULL, ?, ?, ?, ?, ?, ?, ?, ?)"),
        run_(database, "INSERT INTO run VALUES(NULL, ?, 1, 1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        counter_(database, "INSERT INTO counter VALUES(?, ?, ?, ?)"),
        extreme_(database, "INSERT INTO extreme VALUES(?, ?, ?)"),
        claim_(database, "INSERT INTO claim_result VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        study_(database, "INSERT INTO study VALUES(?, ?, ?, ?, ?, ?)"),
        growth_(
            database,
            "INSERT INTO growth VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        neighbour_(database, "INSERT INTO neighbour VALUES(?, ?, ?, ?, ?, ?, ?, ?)") {}

  void write(const lab::CellResult& cell) {
    cell_.text(cell.cell.structure).text(cell.cell.workload).text(cell.cell.family);
    cell_.text(parameters_json(cell)).text(cell.cell.question);
    cell_.text(lab::check_word(cell.verdict()));
    if (cell.contest && cell.contest->ratio) {
      cell_.text(lab::number_text(*cell.contest->ratio, 4));
    } else {
      cell_.null();
    }
    const std::int64_t id = cell_.real(cell.seconds).run();
    std::vector<std::int64_t> runs;
    for (const lab::Trial& trial : cell.trials) runs.push_back(write(id, cell, trial.measurement));
    if (cell.contest) write(id, cell, cell.contest->rival);
    for (const lab::Check& check : cell.checks) {
      claim_.text(check.claim).integer(id).text(check.quantity).text(check.kind);
      if (check.trial && *check.trial < runs.size()) {
        claim_.integer(runs[*check.trial]);
      } else {
        claim_.null();
      }
      claim_.text(check.expected).text(check.observed).text(lab::check_word(check.verdict));
      claim_.text(check.source).run();
    }
  }

  void write(const lab::StudyResult& study) {
    for (const lab::Check& check : study.checks) {
      study_.text(study.name).text(check.claim).text(check.expected).text(check.observed);
      study_.text(lab::check_word(check.verdict)).text(check.source).run();
    }
  }

  void write(const lab::GrowthResult& growth) {
    growth_.text(growth.claim.claim).text(growth.claim.structure).text(growth.claim.family);
    growth_.text(growth.claim.quantity).count(growth.points.size()).text(growth.check.expected);
    bind(growth.fit);
    if (growth.corrected) {
      growth_.text(growth.corrected->law);
    } else {
      growth_.null();
    }
    bind(growth.corrected);
    growth_.text(lab::check_word(growth.check.verdict)).text(growth.check.source).run();
    if (!growth.neighbours) return;
    const lab::Neighbours& neighbours = *growth.neighbours;
    write_law(growth, neighbours.law, "claimed", neighbours.claimed, neighbours.scatter,
              neighbours.weighted ? 0 : 1);
    for (const lab::Neighbours::Rival& rival : neighbours.rivals) {
      write_law(growth, rival.law,
                rival.better == lab::BetterFit::kFirst    ? "beaten"
                : rival.better == lab::BetterFit::kSecond ? "better"
                                                          : "undecided",
                rival.fit, rival.scatter, rival.lead);
    }
  }

 private:
  // Five columns: the exponent, its interval, chi squared, its degrees.
  void bind(const std::optional<lab::Fit>& fit) {
    if (!fit) {
      for (int i = 0; i < 5; ++i) growth_.null();
      return;
    }
    for (const double value : {fit->b, fit->lower, fit->upper}) {
      growth_.text(lab::number_text(value, 8));
    }
    if (fit->weighted) {
      growth_.text(lab::number_text(fit->chi_square, 8));
    } else {
      growth_.null();
    }
    growth_.integer(fit->degrees);
  }

  void write_law(const lab::GrowthResult& growth, const std::string& law, const char* standing,
                 const lab::Fit& fit, double scatter, double lead) {
    neighbour_.text(growth.claim.claim).text(growth.claim.structure).text(law).text(standing);
    if (growth.neighbours->weighted) {
      neighbour_.text(lab::number_text(fit.chi_square, 8));
    } else {
      neighbour_.null();
    }
    neighbour_.integer(fit.degrees).text(lab::number_text(scatter, 8));
    neighbour_.text(lab::number_text(lead, 8)).run();
  }

  std::int64_t write(std::int64_t cell_id, const lab::CellResult& cell, const lab::Measurement& run) {
    run_.integer(cell_id).text(run.scene_name).text(run.scene_hash).text(cell.cell.structure);
    run_.text(run.arithmetic).count(run.seed).count(run.objects).text(formats::status_name(run.status));
    run_.text(run.started).real(run.seconds).count(run.run.peak_bytes / 1024);
    const std::int64_t id = run_.run();
    write_ledger(id, run);
    write_numbers(id, run);
    return id;
  }

  void write_ledger(std::int64_t id, const lab::Measurement& run) {
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

  void write_numbers(std::int64_t id, const lab::Measurement& run) {
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

  lab::Statement cell_, run_, counter_, extreme_, claim_, study_, growth_, neighbour_;
};

}  // namespace

std::string verify_database(const VerifyResult& result, const lab::BuildFacts& build,
                            const lab::MachineFacts& machine) {
  lab::Database database;
  lab::write_facts(database, build, machine);
  database.execute(kSchema);
  database.execute("BEGIN");
  {
    Writer writer(database);
    for (const lab::CellResult& cell : result.cells) writer.write(cell);
    for (const lab::GrowthResult& growth : result.growths) writer.write(growth);
    for (const lab::StudyResult& study : result.studies) writer.write(study);
  }
  database.execute("COMMIT");
  return database.serialise();
}

}  // namespace kinex::verify
