// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "experiments/formats/canonical_json.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

namespace {

// An object with these members at most, in this order.
void require_members(const JsonNode& node, std::initializer_list<std::string_view> order) {
  node.require_object(order);
  const std::string_view* last = order.begin();
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string_view* place = std::find(order.begin(), order.end(), node.value().key(i));
    if (place < last) {
      node.at(i).fail("\"" + std::string(*place) + "\" comes too late", "keep the members' order");
    }
    last = place;
  }
}

std::vector<std::string> read_strings(const JsonNode& node) {
  node.require_array();
  std::vector<std::string> result;
  for (std::size_t i = 0; i < node.size(); ++i) result.emplace_back(node.at(i).string());
  return result;
}

std::uint64_t read_count(const JsonNode& node) {
  const bool number = node.is(JsonValue::Kind::kNumber);
  const std::optional<Integer> count = number ? Integer::parse(node.value().text()) : std::nullopt;
  if (!count || count->sign() < 0 || !count->fits_int64()) {
    node.refuse("a count", "write an integer from 0 on");
  }
  return static_cast<std::uint64_t>(count->to_int64());
}

// In lowest terms, in quotes: one text for each number.
Rational read_exact(const JsonNode& node) {
  const std::string_view text = node.string();
  const std::optional<Rational> value = Rational::parse(text);
  if (!value || value->to_string() != text) {
    node.refuse("a fraction in lowest terms", "write \"-1/2\" or \"3\"");
  }
  return *value;
}

std::string read_digest(const JsonNode& node) {
  const std::string_view text = node.string();
  if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string::npos) {
    node.refuse("a SHA-256 digest", "write 64 hexadecimal digits in lower case");
  }
  return std::string(text);
}

std::vector<LogCorruption> read_corrupt(const JsonNode& node) {
  if (!node.is(JsonValue::Kind::kObject) || node.size() == 0) {
    node.refuse("the corrupt structures", "write {LABEL: TEXT, ..}, or leave it out");
  }
  std::vector<LogCorruption> result;
  for (std::size_t i = 0; i < node.size(); ++i) {
    if (node.at(i).string().empty()) node.at(i).refuse("a text", "write what was found");
    result.push_back({std::string(node.value().key(i)), std::string(node.at(i).string())});
  }
  return result;
}

std::string read_name(const JsonNode& node) {
  if (node.string().empty()) node.refuse("a name", "write at least one character");
  return std::string(node.string());
}

// The key as key_json() writes it, if it is one.
std::string read_key(const JsonNode& node) {
  const std::string remedy = "write a key as in the \"maintain\" of a scene";
  std::string text;
  JsonWriter json(text);
  if (node.is(JsonValue::Kind::kString)) {
    if (node.string() != "x" && node.string() != "y" && node.string() != "z") {
      node.refuse("an axis", remedy);
    }
    json.string(node.string());
    return text;
  }
  node.require_object({"direction", "squared_distance_to"});
  if (node.size() != 1)
    node.fail("a key with " + counted(node.size(), "member", "members"), remedy);
  json.begin_object();
  if (const auto direction = node.find("direction")) {
    direction->require_array();
    json.key("direction").begin_array();
    for (std::size_t i = 0; i < direction->size(); ++i) {
      const JsonNode entry = direction->at(i);
      static_cast<void>(entry.rational());
      if (entry.is(JsonValue::Kind::kNumber)) {
        json.raw(entry.value().text());
      } else {
        json.string(entry.string());
      }
    }
    json.end_array();
  } else {
    json.key("squared_distance_to").string(read_name(node.member("squared_distance_to")));
  }
  json.end_object();
  return text;
}

LogStructure read_structure(const JsonNode& node) {
  require_members(node, {"label", "structure", "key", "options", "kinds"});
  LogStructure structure;
  structure.label = read_name(node.member("label"));
  structure.structure = read_name(node.member("structure"));
  if (const auto key = node.find("key")) structure.key = read_key(*key);
  if (const auto options = node.find("options")) {
    if (!options->is(JsonValue::Kind::kObject) || options->size() == 0) {
      options->refuse("options of a structure",
                      "write what it reads and its parameters, {\"over\": .., ..}");
    }
    structure.options = canonical_json(options->value());
  }
  structure.kinds = read_strings(node.member("kinds"));
  return structure;
}

