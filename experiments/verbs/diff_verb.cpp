// SPDX-License-Identifier: GPL-3.0-or-later
// kinex diff: where two runs first part, and how much they disagree.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "experiments/file_io.h"
#include "experiments/json_writer.h"
#include "experiments/log_diff.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"

namespace kinex {

namespace {

struct DiffOptions {
  std::string a, b;
  bool json = false;
};

std::string place(const std::string& file, std::size_t line, const std::string& text) {
  if (line == 0) return "  " + file + ": has ended\n";
  return "  " + file + ":" + std::to_string(line) + ": " + text + "\n";
}

std::string plain_text(const LogDifference& difference, const DiffOptions& options) {
  std::string text;
  if (difference.other_scenes) text += "the logs are of different scenes\n";
  if (difference.equal()) {
    return text + "equal: " + std::to_string(difference.events_a) + " events\n";
  }
  text += "first difference at event " + std::to_string(difference.first) + "\n";
  text += place(options.a, difference.line_a, difference.text_a);
  text += place(options.b, difference.line_b, difference.text_b);
  text += std::to_string(difference.events_a) + " and " + std::to_string(difference.events_b) +
          " events: " + std::to_string(difference.missing) + " missing, " +
          std::to_string(difference.invented) + " invented, " +
          std::to_string(difference.out_of_order) + " out of order, " +
          std::to_string(difference.other_instants) + " at another instant\n";
  return text;
}

std::string json_text(const LogDifference& difference) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("equal").boolean(difference.equal());
  json.key("same_scene").boolean(!difference.other_scenes);
  json.key("events").begin_array().number(difference.events_a).number(difference.events_b);
  json.end_array().key("first").number(difference.first);
  json.key("missing").number(difference.missing).key("invented").number(difference.invented);
  json.key("out_of_order").number(difference.out_of_order);
  json.key("other_instants").number(difference.other_instants).end_object();
  return text + "\n";
}

void diff(const DiffOptions& options, int& exit_code) {
  const std::string a = read_text_file(options.a);
  const std::string b = read_text_file(options.b);
  const LogDifference difference = diff_logs(a, options.a, b, options.b);
  print(options.json ? json_text(difference) : plain_text(difference, options));
  if (!difference.equal()) exit_code = kExitFailed;
}

}  // namespace

void add_diff_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* verb = app.add_subcommand("diff", "Compares two event logs");
  verb->add_option("LOG", options->a, "The log to compare with")->required();
  verb->add_option("OTHER", options->b, "The log that may miss or invent events")->required();
  verb->add_flag("--json", options->json, "Print one JSON object");
  verb->footer(
      "Exit code 0: equal, 1: different. Instants are compared between two exact logs only.\n"
      "Example:\n  kinex diff exact.log double.log");
  verb->callback([options, &exit_code] { diff(*options, exit_code); });
}

}  // namespace kinex
