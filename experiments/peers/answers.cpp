// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/lab/result_table.h"
#include "experiments/peers/tables.h"
#include "experiments/peers/worker.h"

namespace kinex::peers {

namespace {

struct Family {
  std::string name;
  std::vector<PeerQuestion> questions;
};

Family family_of(PeerQuestions& questions, std::string name, const std::vector<PeerCase>& cases) {
  Family family{std::move(name), {}};
  for (const PeerCase& one : cases) family.questions.push_back(questions.of(one));
  return family;
}

std::vector<Judgement> judgements(const PeerMethod& method, const Family& family) {
  std::vector<PeerCase> cases;
  for (const PeerQuestion& question : family.questions) cases.push_back(question.exact);
  const std::vector<PeerAnswer> answers = ask_all(method, cases);
  std::vector<Judgement> result;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    result.push_back(judge(method, family.questions[i], answers[i]));
  }
  return result;
}

PeerTally tally_of(const PeerMethod& method, const Family& family) {
  PeerTally tally;
  for (const Judgement& one : judgements(method, family)) tally.add(one);
  return tally;
}

std::string exponent(int k) { return "1e-" + std::to_string(k); }

// The checks of the true answers, in words.
std::string checked(const Family& family) {
  int witness = 0, structure = 0, overlaps = 0, touches = 0, unknown = 0;
  for (const PeerQuestion& question : family.questions) {
    for (const Truth* truth : {&question.truth, &question.truth_single}) {
      ++(truth->by_witness ? witness : structure);
    }
    overlaps += question.truth.kind == TruthKind::kOverlap ? 1 : 0;
    touches += question.truth.kind == TruthKind::kTouch ? 1 : 0;
    unknown += question.truth.kind == TruthKind::kUnknown ? 1 : 0;
  }
  return family.name + ": " + std::to_string(family.questions.size()) + " questions, of which " +
         std::to_string(overlaps) + " overlap, " + std::to_string(touches) + " touch and " +
         std::to_string(unknown) + " are not known (in doubles); " + std::to_string(witness) +
         " truths checked by the witness, " + std::to_string(structure) +
         " by a second structure. ";
}

void families_table(const lab::BenchOptions& options, const std::vector<PeerMethod>& methods,
                    const std::vector<Family>& families) {
  std::string about =
      "Answers by family. missed: false negatives. alarms: false positives at a gap beyond the "
      "documented tolerance. tolerated: contacts within it, or at a mere touch. Of right contacts: "
      "the widest gap and the deepest overlap of the reported pose, and how far its time is off. ";
  for (const Family& family : families) about += checked(family);
  lab::ResultTable table(options, "peers_answers", about,
                         {{"family", lab::ResultTable::kText, 14},
                          {"method", lab::ResultTable::kText, 22},
                          {"certifies", lab::ResultTable::kText, 19},
                          {"asked", 0},
                          {"right", 0},
                          {"missed", 0},
                          {"alarms", 0},
                          {"tolerated", 0},
                          {"failed", 0},
                          {"NaN", 0},
                          {"no_end", 0},
                          {"crashed", 0},
                          {"not_taken", 0},
                          {"widest_gap", 9},
                          {"deepest_overlap", 9},
                          {"earliest", 9},
                          {"latest", 9}});
  for (const Family& family : families) {
    for (const PeerMethod& method : methods) {
      const PeerTally s = tally_of(method, family);
      table.row({family.name, method.name, method.certifies, s.asked, s.right, s.missed, s.alarms,
                 s.tolerated, s.failed, s.not_a_number, s.no_end, s.crashed, s.unsupported,
                 s.widest_gap, s.deepest_overlap, s.earliest, s.latest});
    }
  }
}

// A column for each gap: the errors of the answers.
void gaps_table(const lab::BenchOptions& options, PeerQuestions& questions,
                const std::vector<PeerMethod>& methods, bool apart, const std::vector<int>& powers,
                const std::vector<int>& sizes) {
  std::vector<Family> families;
  std::vector<lab::ResultTable::Column> columns{{"method", lab::ResultTable::kText, 22}};
  for (const int k : powers) {
    std::vector<PeerCase> cases;
    for (const int n : sizes) cases.push_back(line_case(n, (apart ? 1 : -1) * std::pow(10.0, -k)));
    families.push_back(family_of(questions, "", cases));
    columns.push_back({exponent(k), lab::ResultTable::kText, 8});
  }
  std::string about = apart ? "B passes A at this gap: false alarms beyond the tolerance."
                            : "B overlaps A by this much, in passing: overlaps that are missed.";
  about += " Of " + std::to_string(sizes.size()) +
           " sizes of polygons; t: contacts within the "
           "tolerance or at a touch; f: failed, NaN or no end; -: not taken. Truth is that of the "
           "numbers given: floats cannot hold the small gaps, and what is then a touch or the "
           "other answer is judged as that.";
  lab::ResultTable table(options, apart ? "peers_apart" : "peers_overlap", about,
                         std::move(columns));
  for (const PeerMethod& method : methods) {
    std::vector<lab::ResultTable::Field> row{method.name};
    for (const Family& family : families) {
      const PeerTally s = tally_of(method, family);
      const int wrong = s.missed + s.alarms;
      const int failed = s.failed + s.not_a_number + s.no_end + s.crashed;
      std::string text = wrong > 0 ? std::to_string(wrong) : ".";
      if (s.tolerated > 0) text += " " + std::to_string(s.tolerated) + "t";
      if (failed > 0) text += " " + std::to_string(failed) + "f";
      if (s.unsupported > 0) text += " " + std::to_string(s.unsupported) + "-";
      row.push_back(text);
    }
    table.row(row);
  }
}

void corpus_table(const lab::BenchOptions& options, PeerQuestions& questions,
                  std::vector<PeerMethod> methods) {
  const Family corpus = family_of(questions, "corpus", corpus_cases());
  std::vector<lab::ResultTable::Column> columns{{"case", lab::ResultTable::kText, 40},
                                                {"exact", lab::ResultTable::kText, 10}};
  std::erase_if(methods, [](const PeerMethod& method) {
    return method.kind == PeerMethod::Kind::kAdvance && method.stop != 1e-3;
  });
  std::vector<std::vector<Judgement>> all;
  for (const PeerMethod& method : methods) {
    columns.push_back({method.name, lab::ResultTable::kText, 12});
    all.push_back(judgements(method, corpus));
  }
  lab::ResultTable table(
      options, "peers_corpus",
      "Reported failures: the exact time of the first overlap, and what is said "
      "(with the error of the time). One step each, as far as a library takes it: "
      "FCL and Bullet take less than half a turn, so longer ones are cut.",
      std::move(columns));
  for (std::size_t i = 0; i < corpus.questions.size(); ++i) {
    const PeerQuestion& question = corpus.questions[i];
    char exact[40];
    std::snprintf(exact, sizeof exact, "%.6f", question.truth.latest);
    std::vector<lab::ResultTable::Field> row{
        question.exact.name, question.truth.kind == TruthKind::kOverlap ? exact : "apart"};
    for (const auto& judged : all) row.push_back(in_words(judged[i]));
    table.row(row);
  }
}

}  // namespace

