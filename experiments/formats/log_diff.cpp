// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_diff.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/log_instant.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/log_scene.h"
#include "experiments/formats/log_table.h"

namespace kinex::formats {

namespace {

struct Entry {
  std::uint32_t name;     // of structure, kind, ids and change
  std::uint32_t kind;     // of structure and kind
  std::uint32_t instant;  // place in Log::instants
  bool external;
  std::size_t line;
};

// The label that a log has for a structure -> the one under which it is compared.
using Labels = std::map<std::string, std::string>;

struct Log {
  LogHeader header;
  std::vector<Entry> events;
  std::vector<std::uint32_t> changes;  // names
  std::vector<LogInstant> instants;    // distinct ones, in the order of the log
};

// Numbers for strings, shared by both logs.
class Names {
 public:
  std::uint32_t number(std::string name) {
    return numbers_.emplace(std::move(name), static_cast<std::uint32_t>(numbers_.size()))
        .first->second;
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

void write_ids(JsonWriter& json, const std::vector<std::string>& ids) {
  json.begin_array();
  for (const std::string& id : ids) json.string(id);
  json.end_array();
}

std::string name_of(const LogRecord& record, const std::string& label) {
  std::string text;
  JsonWriter json(text);
  json.begin_array().string(label).string(record.kind);
  write_ids(json, record.ids);
  if (record.change) {
    write_ids(json, record.change->gone);
    write_ids(json, record.change->came);
  }
  json.end_array();
  return text;
}

// A change of the scene, or a rebuild that left the attribute as it was.
bool is_change(const LogRecord& record) {
  if (record.external) return false;
  return record.kind == "motion" || record.kind == "insert" || record.kind == "erase" ||
         record.kind == "rebuild";
}

// Numbers of (structure, kind), with their tallies.
class Kinds {
 public:
  std::uint32_t number(const std::string& label, const std::string& kind) {
    const auto [place, is_new] =
        numbers_.try_emplace({label, kind}, static_cast<std::uint32_t>(tallies_.size()));
    if (is_new) {
      KindDifference& tally = tallies_.emplace_back();
      tally.structure = label;
      tally.kind = kind;
    }
    return place->second;
  }
  KindDifference& of(const Entry& entry) { return tallies_[entry.kind]; }
  std::vector<KindDifference> sorted() const {
    std::vector<KindDifference> result;
    for (const auto& [name, number] : numbers_) result.push_back(tallies_[number]);
    return result;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::uint32_t> numbers_;
  std::vector<KindDifference> tallies_;
};

Log read_log(LogReader& reader, const Labels& labels, Names& names, Kinds& kinds) {
  Log log;
  log.header = reader.header();
  LogRecord record;
  while (reader.next(record)) {
    const auto label = labels.find(record.structure);
    if (label == labels.end()) continue;
    const std::uint32_t name = names.number(name_of(record, label->second));
    if (is_change(record)) {
      log.changes.push_back(name);
      continue;
    }
    if (log.instants.empty() || !same_text(log.instants.back(), record.time)) {
      log.instants.push_back(record.time);
    }
    log.events.push_back({name, kinds.number(label->second, record.kind),
                          static_cast<std::uint32_t>(log.instants.size() - 1), record.external,
                          record.line});
  }
  return log;
}

// Compares instants of two logs, each pair once.
class Instants {
 public:
  Instants(const Log& a, const Log& b) : a_(a), b_(b) {
    if (a.header.has_names() && b.header.has_names()) {
      compared_ = InstantsCompared::kExactly;
    } else if (a.header.has_intervals() && b.header.has_intervals()) {
      compared_ = InstantsCompared::kIntervals;
    }
  }

  InstantsCompared compared() const { return compared_; }

  bool same(std::uint32_t in_a, std::uint32_t in_b) {
    if (compared_ == InstantsCompared::kNot) return true;
    const auto [place, is_new] = known_.try_emplace({in_a, in_b}, false);
    if (is_new) place->second = look(a_.instants[in_a], b_.instants[in_b]);
    return place->second;
  }

 private:
  bool look(const LogInstant& a, const LogInstant& b) {
    if (same_text(a, b)) return true;
    const bool names_a = a_.header.has_names(), names_b = b_.header.has_names();
    if (names_a && names_b && a.root == b.root && a.polynomial == b.polynomial) return true;
    if (a.upper < b.lower || b.upper < a.lower) return false;
    if (!names_a && !names_b) return true;
    // Only instants without defects can be compared as numbers.
    if ((names_a && !instant_problem(a, a_.header).empty()) ||
        (names_b && !instant_problem(b, b_.header).empty())) {
      return false;
    }
    if (names_a && names_b) {
      RealRoot of_a = root_of(a), of_b = root_of(b);
      return compare(of_a, of_b, counters_) == 0;
    }
    RealRoot root = root_of(names_a ? a : b);
    const LogInstant& interval = names_a ? b : a;
    return compare(root, interval.lower, counters_) >= 0 &&
           compare(root, interval.upper, counters_) <= 0;
  }

  const Log& a_;
  const Log& b_;
  InstantsCompared compared_ = InstantsCompared::kNot;
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> known_;
  RootCounters counters_;
};

// For each event of `a` the position in `b` of its match, or kNone.
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
std::vector<std::size_t> match(const std::vector<Entry>& a, const std::vector<Entry>& b,
                               std::size_t names) {
  std::vector<std::vector<std::size_t>> places(names);
  for (std::size_t i = 0; i < b.size(); ++i) places[b[i].name].push_back(i);
  std::vector<std::size_t> used(names, 0);
  std::vector<std::size_t> result;
  for (const Entry& entry : a) {
    std::size_t& next = used[entry.name];
    result.push_back(next < places[entry.name].size() ? places[entry.name][next++] : kNone);
  }
  return result;
}

// Length of the longest increasing subsequence of the matched positions.
std::size_t longest_in_order(const std::vector<std::size_t>& positions) {
  std::vector<std::size_t>
      tails;  // tails[k]: smallest end of an increasing subsequence of length k + 1
  for (const std::size_t position : positions) {
    if (position == kNone) continue;
    const auto at = std::lower_bound(tails.begin(), tails.end(), position);
    if (at == tails.end()) {
      tails.push_back(position);
    } else {
      *at = position;
    }
  }
  return tails.size();
}

// The number of elements in one list and not in the other, with multiplicity.
std::uint64_t not_in_both(std::vector<std::uint32_t> a, std::vector<std::uint32_t> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::vector<std::uint32_t> apart;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(apart));
  return apart.size();
}

void find_first(const std::vector<Entry>& a, const std::vector<Entry>& b, Instants& instants,
                LogDifference& result) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const bool both = i < a.size() && i < b.size();
    if (both && a[i].name == b[i].name && a[i].external == b[i].external &&
        instants.same(a[i].instant, b[i].instant)) {
      continue;
    }
    result.first = i + 1;
    if (i < a.size()) result.line_a = a[i].line;
    if (i < b.size()) result.line_b = b[i].line;
    return;
  }
}

bool is_same(const LogStructure& a, const LogStructure& b) {
  return a.structure == b.structure && a.key == b.key && a.options == b.options;
}

// The structures that both logs have, by the label in each; the others go into the result.
std::pair<Labels, Labels> common_structures(const LogHeader& a, const LogHeader& b,
                                            LogDifference& result) {
  std::pair<Labels, Labels> common;
  const auto pair_up = [&](bool by_label) {
    for (const LogStructure& one : a.structures) {
      for (const LogStructure& other : b.structures) {
        if (!is_same(one, other) || common.first.contains(one.label) ||
            common.second.contains(other.label) || (by_label && one.label != other.label)) {
          continue;
        }
        common.first.emplace(one.label, one.label);
        common.second.emplace(other.label, one.label);
        if (!by_label) result.other_labels.push_back({one.label, other.label});
      }
    }
  };
  pair_up(true);
  pair_up(false);
  for (const LogStructure& one : a.structures) {
    if (!common.first.contains(one.label)) result.only_a.push_back(one.label);
  }
  for (const LogStructure& one : b.structures) {
    if (!common.second.contains(one.label)) result.only_b.push_back(one.label);
  }
  return common;
}

// "delaunay_2, sorted_list by "x"": with key and parameters where `other` has the same structure.
std::string described(const LogHeader& header, const LogHeader& other) {
  std::string text;
  for (const LogStructure& one : header.structures) {
    text += (text.empty() ? "" : ", ") + one.structure;
    const bool in_both =
        std::any_of(other.structures.begin(), other.structures.end(),
                    [&](const LogStructure& there) { return there.structure == one.structure; });
    if (!in_both) continue;
    if (!one.key.empty()) text += " by " + one.key;
    if (!one.options.empty()) text += " with " + one.options;
  }
  return text;
}

// The records of two lines, as rows of one table; line 0: no record.
void show_rows(std::string_view text_a, std::string_view text_b, LogDifference& result) {
  std::vector<LogRow> rows;
  for (const auto& [text, line] :
       {std::pair(text_a, result.line_a), std::pair(text_b, result.line_b)}) {
    if (line == 0) continue;
    LogReader reader(text, "");
    LogRecord record;
    while (reader.next(record) && record.line != line) {
    }
    rows.push_back(log_row(record, reader.header()));
  }
  const std::vector<std::string> lines = aligned_rows(rows);
  if (result.line_a != 0) result.row_a = lines.front();
  if (result.line_b != 0) result.row_b = lines.back();
}

}  // namespace

LogDifference diff_logs(std::string_view text_a, const std::string& file_a, std::string_view text_b,
                        const std::string& file_b) {
  LogReader reader_a(text_a, file_a);
  LogReader reader_b(text_b, file_b);
  LogDifference result;
  const auto [labels_a, labels_b] =
      common_structures(reader_a.header(), reader_b.header(), result);
  if (labels_a.empty() && !(result.only_a.empty() && result.only_b.empty())) {
    throw InputError(
        file_b, "line 1",
        "it has no structure in common with " + file_a + ": it maintains " +
            described(reader_b.header(), reader_a.header()) + ", the other " +
            described(reader_a.header(), reader_b.header()),
        "compare runs with a structure in common, by the same key and with the same parameters");
  }
  Names names;
  Kinds kinds;
  const Log a = read_log(reader_a, labels_a, names, kinds);
  const Log b = read_log(reader_b, labels_b, names, kinds);
  Instants instants(a, b);

  result.ending_a = ending_of(reader_a);
  result.ending_b = ending_of(reader_b);
  result.events_a = a.events.size();
  result.events_b = b.events.size();
  result.instants = instants.compared();
  result.other_scenes = a.header.scene_hash != b.header.scene_hash;
  result.other_records = not_in_both(a.changes, b.changes);
  find_first(a.events, b.events, instants, result);
  if (result.first != 0) show_rows(text_a, text_b, result);
  for (const Entry& event : a.events) {
    ++kinds.of(event).events_a;
    ++kinds.of(event).missing;  // less the matched ones, below
  }
  for (const Entry& event : b.events) {
    ++kinds.of(event).events_b;
    ++kinds.of(event).invented;
  }
  const std::vector<std::size_t> matched = match(a.events, b.events, names.size());
  std::size_t common = 0;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    if (matched[i] == kNone) continue;
    ++common;
    --kinds.of(a.events[i]).missing;
    --kinds.of(a.events[i]).invented;
    const Entry& other = b.events[matched[i]];
    if (a.events[i].external != other.external) ++result.other_effects;
    if (!instants.same(a.events[i].instant, other.instant)) ++result.other_instants;
  }
  result.missing = a.events.size() - common;
  result.invented = b.events.size() - common;
  result.out_of_order = common - longest_in_order(matched);
  result.kinds = kinds.sorted();
  return result;
}

}  // namespace kinex::formats
