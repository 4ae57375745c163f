// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/record.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <sstream>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/formats/utf8.h"
#include "experiments/sweep/cell_run.h"

namespace kinex::sweep {

namespace {

constexpr std::size_t kLongestMessage = 500;
constexpr int kNoMemory = 3;  // the program's exit code where GMP finds no memory

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text = text.substr(text.rfind('\n') + 1);
  if (text.size() > kLongestMessage) text.resize(kLongestMessage);
  return formats::is_utf8(text) ? text : show_text(text);
}

bool is_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

Outcome outcome_by_signal(const lab::ChildEnd& end, const Limits& limits) {
  // The kernel's clock for limits may be some milliseconds ahead of the one that it reports.
  if (limits.seconds > 0 && end.signal == SIGXCPU) return Outcome::kLimit;
  // SIGKILL comes from the hard limit, a second later, and from outside.
  const bool is_over = limits.seconds > 0 && end.cpu_s >= limits.seconds;
  if (is_over && end.signal == SIGKILL) return Outcome::kLimit;
  return is_from_outside(end.signal) ? Outcome::kKilled : Outcome::kCrash;
}

void take_report(Record& record, const CellReport& report) {
  record.outcome = report.outcome;
  record.message = report.message;
  record.exact = report.exact;
  record.times = report.times;
  record.simulate_s = report.simulate_s;
  record.peak_kb = report.peak_kb;
}

}  // namespace

Record record_of(const PlanCell& cell, const Limits& limits, const lab::ChildProcess& child,
                 const lab::ChildEnd& end) {
  Record record;
  record.key = cell.key;
  record.cell = cell.text;
  record.limits = limits;
  record.signal = end.signal;
  record.code = end.code;
  record.cpu_s = end.cpu_s;
  record.wall_s = end.wall_s;
  record.peak_kb = end.peak_kb;
  record.ended = utc_text("%Y-%m-%dT%H:%M:%SZ");
  if (end.signal != 0) {
    record.outcome = outcome_by_signal(end, limits);
    record.message = last_line(child.err());
  } else if (end.code != 0 || child.out().empty()) {
    record.outcome = end.code == kNoMemory ? Outcome::kMemory : Outcome::kCrash;
    record.message = last_line(child.err());
  } else {
    take_report(record, parse_report(child.out(), "the report of a cell"));
  }
  return record;
}

Record record_of(const PlanCell& cell, const CellReport& report, double wall_s) {
  Record record;
  record.key = cell.key;
  record.cell = cell.text;
  record.wall_s = wall_s;
  record.ended = utc_text("%Y-%m-%dT%H:%M:%SZ");
  take_report(record, report);
  return record;
}

std::string record_line(const Record& record) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("key").string(record.key).key("cell").raw(record.cell);
  json.key("status").string(outcome_name(record.outcome));
  json.key("signal").number(record.signal).key("code").number(record.code);
  json.key("message").string(record.message);
  json.key("seconds").number(record.limits.seconds);
  json.key("megabytes").number(record.limits.megabytes);
  json.key("simulate_s").real(record.simulate_s).key("cpu_s").real(record.cpu_s);
  json.key("wall_s").real(record.wall_s);
  json.key("peak_kb").number(static_cast<std::uint64_t>(record.peak_kb));
  json.key("ended").string(record.ended);
  json.key("times").string(record.times).key("exact");
  if (record.exact.empty()) {
    json.null();
  } else {
    json.raw(record.exact);
  }
  json.end_object();
  return text;
}

namespace {

using Kind = formats::JsonValue::Kind;

// Missing members are none.
bool is_of(const formats::JsonValue* value, Kind kind) {
  return value == nullptr || value->kind() == kind;
}

bool is_table(const formats::JsonValue* value) {
  if (value == nullptr) return true;
  return value->kind() == Kind::kObject &&
         std::ranges::all_of(value->items(), [](const formats::JsonValue& one) {
           return one.kind() == Kind::kNumber || one.kind() == Kind::kString;
         });
}

bool are_counts(const formats::JsonValue& of) {
  const formats::JsonValue* const bounds = of.find("bounds");
  if (!is_table(of.find("counters")) || !is_table(of.find("extremes"))) return false;
  if (!is_of(bounds, Kind::kArray)) return false;
  return bounds == nullptr ||
         std::ranges::all_of(bounds->items(), [](const formats::JsonValue& bound) {
           const formats::JsonValue* const holds = bound.find("holds");
           return holds != nullptr && holds->kind() == Kind::kBoolean;
         });
}

// Numbers between spaces (lab/field_archive.h). In binary are seconds, and ratios of them: what is damaged there may be
// beyond all that a plot can have an axis for.
bool are_times(const std::string& text) {
  constexpr double kMost = 1e15, kLeast = 1e-15;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word.find("0x") == word.npos) continue;
    char* end = nullptr;
    const double value = std::abs(std::strtod(word.c_str(), &end));
    if (*end != '\0' || (value != 0 && !(value >= kLeast && value <= kMost))) return false;
  }
  return true;
}