void answer_tables(const lab::BenchOptions& options, PeerQuestions& questions) {
  const bool quick = options.smoke;
  const std::vector<PeerMethod> methods = peer_methods();
  const std::vector<int> sizes =
      quick ? std::vector<int>{8} : std::vector<int>{8, 16, 64, 200, 255};
  const std::vector<int> powers =
      quick ? std::vector<int>{1, 3} : std::vector<int>{1, 2, 3, 4, 6, 9, 12};
  std::vector<PeerCase> random8, random64, spins, orbits, touches;
  for (int seed = 1; seed <= (quick ? 2 : 30); ++seed) {
    random8.push_back(random_case(8, seed));
    if (seed <= 12 && !quick) random64.push_back(random_case(64, seed));
  }
  for (const int n : sizes) {
    spins.push_back(spin_case(n, 4));
    touches.push_back(touch_case(n / 4 * 4));
    for (const double gap : {0.1, 0.01, 0.001}) orbits.push_back(orbit_case(n, gap));
  }
  std::vector<Family> families{family_of(questions, "random, n=8", random8)};
  if (!quick) families.push_back(family_of(questions, "random, n=64", random64));
  families.push_back(family_of(questions, "spin", spins));
  families.push_back(family_of(questions, "orbit", orbits));
  families.push_back(family_of(questions, "touch", touches));
  families_table(options, methods, families);
  gaps_table(options, questions, methods, false, powers, sizes);
  gaps_table(options, questions, methods, true, powers, sizes);
  if (!quick) corpus_table(options, questions, methods);
}

}  // namespace kinex::peers
