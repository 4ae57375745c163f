// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_filter.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/log_rules.h"
#include "experiments/formats/plain_text.h"

namespace kinex::formats {

namespace {

constexpr const char* kOption = "--filter";
constexpr std::array<std::string_view, 5> kKeys{"kind", "structure", "object", "predicate",
                                                "external"};

std::vector<std::string> keys() { return {kKeys.begin(), kKeys.end()}; }

// True if a condition begins here.
bool begins_condition(std::string_view text) {
  return std::any_of(kKeys.begin(), kKeys.end(), [&](std::string_view key) {
    return text.substr(0, key.size()) == key && text.substr(key.size(), 1) == "=";
  });
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != ',' || !begins_condition(text.substr(i + 1))) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool has(const std::vector<std::string>& values, std::string_view value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

bool shares(const std::vector<std::string>& values, const std::vector<std::string>& ids) {
  return std::any_of(ids.begin(), ids.end(),
                     [&](const std::string& id) { return has(values, id); });
}

bool is_about(const std::vector<std::string>& objects, const LogRecord& record) {
  if (shares(objects, record.ids)) return true;
  if (record.certificate && shares(objects, record.certificate->ids)) return true;
  return record.change &&
         (shares(objects, record.change->gone) || shares(objects, record.change->came));
}

std::vector<std::string> kinds_of(const LogHeader& header) {
  std::vector<std::string> kinds;
  for (const LogStructure& structure : header.structures) {
    for (const std::string& kind : structure.kinds) {
      if (!has(kinds, kind)) kinds.push_back(kind);
    }
  }
  return kinds;
}

std::vector<std::string> labels_of(const LogHeader& header) {
  std::vector<std::string> labels;
  for (const LogStructure& structure : header.structures) labels.push_back(structure.label);
  return labels;
}

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  return text + (names.size() > kMost ? ", .." : "");
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// The longest known value with which the text begins, up to a comma or its end; empty if there is none.
std::string known_beginning(const std::string& text, const std::vector<std::string>& known) {
  for (std::size_t end = text.size(); end != std::string::npos && end > 0;
       end = text.rfind(',', end - 1)) {
    if (has(known, text.substr(0, end))) return text.substr(0, end);
  }
  return "";
}

// `known`: what may have been meant; `there`: what the log has.
[[noreturn]] void refuse_value(const char* key, const std::string& word, const std::string& file,
                               const std::vector<std::string>& known,
                               const std::vector<std::string>& there) {
  throw InputError(
      kOption, "", std::string("there is no ") + key + " " + show_text(word) + " in " + file,
      plain(did_you_mean(word, known, "it has " + (there.empty() ? "none" : joined(there)))));
}

// The known values that these are, or are lists of.
std::vector<std::string> fitted(const char* key, const std::vector<std::string>& values,
                                const std::vector<std::string>& known, const std::string& file) {
  std::vector<std::string> result;
  for (const std::string& value : values) {
    for (std::size_t begin = 0; begin <= value.size();) {
      const std::string rest = value.substr(begin), found = known_beginning(rest, known);
      if (found.empty()) {
        const std::string word = rest.substr(0, rest.find(','));
        refuse_value(key, word, file, known, known);
      }
      begin += found.size() + 1;
      result.push_back(found);
    }
  }
  return result;
}

// Of its certificates, in the order of their names.
std::vector<std::string> predicates_in(LogReader reader) {
  std::set<std::string> found;
  for (LogRecord record; reader.next(record);) {
    if (record.certificate) found.insert(record.certificate->predicate);
  }
  return {found.begin(), found.end()};
}

// The log of a program with structures of its own may have predicates that kinex does not know.
void refuse_unknown_predicates(const std::vector<std::string>& predicates,
                               const LogReader& reader) {
  const auto unknown = [](const std::string& name) { return !arity_of(name); };
  if (std::none_of(predicates.begin(), predicates.end(), unknown)) return;
  const std::vector<std::string> own = predicates_in(reader);
  for (const std::string& name : predicates) {
    if (!unknown(name) || has(own, name)) continue;
    std::vector<std::string> known = own;
    for (const std::string& one : predicate_names()) {
      if (!has(known, one)) known.push_back(one);
    }
    refuse_value("predicate", name, reader.file(), known, own);
  }
}

}  // namespace

void LogFilter::add(std::string_view text) {
  for (const std::string_view part : split(text)) {
    const std::size_t equals = part.find('=');
    const std::string key(part.substr(0, equals));
    if (equals == std::string_view::npos) {
      throw InputError(
          kOption, "", show_text(part) + " is no condition",
          "write KEY=VALUE, as kind=flip; keys are kind, structure, object, predicate, external");
    }
    if (!has(keys(), key)) {
      throw InputError(
          kOption, "", show_text(key) + " is not a key",
          did_you_mean(key, keys(), "write kind, structure, object, predicate or external"));
    }
    const std::string value(part.substr(equals + 1));
    // No predicate has a comma in its name.
    const bool list = key == "external" || key == "predicate";
    const std::vector<std::string> values =
        list ? split_at_commas(value) : std::vector<std::string>{value};
    for (const std::string& one : values) {
      if (key != "external" || one == "true" || one == "false") continue;
      throw InputError(kOption, "", show_text(one) + " is neither true nor false",
                       "write external=true or external=false");
    }
    std::vector<std::string>* known = values_of(key);
    if (known == nullptr) known = &conditions_.emplace_back(Condition{key, {}}).values;
    known->insert(known->end(), values.begin(), values.end());
  }
}

std::vector<std::string>* LogFilter::values_of(std::string_view key) {
  for (Condition& condition : conditions_) {
    if (condition.key == key) return &condition.values;
  }
  return nullptr;
}

void LogFilter::fit(const LogReader& reader) {
  const LogHeader& header = reader.header();
  const std::string& file = reader.file();
  if (auto* kinds = values_of("kind")) *kinds = fitted("kind", *kinds, kinds_of(header), file);
  if (auto* labels = values_of("structure")) {
    *labels = fitted("structure", *labels, labels_of(header), file);
  }
  if (auto* objects = values_of("object")) {
    *objects = fitted("object", *objects, header.objects, file);
  }
  if (const auto* predicates = values_of("predicate"))
    refuse_unknown_predicates(*predicates, reader);
}

bool LogFilter::wants(const LogRecord& record) const {
  for (const Condition& condition : conditions_) {
    const std::vector<std::string>& values = condition.values;
    const bool wanted = condition.key == "kind"        ? has(values, record.kind)
                        : condition.key == "structure" ? has(values, record.structure)
                        : condition.key == "object"    ? is_about(values, record)
                        : condition.key == "external"
                            ? has(values, record.external ? "true" : "false")
                            : record.certificate && has(values, record.certificate->predicate);
    if (!wanted) return false;
  }
  return true;
}

}  // namespace kinex::formats
