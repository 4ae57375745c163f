// SPDX-License-Identifier: GPL-3.0-or-later
// kinex ccd: continuous collision detection, exactly.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/query_answers.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/progress.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct CcdOptions {
  std::vector<std::string> files;
  std::string kind;
  bool json = false;
  bool tally = false;
};

ContactKind kind_of(const CcdOptions& options, const std::string& file) {
  if (!options.kind.empty()) {
    const std::optional<ContactKind> kind = formats::find_contact_kind(options.kind);
    if (kind) return *kind;
    throw formats::InputError("--kind", "", show_text(options.kind) + " is not a kind of query",
                     "write vertex-face or edge-edge");
  }
  const std::optional<ContactKind> kind = formats::contact_kind_of_path(file);
  if (kind) return *kind;
  throw formats::InputError(file, "",
                   "its name does not tell whether the queries are vertex-face or edge-edge",
                   "give --kind vertex-face or --kind edge-edge");
}

// Returns false if it was interrupted.
bool answer_file(const CcdOptions& options, const std::string& file, const InterruptGuard& interrupt,
                 const Voice& voice, formats::ContactTally& tally) {
  constexpr std::size_t kFlush = 1 << 16;
  const ContactKind kind = kind_of(options, file);
  Deadline deadline(0, &interrupt.flag());
  const lab::GmpGuard guard(&deadline);
  formats::QueryFile queries;
  try {
    queries = formats::parse_queries(formats::read_text_file(file), file, kind, &deadline);
  } catch (const Stopped&) {
    return false;
  }
  ContactCounters counters;
  counters.roots.deadline = &deadline;
  constexpr std::size_t kEvery = 64;  // queries: the clock is not read at each
  lab::Progress progress(!voice.quiet);
  std::string text;
  for (const formats::FileQuery& one : queries.queries) {
    if (interrupt.interrupted()) break;
    formats::ContactAnswer answer;
    answer.number = tally.queries + 1;
    answer.line = one.line;
    if (queries.has_truth) answer.truth = one.truth;
    try {
      if (options.tally) {
        answer.contact = in_contact(one.query, counters);
      } else {
        answer.time = first_contact(one.query, counters);
        answer.contact = answer.time.has_value();
        text += options.json ? formats::answer_json(answer, counters.roots)
                             : formats::answer_text(answer, counters.roots);
      }
    } catch (const Stopped&) {
      break;
    }
    tally.count(answer.contact, answer.truth);
    if (text.size() > kFlush) {
      progress.wipe();
      print(text);
      text.clear();
    }
    if (tally.queries % kEvery != 0) continue;
    progress.show([&](double seconds) {
      return lab::progress_text(tally.queries, queries.queries.size(), seconds);
    });
  }
  deadline.pause();
  text += options.json ? formats::tally_json(tally, file, kind, queries.has_truth)
                       : formats::tally_text(tally, file, kind, queries.has_truth);
  progress.wipe();
  print(text);
  voice.detail(file + ": in doubles " + std::to_string(counters.at_once) + " at once, " +
               std::to_string(counters.subdivided) + " after [0, 1] was cut; exactly " +
               std::to_string(counters.exact));
  return tally.queries == queries.queries.size();
}

void answer_files(const CcdOptions& options, const Voice& voice, int& exit_code) {
  std::vector<InputArgument> inputs;
  for (const std::string& file : options.files) inputs.push_back({"FILE", file});
  check_standard_input(inputs);
  for (const std::string& file : options.files) kind_of(options, file);
  InterruptGuard interrupt;
  bool differs = false;
  for (const std::string& file : options.files) {
    formats::ContactTally tally;
    const bool finished = answer_file(options, file, interrupt, voice, tally);
    differs = differs || tally.differs();
    if (finished) continue;
    voice.error("interrupted; the tally is that of the first " +
                (tally.queries == 1 ? "query" : std::to_string(tally.queries) + " queries"));
    exit_code = kExitGaveUp;
    break;
  }
  if (differs) exit_code = kExitFailed;
}

}  // namespace

void add_ccd_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CcdOptions>();
  CLI::App* verb = app.add_subcommand(
      "ccd", "Continuous collision detection: exact answers and first times of contact");
  verb->add_option(
          "FILE", options->files,
          "Queries, 8 lines each: x_num,x_den,y_num,y_den,z_num,z_den[,truth] of four points "
          "at t = 0 and the same at t = 1 (vertex and triangle, or two edges); between them "
          "they move linearly; - reads standard input")
      ->required();
  verb->add_option("--kind", options->kind,
                   "vertex-face or edge-edge (default: from the name of the file or its folder)");
  verb->add_flag("--tally", options->tally,
                 "Print only the numbers of contacts and of answers that differ");
  verb->add_flag("--json", options->json, "Print one JSON object per query, and one per file");
  add_voice(*verb, "Print the answers and errors",
            "Count the answers by the stage that found them, on standard error");
  verb->footer(
      "Touching is contact, also at t = 0 and t = 1; a triangle or an edge may be\n"
      "degenerate. A first time that is not rational is printed as the root of a\n"
      "polynomial.\n"
      "Exit codes: 1 an answer differs from the truth column; 3 interrupted.\n"
      "Example: answers, and differences from the files' truth columns\n"
      "  kinex ccd edge-edge/data_0_0.csv vertex-face/data_0_0.csv --tally\n"
      "  kinex ccd queries.csv --kind vertex-face --json");
  verb->callback(
      [options, verb, &exit_code] { answer_files(*options, voice_of(*verb), exit_code); });
}

}  // namespace kinex::verbs
