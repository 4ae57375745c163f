// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/database.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/lab/result_database.h"
#include "experiments/lab/scene_run.h"
#include "experiments/verify/report_text.h"

namespace kinex::verify {

namespace {

constexpr int kDigits = 8;
constexpr std::array<const char*, kStages> kStageNames{"double", "wide", "multiprecision", "exact"};

class Writer {
 public:
  explicit Writer(lab::ResultDatabase& database) : database_(database) {}

  void write(const lab::CellResult& cell) {
    const std::int64_t id = database_.insert(
        "cell", nullptr, cell.cell.structure, cell.cell.workload, cell.cell.family,
        parameters_json(cell, true), cell.cell.question, lab::check_word(cell.verdict()),
        lab::number_text(exact_over_double(cell), 4), cell.seconds);
    std::vector<std::int64_t> runs;
    for (const lab::Trial& trial : cell.trials) runs.push_back(write(id, cell, trial.measurement));
    if (cell.contest) write(id, cell, cell.contest->rival);
    for (const lab::Check& check : cell.checks) {
      std::optional<std::int64_t> run;
      if (check.trial && *check.trial < runs.size()) run = runs[*check.trial];
      database_.insert("claim_result", check.claim, id, check.quantity, check.kind, run,
                       check.expected, check.observed, lab::check_word(check.verdict), check.source);
    }
  }

  void write(const lab::StudyResult& study) {
    for (const lab::Check& check : study.checks) {
      database_.insert("study", study.name, check.claim, check.expected, check.observed,
                       lab::check_word(check.verdict), check.source);
    }
  }

  void write(const lab::GrowthResult& growth) {
    const lab::GrowthClaim& claim = growth.claim;
    const Fitted fit(growth.fit), more(growth.corrected);
    database_.insert("growth", claim.claim, claim.structure, claim.family, claim.quantity,
                     growth.points.size(), growth.check.expected, fit.exponent, fit.lower, fit.upper,
                     fit.chi_square, fit.degrees, more.law, more.exponent, more.lower, more.upper,
                     more.chi_square, more.degrees, lab::check_word(growth.check.verdict),
                     growth.check.source);
    if (!growth.neighbours) return;
    const lab::Neighbours& all = *growth.neighbours;
    const auto write_law = [&](const std::string& law, std::string_view standing, const lab::Fit& of,
                               double scatter, double lead) {
      const auto chi_square = all.weighted ? std::optional(of.chi_square) : std::nullopt;
      database_.insert("neighbour", claim.claim, claim.structure, law, standing,
                       lab::number_text(chi_square, kDigits), of.degrees,
                       lab::number_text(scatter, kDigits), lab::number_text(lead, kDigits));
    };
    write_law(all.law, "claimed", all.claimed, all.scatter, all.weighted ? 0 : 1);
    for (const lab::Neighbours::Rival& rival : all.rivals) {
      write_law(rival.law, lab::outcome_word(rival.better), rival.fit, rival.scatter, rival.lead);
    }
  }

 private:
  // The columns of a fit; all NULL without one.
  struct Fitted {
    explicit Fitted(const std::optional<lab::Fit>& fit) {
      if (!fit) return;
      law = fit->law;
      exponent = lab::number_text(fit->b, kDigits);
      lower = lab::number_text(fit->lower, kDigits);
      upper = lab::number_text(fit->upper, kDigits);
      chi_square = lab::number_text(lab::chi_square_of(*fit), kDigits);
      degrees = fit->degrees;
    }
    std::optional<std::string> law, exponent, lower, upper, chi_square;
    std::optional<int> degrees;
  };

  std::int64_t write(std::int64_t cell, const lab::CellResult& of, const lab::Measurement& run) {
    const std::int64_t id = database_.insert(
        "run", nullptr, cell, 1, 1, run.scene_name, run.scene_hash, of.cell.structure, run.arithmetic,
        run.seed, run.objects, formats::status_name(run.status), run.started, run.seconds,
        run.run.peak_bytes / 1024);
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
    for (const auto& [reason, value] : ledger.rebuild_reasons) count(id, "rebuild." + reason, value);
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
    for (std::size_t s = 0; s < kStages; ++s) {
      for (std::size_t p = 0; p < numbers.by_predicate.size(); ++p) {
        const PredicateCounters& of = numbers.by_predicate[p];
        count(id, "signs." + run.predicates[p], of.signs[s], kStageNames[s]);
        count(id, "failures." + run.predicates[p], of.failures[s], kStageNames[s]);
        count(id, "looks." + run.predicates[p], of.looks[s], kStageNames[s]);
        count(id, "comparisons." + run.predicates[p], of.comparisons[s], kStageNames[s]);
      }
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
    if (value != 0) database_.insert("counter", id, name, stage, value);
  }
  void extreme(std::int64_t id, std::string_view name, std::uint64_t value) {
    database_.insert("extreme", id, name, std::to_string(value));
  }

  lab::ResultDatabase& database_;
};

}  // namespace

std::string verify_database(const VerifyResult& result, const lab::BuildFacts& build,
                            const lab::MachineFacts& machine) {
  lab::ResultDatabase database(lab::verify_schema());
  database.insert_facts(build, machine);
  Writer writer(database);
  for (const lab::CellResult& cell : result.cells) writer.write(cell);
  for (const lab::GrowthResult& growth : result.growths) writer.write(growth);
  for (const lab::StudyResult& study : result.studies) writer.write(study);
  return database.bytes();
}

}  // namespace kinex::verify
