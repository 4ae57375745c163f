// SPDX-License-Identifier: GPL-3.0-or-later
// kinex diff: the first difference of two runs, and the amount of disagreement.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numbers/time_text.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/log_diff.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct DiffOptions {
  std::string a, b;
  bool json = false;
};

// "  a.log:13:  12  0.333  1/3  sorted_list  swap  ..", with places as wide as `width`.
std::string row(const std::string& file, std::size_t line, const std::string& text,
                std::size_t width) {
  if (line == 0) return "  " + file + ": has ended\n";
  std::string place = file + ":" + std::to_string(line) + ":";
  place.resize(std::max(place.size(), width), ' ');
  return "  " + place + "  " + text + "\n";
}

std::string rows(const formats::LogDifference& difference, const DiffOptions& options) {
  std::size_t width = 0;
  for (const auto& [file, line] :
       {std::pair(options.a, difference.line_a), {options.b, difference.line_b}}) {
    if (line != 0) width = std::max(width, file.size() + std::to_string(line).size() + 2);
  }
  return row(options.a, difference.line_a, difference.row_a, width) +
         row(options.b, difference.line_b, difference.row_b, width);
}

std::string listed(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : ", ") + label;
  return text;
}

std::string_view instants_text(formats::InstantsCompared compared) {
  switch (compared) {
    case formats::InstantsCompared::kExactly:
      return "instants compared exactly";
    case formats::InstantsCompared::kIntervals:
      return "instants compared as far as the intervals of both logs decide";
    case formats::InstantsCompared::kNot:
      return "instants not compared";
  }
  return "";
}

std::string end_text(const formats::LogEnding& ending) {
  return ending.reached ? "at t = " + time_text(*ending.reached) : "when no event is left";
}

std::string plain_text(const formats::LogDifference& difference, const DiffOptions& options) {
  std::string text;
  if (difference.other_scenes) text += "the logs are of different scenes\n";
  for (const auto& [file, only] :
       {std::pair(options.a, difference.only_a), {options.b, difference.only_b}}) {
    if (!only.empty()) text += "only in " + file + ", not compared: " + listed(only) + "\n";
  }
  for (const formats::OtherLabel& one : difference.other_labels) {
    text += one.label_a + " of " + options.a + " is compared with " + one.label_b + " of " +
            options.b + "\n";
  }
  const formats::LogEnding &a = difference.ending_a, &b = difference.ending_b;
  for (const auto& [file, ending] : {std::pair(options.a, a), {options.b, b}}) {
    if (!ending.whole()) text += file + " " + formats::ending_text(ending) + "\n";
  }
  if (a.whole() && b.whole() && a.reached != b.reached) {
    text += options.a + " ends " + end_text(a) + ", " + options.b + " " + end_text(b) + "\n";
  }
  const std::string how = "; " + std::string(instants_text(difference.instants)) + "\n";
  if (difference.equal()) {
    return text + "equal: " + formats::counted(difference.events_a, "record", "records") + how;
  }
  if (difference.first != 0) {
    text += "first difference at record " + std::to_string(difference.first) + "\n";
    text += rows(difference, options);
  }
  text += std::to_string(difference.events_a) + " and " +
          formats::counted(difference.events_b, "record", "records") + ": " +
          std::to_string(difference.missing) + " missing, " + std::to_string(difference.invented) +
          " invented, " + std::to_string(difference.out_of_order) + " out of order, " +
          std::to_string(difference.other_effects) + " with another effect";
  if (difference.instants != formats::InstantsCompared::kNot) {
    text += ", " + std::to_string(difference.other_instants) + " at another instant";
  }
  text += how;
  if (difference.other_records != 0) {
    text += formats::counted(difference.other_records, "record of a change is", "records of changes are") +
            " in one log only\n";
  }
  return text;
}

void write_labels(formats::JsonWriter& json, const std::vector<std::string>& labels) {
  json.begin_array();
  for (const std::string& label : labels) json.string(label);
  json.end_array();
}

std::string_view compared_name(formats::InstantsCompared compared) {
  switch (compared) {
    case formats::InstantsCompared::kExactly:
      return "exactly";
    case formats::InstantsCompared::kIntervals:
      return "intervals";
    case formats::InstantsCompared::kNot:
      return "not";
  }
  return "";
}

std::string json_text(const formats::LogDifference& difference) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("equal").boolean(difference.equal());
  json.key("same_scene").boolean(!difference.other_scenes);
  json.key("only_in").begin_array();
  write_labels(json, difference.only_a);
  write_labels(json, difference.only_b);
  json.end_array();
  const formats::LogEnding &a = difference.ending_a, &b = difference.ending_b;
  json.key("status").begin_array().string(a.status).string(b.status).end_array();
  json.key("reached").begin_array();
  for (const formats::LogEnding* ending : {&a, &b}) {
    ending->reached ? json.quoted(*ending->reached) : json.null();
  }
  json.end_array();
  json.key("events").begin_array().number(difference.events_a).number(difference.events_b);
  json.end_array().key("first").number(difference.first);
  json.key("missing").number(difference.missing).key("invented").number(difference.invented);
  json.key("out_of_order").number(difference.out_of_order);
  json.key("other_effects").number(difference.other_effects);
  json.key("other_instants").number(difference.other_instants);
  json.key("other_records").number(difference.other_records);
  json.key("instants_compared").string(compared_name(difference.instants)).end_object();
  return text + "\n";
}

void diff(const DiffOptions& options, const Voice& voice, int& exit_code) {
  const std::string a = formats::read_text_file(options.a);
  const std::string b = formats::read_text_file(options.b);
  const formats::LogDifference difference = formats::diff_logs(a, options.a, b, options.b);
  for (const formats::KindDifference& one : difference.kinds) {
    voice.detail(one.structure + " " + one.kind + ": " + std::to_string(one.events_a) + " and " +
                 formats::counted(one.events_b, "record", "records") + ", " +
                 std::to_string(one.missing) + " missing, " + std::to_string(one.invented) +
                 " invented");
  }
  if (options.json) {
    print(json_text(difference));
  } else {
    voice.report(plain_text(difference, options));
  }
  if (!difference.equal()) exit_code = kExitFailed;
}

}  // namespace

void add_diff_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* verb = app.add_subcommand("diff", "Compares two event logs");
  verb->add_option("LOG", options->a, "The log to compare with")->required();
  verb->add_option("OTHER", options->b, "The log that may miss or invent events")->required();
  verb->add_flag("--json", options->json, "Print one JSON object");
  add_voice(*verb, "Print nothing: the exit code tells whether they differ",
            "Count the differences of every kind of record, on standard error");
  verb->footer(
      "Exit code 0: equal, 1: different. Compared and counted are the log records of\n"
      "events, external and internal, of the structures that both logs have, whatever\n"
      "their labels; not those of changes of the scene (motion, insert, erase) and of\n"
      "rebuilds that change nothing. Instants are compared between two exact logs only,\n"
      "as numbers. A log that was cut off, or stopped at a limit, is compared as far as\n"
      "it goes, and named; \"status\" and \"reached\" of --json say how both logs end.\n"
      "Example:\n"
      "  kinex diff exact.log double.log");
  verb->callback([options, verb, &exit_code] { diff(*options, voice_of(*verb), exit_code); });
}

}  // namespace kinex::verbs
