// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/log_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "experiments/event_log.h"
#include "experiments/input_error.h"
#include "experiments/json_node.h"

namespace kinex {

namespace {

std::vector<std::string> read_strings(const JsonNode& node) {
  node.require_array();
  std::vector<std::string> result;
  for (std::size_t i = 0; i < node.size(); ++i) result.push_back(node.at(i).string());
  return result;
}

std::uint64_t read_count(const JsonNode& node) {
  const bool number = node.is(JsonValue::Kind::kNumber);
  const std::optional<Integer> count = number ? Integer::parse(node.value().text) : std::nullopt;
  if (!count || count->sign() < 0 || !count->fits_int64()) {
    node.refuse("a count", "write an integer from 0 on");
  }
  return static_cast<std::uint64_t>(count->to_int64());
}

LogStructure read_structure(const JsonNode& node) {
  node.require_object({"label", "structure", "kinds"});
  return {node.member("label").string(), node.member("structure").string(),
          read_strings(node.member("kinds"))};
}

Polynomial read_polynomial(const JsonNode& node) {
  node.require_array();
  std::vector<Integer> coefficients;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const JsonNode entry = node.at(k);
    std::optional<Integer> value = Integer::parse(entry.string());
    if (!value) entry.refuse("an integer in quotes", "write \"-2\"");
    coefficients.push_back(*std::move(value));
  }
  if (coefficients.size() < 2 || coefficients.back().is_zero()) {
    node.fail("a polynomial without a root",
              "list the coefficients, low degree first, the last one not zero");
  }
  return Polynomial(std::move(coefficients));
}

LogInstant read_instant(const JsonNode& node, bool exact) {
  LogInstant instant;
  if (!exact) {
    node.require_object({"decimal"});
    instant.decimal = node.member("decimal").string();
    return instant;
  }
  node.require_object({"polynomial", "root", "interval", "decimal"});
  instant.polynomial = read_polynomial(node.member("polynomial"));
  instant.root = node.member("root").integer(1, std::numeric_limits<int>::max());
  const JsonNode interval = node.member("interval");
  interval.require_array();
  if (interval.size() != 2) interval.fail("an interval needs two ends", "write [\"a\", \"b\"]");
  instant.lower = interval.at(0).rational();
  instant.upper = interval.at(1).rational();
  instant.decimal = node.member("decimal").string();
  return instant;
}

void read_event(const JsonNode& node, bool exact, LogEvent& event) {
  node.require_object(
      {"seq", "structure", "kind", "ids", "certificate", "external", "reason", "time"});
  event.sequence = read_count(node.member("seq"));
  event.structure = node.member("structure").string();
  event.kind = node.member("kind").string();
  event.ids = read_strings(node.member("ids"));
  const JsonNode certificate = node.member("certificate");
  event.predicate.clear();
  if (!certificate.is(JsonValue::Kind::kNull)) {
    certificate.require_object({"predicate", "ids"});
    event.predicate = certificate.member("predicate").string();
    read_strings(certificate.member("ids"));
  }
  event.external = node.member("external").boolean();
  if (const std::optional<JsonNode> reason = node.find("reason")) reason->string();
  event.time = read_instant(node.member("time"), exact);
}

}  // namespace

bool looks_like_log(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n')).substr(0, 64);
  return first.find("\"format\"") != std::string_view::npos;
}

LogReader::LogReader(std::string_view text, std::string file)
    : rest_(text), file_(std::move(file)) {
  std::string_view line;
  if (!next_line(line)) throw InputError(file_, "", "the file is empty", "give an event log");
  if (!looks_like_log(line)) {
    throw InputError(file_, "line 1", show_text(line) + " does not begin an event log",
                     "make one with kinex run SCENE --events FILE");
  }
  read_header(line);
}

bool LogReader::next_line(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t newline = rest_.find('\n');
  line = rest_.substr(0, newline);
  rest_.remove_prefix(newline == std::string_view::npos ? rest_.size() : newline + 1);
  ++line_;
  return true;
}

void LogReader::read_header(std::string_view line) {
  const JsonValue tree = parse_json(line, file_, line_);
  const JsonSource source{file_, line, line_};
  const JsonNode node(tree, source);
  node.require_object(
      {"format", "version", "scene", "scene_hash", "arithmetic", "exact", "build", "structures"});
  const JsonNode format = node.member("format");
  if (format.string() != kLogFormat) format.refuse("an event log", "write \"kinex-log\"");
  const JsonNode version = node.member("version");
  if (!version.is(JsonValue::Kind::kNumber) || version.value().text != "1") {
    version.refuse("a version of the log that this program reads", "write 1");
  }
  header_.scene = node.member("scene").string();
  header_.scene_hash = node.member("scene_hash").string();
  header_.arithmetic = node.member("arithmetic").string();
  header_.exact = node.member("exact").boolean();
  header_.build = node.member("build").string();
  const JsonNode structures = node.member("structures");
  structures.require_array();
  for (std::size_t i = 0; i < structures.size(); ++i) {
    header_.structures.push_back(read_structure(structures.at(i)));
  }
}

bool LogReader::next(LogEvent& event) {
  std::string_view line;
  if (!next_line(line)) return false;
  if (end_) {
    throw InputError(file_, "line " + std::to_string(line_), "text after the last line of the log",
                     "remove it");
  }
  const JsonValue tree = parse_json(line, file_, line_);
  const JsonSource source{file_, line, line_};
  const JsonNode node(tree, source);
  if (node.find("end")) {
    node.require_object({"end", "events", "digest"});
    end_ = LogEnd{node.member("end").string(), read_count(node.member("events")),
                  node.member("digest").string()};
    return next(event);
  }
  event.line = line_;
  event.text = line;
  read_event(node, header_.exact, event);
  return true;
}

}  // namespace kinex