InstantDetail read_detail(const JsonNode& node) {
  for (const InstantDetail detail :
       {InstantDetail::kName, InstantDetail::kInterval, InstantDetail::kNone}) {
    if (node.string() == detail_name(detail)) return detail;
  }
  node.refuse("a detail of instants", "write \"names\", \"intervals\" or \"none\"");
}

Polynomial read_polynomial(const JsonNode& node) {
  node.require_array();
  std::vector<Integer> coefficients;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const JsonNode entry = node.at(k);
    std::optional<Integer> value = Integer::parse(entry.string());
    if (!value || value->to_string() != entry.string()) {
      entry.refuse("an integer in quotes", "write \"-2\"");
    }
    coefficients.push_back(*std::move(value));
  }
  if (coefficients.size() < 2 || coefficients.back().is_zero()) {
    node.fail("a polynomial without a root",
              "list the coefficients, low degree first, the last one not zero");
  }
  return Polynomial(std::move(coefficients));
}

LogInstant read_instant(const JsonNode& node, const LogHeader& header) {
  LogInstant instant;
  if (header.has_names()) {
    require_members(node, {"polynomial", "root", "interval", "decimal"});
    instant.polynomial = read_polynomial(node.member("polynomial"));
    instant.root = node.member("root").integer(1, std::numeric_limits<int>::max());
  } else if (header.has_intervals()) {
    require_members(node, {"interval", "decimal"});
  } else {
    require_members(node, {"decimal"});
  }
  if (header.has_intervals()) {
    const JsonNode interval = node.member("interval");
    interval.require_array();
    if (interval.size() != 2) interval.fail("an interval needs two ends", "write [\"a\", \"b\"]");
    instant.lower = read_exact(interval.at(0));
    instant.upper = read_exact(interval.at(1));
  }
  instant.decimal = node.member("decimal").string();
  return instant;
}

// "gone" or "came": ids (width 0), or tuples of `width` ids; nullopt: not known yet.
std::vector<std::string> read_side(const JsonNode& node, std::optional<std::size_t>& width) {
  node.require_array();
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode entry = node.at(i);
    const bool is_tuple = entry.is(JsonValue::Kind::kArray);
    if (width && is_tuple != (*width != 0)) {
      entry.fail("ids and tuples of ids in one record", "write one kind of them");
    }
    if (!is_tuple) {
      width = 0;
      ids.emplace_back(entry.string());
      continue;
    }
    const std::vector<std::string> all = read_strings(entry);
    if (all.empty()) entry.fail("a tuple without ids", "write [\"a\", \"b\"]");
    if (width && *width != all.size()) {
      entry.fail("tuples of " + std::to_string(*width) + " and of " + std::to_string(all.size()) +
                     " ids in one record",
                 "write tuples of one length");
    }
    width = all.size();
    ids.insert(ids.end(), all.begin(), all.end());
  }
  return ids;
}

LogChange read_change(const JsonNode& gone, const JsonNode& came) {
  LogChange change;
  std::optional<std::size_t> width;
  change.gone = read_side(gone, width);
  change.came = read_side(came, width);
  change.width = width.value_or(0);
  return change;
}

void read_record(const JsonNode& node, const LogHeader& header, LogRecord& record) {
  require_members(node, {"seq", "structure", "kind", "ids", "certificate", "external", "reason",
                         "gone", "came", "time"});
  record.sequence = read_count(node.member("seq"));
  record.structure = node.member("structure").string();
  record.kind = node.member("kind").string();
  record.ids = read_strings(node.member("ids"));
  record.certificate.reset();
  record.reason.reset();
  record.change.reset();
  const JsonNode certificate = node.member("certificate");
  if (!certificate.is(JsonValue::Kind::kNull)) {
    require_members(certificate, {"predicate", "ids"});
    record.certificate = {std::string(certificate.member("predicate").string()),
                          read_strings(certificate.member("ids"))};
  }
  record.external = node.member("external").boolean();
  if (const auto reason = node.find("reason")) record.reason = reason->string();
  if (node.find("gone") || node.find("came")) {
    record.change = read_change(node.member("gone"), node.member("came"));
  }
  if (header.has_times()) {
    record.time = read_instant(node.member("time"), header);
  } else if (const auto time = node.find("time")) {
    time->fail("a time in a log whose header says \"instants\": \"none\"", "remove it");
  }
}

}  // namespace

bool looks_like_log(std::string_view text) {
  for (const std::string_view word : {"{", "\"format\"", ":"}) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
  }
  return true;
}

