// SPDX-License-Identifier: GPL-3.0-or-later
// kinex diff: the first difference of two runs, the amount of disagreement, and which records differ.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
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
#include "experiments/formats/plain_text.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/verbs.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

namespace {

struct DiffOptions {
  std::string a, b;
  bool json = false, all = false, attributes = false;
};

// Differences that are listed unless all are asked for.
constexpr std::size_t kListed = 10;

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

// "missing", "out of order, at another instant"
std::vector<std::string> words_of(const formats::RecordDifference& one) {
  if (one.missing() || one.invented()) {
    return {one.is_change ? "in one log only" : one.missing() ? "missing" : "invented"};
  }
  std::vector<std::string> words;
  if (one.out_of_order) words.emplace_back("out of order");
  if (one.other_effect) words.emplace_back("another effect");
  if (one.other_instant) words.emplace_back("another instant");
  return words;
}

std::string listed(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : ", ") + formats::plain(label);
  return text;
}

// The differences that are shown, one line each: "  missing  a.log:13:  12  0.333  1/3  sorted_list  swap  ..".
std::string list_of(const formats::LogDifference& difference, const DiffOptions& options) {
  struct Line {
    std::string what, place, text;
  };
  std::vector<Line> lines;
  for (const formats::RecordDifference& one : difference.differences) {
    std::string what = listed(words_of(one));
    const auto add = [&](const std::string& file, std::size_t line, const std::string& text) {
      if (line == 0) return;
      lines.push_back({what, file + ":" + std::to_string(line) + ":", text});
      what.clear();
    };
    add(options.a, one.line_a, one.row_a);
    add(options.b, one.line_b, one.row_b);
  }
  std::size_t whats = 0, places = 0;
  for (const Line& line : lines) {
    whats = std::max(whats, line.what.size());
    places = std::max(places, line.place.size());
  }
  std::string text;
  for (Line& line : lines) {
    line.what.resize(whats, ' ');
    line.place.resize(places, ' ');
    text += "  " + line.what + "  " + line.place + "  " + line.text + "\n";
  }
  const std::uint64_t more = difference.different - difference.differences.size();
  if (more != 0) text += "  and " + std::to_string(more) + " more; --all lists them\n";
  return text;
}

// "5 records of a.log are after the end of b.log"; empty for none.
std::string after_text(std::uint64_t number, const std::string& file, const std::string& other) {
  if (number == 0) return "";
  return formats::counted(number, "record", "records") + " of " + file +
         (number == 1 ? " is" : " are") + " after the end of " + other + "\n";
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
    text += formats::plain(one.label_a) + " of " + options.a + " is compared with " + formats::plain(one.label_b) + " of " +
            options.b + "\n";
  }
  const formats::LogEnding &a = difference.ending_a, &b = difference.ending_b;
  for (const auto& [file, ending] : {std::pair(options.a, a), {options.b, b}}) {
    if (!ending.whole()) text += file + " " + formats::ending_text(ending) + "\n";
    for (const std::string& one : formats::corruption_texts(ending.corrupt)) {
      text += file + ": " + one + "\n";
    }
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
    text +=
        formats::counted(difference.other_records,
                         "record that is not compared (a rebuild, or a change of the scene) is",
                         "records that are not compared (rebuilds, or changes of the scene) are") +
        " in one log only\n";
  }
  text += after_text(difference.after_b, options.a, options.b) +
          after_text(difference.after_a, options.b, options.a);
  return text + list_of(difference, options);
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

void write_differences(formats::JsonWriter& json, const formats::LogDifference& difference) {
  json.key("differences").begin_array();
  for (const formats::RecordDifference& one : difference.differences) {
    json.begin_object().key("what");
    write_labels(json, words_of(one));
    json.key("lines").begin_array();
    for (const std::size_t line : {one.line_a, one.line_b}) {
      line == 0 ? json.null() : json.number(static_cast<std::uint64_t>(line));
    }
    json.end_array().end_object();
  }
  json.end_array();
}

