// SPDX-License-Identifier: GPL-3.0-or-later
// kinex log: the records of an event log as a table.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/log_ending.h"
#include "experiments/formats/log_scene.h"
#include "experiments/formats/log_table.h"
#include "experiments/formats/plain_text.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct LogOptions {
  std::string file, output;
  std::vector<std::string> filters, columns;
  bool table = false, csv = false, force = false;
};

void show_log(const LogOptions& options, const Voice& voice) {
  keep_input("--output", options.output, options.file);
  formats::LogFilter filter;
  for (const std::string& text : options.filters) filter.add(text);
  const std::string text = formats::read_text_file(options.file);
  formats::LogReader reader(text, options.file);
  filter.fit(reader);
  const formats::LogTable table = formats::log_table(
      reader, filter, options.csv ? formats::LogTableForm::kCsv : formats::LogTableForm::kPlain,
      options.columns);
  write_result(options.output, options.force, table.text);
  const formats::LogHeader& header = reader.header();
  voice.detail(formats::plain("scene " + header.scene + " in " + header.arithmetic + ", " +
                              formats::structures_of(header) + ", by " + header.build));
  if (table.complete) {
    voice.detail("run " + reader.end()->status + ", " +
                 formats::counted(reader.end()->records, "log record", "log records") + ", " +
                 table.external.text() + ", digest " + reader.end()->digest);
  }
  if (!filter.wants_all()) {
    voice.note(std::to_string(table.shown) + " of " +
               formats::counted(table.records, "log record", "log records"));
  }
  const formats::LogEnding ending = formats::ending_of(reader);
  const std::string note = formats::ending_note(ending, options.file);
  if (!note.empty()) voice.note(note);
  for (const std::string& one : formats::corruption_texts(ending.corrupt)) {
    voice.note(options.file + ": " + one);
  }
}

}  // namespace

void add_log_verb(CLI::App& app, int&) {
  auto options = std::make_shared<LogOptions>();
  CLI::App* verb = app.add_subcommand("log", "Shows the records of an event log as a table");
  verb->add_option("LOG", options->file, "An event log, - reads standard input")->required();
  CLI::Option* const table = verb->add_flag("--table", options->table, "Aligned columns (default)");
  verb->add_flag("--csv", options->csv, "Comma-separated values, with the exact instants")
      ->excludes(table);
  verb->add_option(
          "--filter", options->filters,
          "Only records with KEY=VALUE,..; KEY is kind, structure, object, predicate or external; "
          "values of one key, as kind=flip,enter, are alternatives; can be given several times")
      ->allow_extra_args(false);
  add_list_option(*verb, "--columns", options->columns,
                  "Only these columns, in this order, as time,kind,ids")
      ->allow_extra_args(false);
  verb->add_option("-o,--output", options->output, "File to write (standard output)");
  verb->add_flag("--force", options->force, "Replace the file if it exists");
  add_voice(*verb, "Print the table and errors, no counts",
            "Say what the log's first and last lines say, on standard error");
  verb->footer(
      "Ids in one field have spaces between them; an id with a space is a JSON string.\n"
      "Columns: seq, time (decimal), exactly (a fraction, or a root of a polynomial),\n"
      "structure, kind, ids, effect, certificate.\n"
      "Columns of --csv: seq, time (decimal), polynomial (coefficients, low degree\n"
      "first), root (its number), lower and upper (an interval that isolates it),\n"
      "structure, kind, ids, external, predicate and certificate_ids (of the\n"
      "certificate that failed), gone, came, reason.\n"
      "Example:\n"
      "  kinex log square.log --filter kind=flip,enter,object=p7\n"
      "  kinex log square.log --filter external=true --columns time,ids\n"
      "  kinex log square.log --csv --filter external=true -o changes.csv");
  verb->callback([options, verb] { show_log(*options, voice_of(*verb)); });
}

}  // namespace kinex::verbs