LogReader::LogReader(std::string_view text, std::string file)
    : text_(text), rest_(text), file_(std::move(file)) {
  std::string_view line;
  if (!next_line(line)) throw InputError(file_, "", "the file is empty", "give an event log");
  if (!looks_like_log(line)) {
    throw InputError(file_, "line 1", show_text(line) + " does not begin an event log",
                     "make one with kinex run SCENE --events FILE");
  }
  read_header(line);
}

std::optional<JsonDocument> LogReader::parse_line(std::string_view line) const {
  try {
    return parse_json(line, file_, line_);
  } catch (const InputError&) {
    // Only a log that was cut off has a line without its end.
    if (!rest_.empty() || text_.ends_with('\n') || !line.starts_with('{')) throw;
    return std::nullopt;
  }
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
  const std::optional<JsonDocument> document = parse_line(line);
  if (!document) {
    throw InputError(file_, "line 1", "the log was cut off within its first line",
                     "run the scene again (kinex run SCENE --events FILE)");
  }
  const JsonValue& tree = **document;
  const JsonSource source{file_, line, line_};
  const JsonNode node(tree, source);
  if (!node.is(JsonValue::Kind::kObject)) node.refuse("the header of an event log", "write {..}");
  const JsonNode format = node.member("format");
  if (format.string() != kLogFormat) format.refuse("an event log", "write \"kinex-log\"");
  const JsonNode version = node.member("version");
  if (version.is(JsonValue::Kind::kNumber) && version.value().text() == "1") {
    version.fail("the log is of version 1, which this program does not read (it reads version 2)",
                 "run the scene again, kinex run SCENE --events FILE");
  }
  if (!version.is(JsonValue::Kind::kNumber) || version.value().text() != "2") {
    version.refuse("a version of the log that this program reads", "write 2");
  }
  require_members(node, {"format", "version", "scene", "scene_hash", "arithmetic", "exact",
                         "instants", "build", "structures", "objects", "provenance"});
  header_.scene = node.member("scene").string();
  header_.scene_hash = read_digest(node.member("scene_hash"));
  header_.arithmetic = node.member("arithmetic").string();
  header_.exact = node.member("exact").boolean();
  header_.instants = read_detail(node.member("instants"));
  header_.build = node.member("build").string();
  const JsonNode structures = node.member("structures");
  structures.require_array();
  for (std::size_t i = 0; i < structures.size(); ++i) {
    header_.structures.push_back(read_structure(structures.at(i)));
  }
  header_.objects = read_strings(node.member("objects"));
  if (const std::optional<JsonNode> made = node.find("provenance")) {
    header_.provenance = read_provenance(*made);
  }
}

bool LogReader::next(LogRecord& record) {
  std::string_view line;
  if (!next_line(line)) return false;
  if (end_) {
    throw InputError(file_, "line " + std::to_string(line_), "text after the last line of the log",
                     "remove it");
  }
  const std::optional<JsonDocument> document = parse_line(line);
  if (!document) {
    cut_line_ = line_;
    return false;
  }
  const JsonValue& tree = **document;
  const JsonSource source{file_, line, line_};
  const JsonNode node(tree, source);
  if (node.find("end")) {
    require_members(node, {"end", "reached", "records", "external", "corrupt", "digest", "seal"});
    end_.emplace();
    end_->status = node.member("end").string();
    const JsonNode reached = node.member("reached");
    if (!reached.is(JsonValue::Kind::kNull)) end_->reached = read_exact(reached);
    end_->records = read_count(node.member("records"));
    end_->external = read_count(node.member("external"));
    if (const auto corrupt = node.find("corrupt")) end_->corrupt = read_corrupt(*corrupt);
    end_->digest = read_digest(node.member("digest"));
    const JsonNode seal = node.member("seal");
    end_->seal = read_digest(seal);
    if (!line.ends_with("\"seal\": \"" + end_->seal + "\"}")) {
      seal.fail("the line does not end with the seal as kinex writes it",
                "write \"seal\": \"HEX\"} at its end");
    }
    const char* const digits = line.data() + line.size() - 66;  // 64, a quotation mark, a brace
    end_->sealed = text_.substr(0, static_cast<std::size_t>(digits - text_.data()));
    return next(record);  // there must be nothing else
  }
  record.line = line_;
  record.text = line;
  read_record(node, header_, record);
  return true;
}

}  // namespace kinex::formats