// As far as tables are made of it.
bool is_result(const formats::JsonValue& exact) {
  if (exact.kind() != Kind::kObject || exact.items().empty()) return false;
  const formats::JsonValue* const run = exact.find("run");
  const formats::JsonValue* const structures = exact.find("structures");
  return is_of(run, Kind::kObject) && (run == nullptr || are_counts(*run)) &&
         is_of(structures, Kind::kObject) && is_of(exact.find("violations"), Kind::kArray) &&
         (structures == nullptr || std::ranges::all_of(structures->items(), [](const auto& of) {
            return of.kind() == Kind::kObject && are_counts(of);
          }));
}

}  // namespace

Record parse_record(std::string_view line, const std::string& file, std::size_t number) {
  const formats::JsonDocument document = formats::parse_json(line, file, number);
  const formats::JsonValue& value = *document;
  const LineFields fields(value, file, number);
  Record record;
  record.key = fields.text("key");
  record.cell = formats::canonical_json(fields.member("cell"));
  if (record.key != formats::sha256_hex(record.cell)) {
    fields.fail("its key " + show_text(record.key) + " is not that of its cell");
  }
  const auto outcome = outcome_of(fields.text("status"));
  if (!outcome) fields.fail(show_text(fields.text("status")) + " is not a status");
  record.outcome = *outcome;
  record.signal = static_cast<int>(fields.whole("signal"));
  record.code = static_cast<int>(fields.whole("code"));
  record.message = fields.text("message");
  record.limits.seconds = static_cast<int>(fields.whole("seconds"));
  record.limits.megabytes = static_cast<int>(fields.whole("megabytes"));
  record.simulate_s = fields.real("simulate_s");
  record.cpu_s = fields.real("cpu_s");
  record.wall_s = fields.real("wall_s");
  record.peak_kb = static_cast<long>(fields.whole("peak_kb"));
  record.ended = fields.text("ended");
  record.times = fields.text("times");
  if (!are_times(record.times)) fields.fail("its times are none that a cell takes");
  const formats::JsonValue& exact = fields.member("exact");
  const bool is_there = exact.kind() != Kind::kNull;
  if (is_there ? !is_result(exact) : record.outcome == Outcome::kDone) {
    fields.fail("its exact fields are not the result of a cell");
  }
  if (is_there) record.exact = formats::canonical_json(exact);
  return record;
}

bool agree(const Record& a, const Record& b) {
  if (!is_verdict(a.outcome) || !is_verdict(b.outcome)) return true;
  return a.outcome == b.outcome && a.message == b.message && a.exact == b.exact;
}

void LineFields::fail(const std::string& problem) const {
  throw formats::InputError(file_, "line " + std::to_string(line_), problem,
                   "remove the line: its cell is run again");
}

const formats::JsonValue& LineFields::member(const char* name) const {
  const formats::JsonValue* found = value_.find(name);
  if (found == nullptr) fail(std::string("there is no \"") + name + "\"");
  return *found;
}

const formats::JsonValue& LineFields::member(const char* name, formats::JsonValue::Kind kind) const {
  const formats::JsonValue& found = member(name);
  if (found.kind() == kind) return found;
  fail(std::string("\"") + name + "\": " + formats::shown(found) + " is not " +
       std::string(formats::kind_name(kind)));
}

std::string LineFields::text(const char* name) const {
  return std::string(member(name, formats::JsonValue::Kind::kString).text());
}

long long LineFields::whole(const char* name) const {
  const std::string_view text = member(name, formats::JsonValue::Kind::kNumber).text();
  long long number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) {
    fail(std::string("\"") + name + "\": " + show_text(text) + " is not a whole number");
  }
  return number;
}

double LineFields::real(const char* name) const {
  return std::strtod(std::string(member(name, formats::JsonValue::Kind::kNumber).text()).c_str(), nullptr);
}

bool LineFields::boolean(const char* name) const {
  return member(name, formats::JsonValue::Kind::kBoolean).boolean();
}

std::string utc_text(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts;
  gmtime_r(&now, &parts);
  char text[64];
  return std::string(text, std::strftime(text, sizeof text, format, &parts));
}

}  // namespace kinex::sweep