std::string json_text(const formats::LogDifference& difference, const DiffOptions& options) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("equal").boolean(difference.equal());
  json.key("compared").string(options.attributes ? "attributes" : "events");
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
  json.end_array().key("corrupt").begin_array();
  for (const formats::LogEnding* ending : {&a, &b}) {
    json.begin_object();
    for (const formats::LogCorruption& one : ending->corrupt) json.key(one.label).string(one.text);
    json.end_object();
  }
  json.end_array();
  json.key("events").begin_array().number(difference.events_a).number(difference.events_b);
  json.end_array().key("first").number(difference.first);
  json.key("missing").number(difference.missing).key("invented").number(difference.invented);
  json.key("out_of_order").number(difference.out_of_order);
  json.key("other_effects").number(difference.other_effects);
  json.key("other_instants").number(difference.other_instants);
  json.key("other_records").number(difference.other_records);
  json.key("after_end").begin_array().number(difference.after_b).number(difference.after_a);
  json.end_array().key("instants_compared").string(compared_name(difference.instants));
  if (options.all) write_differences(json, difference);
  json.end_object();
  return text + "\n";
}

void diff(const DiffOptions& options, const Voice& voice, int& exit_code) {
  check_standard_input({{"LOG", options.a}, {"OTHER", options.b}});
  const std::string a = formats::read_text_file(options.a);
  const std::string b = formats::read_text_file(options.b);
  const std::size_t most = options.all ? std::numeric_limits<std::size_t>::max() : kListed;
  const formats::LogDifference difference = formats::diff_logs(
      a, options.a, b, options.b, most,
      options.attributes ? formats::Compared::kAttributes : formats::Compared::kEvents);
  for (const formats::KindDifference& one : difference.kinds) {
    voice.detail(formats::plain(one.structure) + " " + one.kind + ": " + std::to_string(one.events_a) + " and " +
                 formats::counted(one.events_b, "record", "records") + ", " +
                 std::to_string(one.missing) + " missing, " + std::to_string(one.invented) +
                 " invented");
  }
  if (options.json) {
    print(json_text(difference, options));
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
  verb->add_flag("--attributes", options->attributes,
                 "Compare the changes of the attributes, whatever the structures for them");
  verb->add_flag("--json", options->json, "Print one JSON object");
  verb->add_flag("--all", options->all,
                 "List all records that differ, not the first 10; with --json their lines");
  add_voice(*verb, "Print nothing: the exit code tells whether they differ",
            "Count the differences of every kind of record, on standard error");
  verb->footer(
      "Exit code 0: equal, 1: different. Compared and counted are the log records of\n"
      "events, external and internal, of the structures that both logs have, whatever\n"
      "their labels; not those of changes of the scene (motion, insert, erase) and of\n"
      "rebuilds that change nothing. Events of the same kind and objects are the same\n"
      "if they are at the same instant; else if they are next to each other in time.\n"
      "Instants are compared between two exact logs only, as numbers.\n"
      "A log that was cut off, or stopped at a limit, is compared as far as it goes,\n"
      "and named. If one log ends earlier, the later records of the other are counted\n"
      "separately: they are neither missing nor invented, but the logs differ.\n"
      "A structure that became corrupt is named: it has no records from then on, and\n"
      "those of the other log count as missing or invented.\n"
      "\"status\", \"reached\", \"corrupt\" and \"after_end\" of --json say how both logs end.\n"
      "With --attributes external events alone are compared, by what they change, those\n"
      "at one instant in no order: structures for one attribute (kinex list structures\n"
      "has their groups) agree, whatever their certificates.\n"
      "Example:\n"
      "  kinex diff exact.log double.log\n"
      "Two structures on one scene:\n"
      "  kinex run scene.json --maintain ONE --events one.jsonl\n"
      "  kinex run scene.json --maintain OTHER --events other.jsonl\n"
      "  kinex diff --attributes one.jsonl other.jsonl");
  verb->callback([options, verb, &exit_code] { diff(*options, voice_of(*verb), exit_code); });
}

}  // namespace kinex::verbs
