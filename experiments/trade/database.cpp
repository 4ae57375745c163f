// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/trade/database.h"

#include "experiments/lab/facts_tables.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/sqlite.h"
#include "experiments/trade/standings.h"

namespace kinex::trade {

namespace {

constexpr int kDigits = 6;
constexpr const char* kSchema = R"(
CREATE TABLE trade_case(id INTEGER PRIMARY KEY, build_id INTEGER NOT NULL REFERENCES build(id),
  machine_id INTEGER NOT NULL REFERENCES machine(id), structure TEXT NOT NULL, name TEXT NOT NULL,
  scene TEXT NOT NULL, scene_hash TEXT NOT NULL, objects INTEGER NOT NULL,
  degree INTEGER NOT NULL, seed INTEGER NOT NULL, events INTEGER NOT NULL,
  instants INTEGER NOT NULL, bits_most INTEGER, bits_99 INTEGER, bits_time TEXT, problem TEXT,
  wall_s REAL NOT NULL) STRICT;
CREATE TABLE trade_run(case_id INTEGER NOT NULL REFERENCES trade_case(id),
  arithmetic TEXT NOT NULL, standing TEXT NOT NULL, ending TEXT NOT NULL, trouble TEXT,
  guard_fired INTEGER NOT NULL, cpu_s REAL, time_over_double TEXT, peak_bytes INTEGER NOT NULL,
  memory_over_double TEXT, events INTEGER NOT NULL, missed INTEGER NOT NULL,
  invented INTEGER NOT NULL, inversions INTEGER NOT NULL, first_event INTEGER, first_time TEXT,
  error_s REAL NOT NULL, error_ulps TEXT NOT NULL, checkpoints INTEGER NOT NULL,
  valid INTEGER NOT NULL, valid_at_end INTEGER NOT NULL, first_wrong TEXT, violation TEXT,
  PRIMARY KEY(case_id, arithmetic)) STRICT, WITHOUT ROWID;
CREATE TABLE bits(structure TEXT NOT NULL, family TEXT NOT NULL, n INTEGER NOT NULL,
  scenes INTEGER NOT NULL, instants TEXT NOT NULL, most_mean TEXT NOT NULL,
  most_error TEXT NOT NULL, most_largest TEXT NOT NULL, p99_mean TEXT NOT NULL,
  p99_error TEXT NOT NULL, PRIMARY KEY(structure, family, n)) STRICT, WITHOUT ROWID;
CREATE TABLE bits_growth(structure TEXT NOT NULL, family TEXT NOT NULL, quantity TEXT NOT NULL,
  bits_per_doubling TEXT NOT NULL, lower_95 TEXT NOT NULL, upper_95 TEXT NOT NULL,
  factor TEXT NOT NULL, PRIMARY KEY(structure, family, quantity)) STRICT, WITHOUT ROWID;
)";

class Writer {
 public:
  explicit Writer(lab::Database& database)
      : case_(database,
              "INSERT INTO trade_case VALUES(NULL, 1, 1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
              "?)"),
        run_(database,
             "INSERT INTO trade_run VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
             "?, ?, ?, ?, ?)"),
        bits_(database, "INSERT INTO bits VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        growth_(database, "INSERT INTO bits_growth VALUES(?, ?, ?, ?, ?, ?, ?)") {}

  void write(const CaseResult& one) {
    case_.text(one.which.structure).text(one.which.name).text(one.scene_name);
    case_.text(one.scene_hash).count(one.objects).integer(one.which.parameters.degree);
    case_.count(one.which.parameters.seed).count(one.events);
    case_.count(one.bits.instants);
    if (one.bits.pairs > 0) {
      case_.integer(one.bits.most).integer(one.bits.percentile_99).text(one.bits.time);
    } else {
      case_.null().null().null();
    }
    maybe(case_, one.problem);
    const std::int64_t id = case_.real(one.seconds).run();
    for (const TradeRun& run : one.runs) write(id, one, run);
  }

  void write(const BitsResult& one) {
    bits_.text(one.which.structure).text(one.which.family).integer(one.which.parameters.n);
    bits_.integer(one.which.seeds);
    for (const double value :
         {one.instants.mean(), one.most.mean(), one.most.standard_error(), one.most.largest(),
          one.percentile_99.mean(), one.percentile_99.standard_error()}) {
      bits_.text(lab::number_text(value, kDigits));
    }
    bits_.run();
  }

  void write(const BitsGrowth& growth) {
    write(growth, "most", growth.most);
    write(growth, "percentile_99", growth.percentile_99);
  }

 private:
  static void maybe(lab::Statement& statement, const std::string& text) {
    if (text.empty()) {
      statement.null();
    } else {
      statement.text(text);
    }
  }
  static void maybe(lab::Statement& statement, const std::optional<double>& value) {
    if (value) {
      statement.text(lab::number_text(*value, kDigits));
    } else {
      statement.null();
    }
  }

  void write(std::int64_t id, const CaseResult& one, const TradeRun& run) {
    const Deviation& deviation = run.deviation;
    run_.integer(id).text(run.arithmetic);
    run_.text(standing_name(run.standing())).text(ending_name(run.ending));
    maybe(run_, run.trouble);
    run_.integer(run.guard_fired ? 1 : 0);
    if (run.seconds) {
      run_.real(*run.seconds);
    } else {
      run_.null();
    }
    maybe(run_, one.time_ratio(run));
    run_.count(run.peak_bytes);
    maybe(run_, one.memory_ratio(run));
    run_.count(run.events).count(deviation.missed).count(deviation.invented);
    run_.count(deviation.inversions);
    if (deviation.first > 0) {
      run_.count(deviation.first).text(deviation.first_time);
    } else {
      run_.null().null();
    }
    run_.real(deviation.error).text(lab::number_text(deviation.error_ulps, kDigits));
    run_.integer(run.checkpoints).integer(run.valid).integer(run.valid_at_end ? 1 : 0);
    maybe(run_, run.first_wrong);
    maybe(run_, run.violation);
    run_.run();
  }

  void write(const BitsGrowth& growth, const char* quantity, const std::optional<lab::Fit>& fit) {
    if (!fit) return;
    growth_.text(growth.structure).text(growth.family).text(quantity);
    for (const double value : {fit->b, fit->lower, fit->upper, fit->a}) {
      growth_.text(lab::number_text(value, kDigits));
    }
    growth_.run();
  }

  lab::Statement case_, run_, bits_, growth_;
};

}  // namespace

std::string trade_database(const TradeResult& result, const lab::BuildFacts& build,
                           const lab::MachineFacts& machine) {
  lab::Database database;
  lab::write_facts(database, build, machine);
  database.execute(kSchema);
  database.execute("BEGIN");
  {
    Writer writer(database);
    for (const CaseResult& one : result.cases) writer.write(one);
    for (const BitsResult& one : result.bits) writer.write(one);
    for (const BitsGrowth& growth : result.growths) writer.write(growth);
  }
  database.execute("COMMIT");
  return database.serialise();
}

}  // namespace kinex::trade
