// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_diff.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "experiments/formats/json_writer.h"
#include "experiments/formats/log_instant.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/log_table.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

// What is compared of a record that has a match, and counted.
struct Said {
  std::uint32_t kind;  // of structure and kind
  bool external, is_change;
  std::size_t line;
};

using Labels = std::map<std::string, std::string>;  // as in LogPairs

struct Log : MatchedLog {
  std::vector<Said> said;           // of each of `entries`
  std::vector<std::size_t> events;  // places of those that are no changes
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

std::string name_of(const LogRecord& record, const std::string& label, bool change) {
  std::string text;
  JsonWriter json(text);
  json.begin_array().boolean(change).string(label).string(record.kind);
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
  KindDifference& of(std::uint32_t number) { return tallies_[number]; }
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
    const bool change = is_change(record);
    if (log.instants.empty() || !same_text(log.instants.back(), record.time)) {
      log.instants.push_back(record.time);
    }
    if (!change) log.events.push_back(log.entries.size());
    log.entries.push_back({names.number(name_of(record, label->second, change)),
                           static_cast<std::uint32_t>(log.instants.size() - 1)});
    // Changes are not counted by kind.
    const std::uint32_t kind = change ? 0 : kinds.number(label->second, record.kind);
    log.said.push_back({kind, record.external, change, record.line});
  }
  log.ending = ending_of(reader);
  return log;
}

// What an external event changes: what has gone and come, or the objects that determine it. Its kind tells
// more than the method only where a body or a cycle changes.
std::string change_of(const LogRecord& record, const std::string& label, bool by_kind) {
  std::string text;
  JsonWriter json(text);
  json.begin_array().string(label);
  if (by_kind) json.string(record.kind);
  if (record.change) {
    write_ids(json, record.change->gone);
    write_ids(json, record.change->came);
  } else {
    write_ids(json, record.ids);
  }
  json.end_array();
  return text;
}

// The labels of the log whose changes are told by their kinds, too.
std::set<std::string> labels_by_kind(const LogHeader& header) {
  std::set<std::string> labels;
  for (const LogStructure& one : header.structures) {
    const StructureInfo* const info = find_structure_info(one.structure);
    if (info == nullptr || info->bodies || info->shape == Attribute::Shape::kCycle)
      labels.insert(one.label);
  }
  return labels;
}

// The external events alone. Methods have no order of those at one instant in common: they are sorted.
Log read_changes(LogReader& reader, const Labels& labels, Names& names, Kinds& kinds) {
  Log log;
  log.header = reader.header();
  const std::set<std::string> by_kind = labels_by_kind(log.header);
  std::vector<std::pair<std::uint32_t, Said>> now;  // of the last instant, with their names
  const auto end_instant = [&] {
    std::stable_sort(now.begin(), now.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [name, said] : now) {
      log.events.push_back(log.entries.size());
      log.entries.push_back({name, static_cast<std::uint32_t>(log.instants.size() - 1)});
      log.said.push_back(said);
    }
    now.clear();
  };
  LogRecord record;
  while (reader.next(record)) {
    const auto label = labels.find(record.structure);
    if (label == labels.end() || !record.external) continue;
    if (log.instants.empty() || !same_text(log.instants.back(), record.time)) {
      end_instant();
      log.instants.push_back(record.time);
    }
    now.emplace_back(names.number(change_of(record, label->second, by_kind.contains(label->first))),
                     Said{kinds.number(label->second, record.kind), true, false, record.line});
  }
  end_instant();
  log.ending = ending_of(reader);
  return log;
}

// By place in a: the event has a match and stands, with the fewest others, in the way of an order that both
// logs have. The others are a longest increasing subsequence of the matches.
std::vector<bool> out_of_order(const Log& a, const LogMatch& match) {
  std::vector<bool> result(a.entries.size(), false);
  // tails[k]: the event of a at the smallest end of an increasing subsequence of length k + 1
  std::vector<std::size_t> tails, before(a.entries.size(), LogMatch::kNone);
  for (const std::size_t i : a.events) {
    if (match.in_b[i] == LogMatch::kNone) continue;
    result[i] = true;
    const auto at = std::lower_bound(
        tails.begin(), tails.end(), match.in_b[i],
        [&](std::size_t tail, std::size_t place) { return match.in_b[tail] < place; });
    if (at != tails.begin()) before[i] = *(at - 1);
    if (at == tails.end()) {
      tails.push_back(i);
    } else {
      *at = i;
    }
  }
  for (std::size_t i = tails.empty() ? LogMatch::kNone : tails.back(); i != LogMatch::kNone;
       i = before[i]) {
    result[i] = false;
  }
  return result;
}

void find_first(const Log& a, const Log& b, InstantsOf& instants, LogDifference& result) {
  for (std::size_t i = 0; i < std::max(a.events.size(), b.events.size()); ++i) {
    const bool in_a = i < a.events.size(), in_b = i < b.events.size();
    if (in_a && in_b) {
      const auto &one = a.entries[a.events[i]], &other = b.entries[b.events[i]];
      if (one.name == other.name && a.said[a.events[i]].external == b.said[b.events[i]].external &&
          instants.same(one.instant, other.instant)) {
        continue;
      }
    }
    result.first = i + 1;
    if (in_a) result.line_a = a.said[a.events[i]].line;
    if (in_b) result.line_b = b.said[b.events[i]].line;
    return;
  }
}

// Counts what differs, and lists the first `most`.
class Tally {
 public:
  Tally(const Log& a, const Log& b, Kinds& kinds, std::size_t most, LogDifference& result)
      : a_(a), b_(b), kinds_(kinds), most_(most), result_(result) {}

  void count(const LogMatch& match, InstantsOf& instants) {
    const std::vector<bool> astray = out_of_order(a_, match);
    std::vector<bool> matched(b_.entries.size(), false);
    for (const std::size_t j : match.in_b) {
      if (j != LogMatch::kNone) matched[j] = true;
    }
    std::size_t next = 0;  // in b
    const auto alone_in_b = [&](std::size_t end) {
      for (; next < end; ++next) {
        if (!matched[next]) add_alone(b_, next, match.after_a[next], false);
      }
    };
    for (std::size_t i = 0; i < a_.entries.size(); ++i) {
      const std::size_t j = match.in_b[i];
      if (j == LogMatch::kNone) {
        add_alone(a_, i, match.after_b[i], true);
        continue;
      }
      alone_in_b(j);
      const Said &one = a_.said[i], &other = b_.said[j];
      count_event(one, true);
      count_event(other, false);
      if (one.is_change) continue;
      RecordDifference difference;
      difference.out_of_order = astray[i];
      difference.other_effect = one.external != other.external;
      difference.other_instant = !instants.same(a_.entries[i].instant, b_.entries[j].instant);
      result_.out_of_order += difference.out_of_order ? 1 : 0;
      result_.other_effects += difference.other_effect ? 1 : 0;
      result_.other_instants += difference.other_instant ? 1 : 0;
      difference.line_a = one.line;
      difference.line_b = other.line;
      if (difference.out_of_order || difference.other_effect || difference.other_instant)
        add(difference);
    }
    alone_in_b(b_.entries.size());
  }

 private:
  void count_event(const Said& entry, bool in_a) {
    if (entry.is_change) return;
    KindDifference& kind = kinds_.of(entry.kind);
    ++(in_a ? kind.events_a : kind.events_b);
  }

  void add_alone(const Log& log, std::size_t place, bool after_end, bool in_a) {
    const Said& entry = log.said[place];
    count_event(entry, in_a);
    if (after_end) {
      ++(in_a ? result_.after_b : result_.after_a);
      return;
    }
    RecordDifference difference;
    difference.is_change = entry.is_change;
    (in_a ? difference.line_a : difference.line_b) = entry.line;
    add(difference);
    if (entry.is_change) {
      ++result_.other_records;
      return;
    }
    KindDifference& kind = kinds_.of(entry.kind);
    ++(in_a ? kind.missing : kind.invented);
    ++(in_a ? result_.missing : result_.invented);
  }

  void add(const RecordDifference& difference) {
    ++result_.different;
    if (result_.differences.size() < most_) result_.differences.push_back(difference);
  }

  const Log& a_;
  const Log& b_;
  Kinds& kinds_;
  const std::size_t most_;
  LogDifference& result_;
};

// Rows for lines of both logs: aligned for each of the sets of lines. Line 0: no record.
class Rows {
 public:
  Rows(std::string_view text_a, std::string_view text_b) : text_a_(text_a), text_b_(text_b) {}

  void want(std::size_t line_a, std::size_t line_b) {
    if (line_a != 0) wanted_a_.emplace(line_a, LogRow{});
    if (line_b != 0) wanted_b_.emplace(line_b, LogRow{});
  }
  void read() {
    read(text_a_, wanted_a_);
    read(text_b_, wanted_b_);
  }
  // The rows of the lines (of a, of b), as lines of one table.
  std::vector<std::pair<std::string, std::string>> aligned(
      const std::vector<std::pair<std::size_t, std::size_t>>& lines) const {
    std::vector<LogRow> rows;
    for (const auto& [line_a, line_b] : lines) {
      if (line_a != 0) rows.push_back(wanted_a_.at(line_a));
      if (line_b != 0) rows.push_back(wanted_b_.at(line_b));
    }
    const std::vector<std::string> texts = aligned_rows(rows);
    std::vector<std::pair<std::string, std::string>> result;
    std::size_t next = 0;
    for (const auto& [line_a, line_b] : lines) {
      auto& [text_a, text_b] = result.emplace_back();
      if (line_a != 0) text_a = texts[next++];
      if (line_b != 0) text_b = texts[next++];
    }
    return result;
  }

 private:
  using Wanted = std::map<std::size_t, LogRow>;
  static void read(std::string_view text, Wanted& wanted) {
    if (wanted.empty()) return;
    LogReader reader(text, "");
    LogRecord record;
    while (reader.next(record)) {
      const auto found = wanted.find(record.line);
      if (found == wanted.end()) continue;
      found->second = log_row(record, reader.header());
      if (std::next(found) == wanted.end()) return;
    }
  }

  std::string_view text_a_, text_b_;
  Wanted wanted_a_, wanted_b_;
};

void show_rows(std::string_view text_a, std::string_view text_b, LogDifference& result) {
  Rows rows(text_a, text_b);
  std::vector<std::pair<std::size_t, std::size_t>> lines;
  rows.want(result.line_a, result.line_b);
  for (const RecordDifference& one : result.differences) {
    rows.want(one.line_a, one.line_b);
    lines.emplace_back(one.line_a, one.line_b);
  }
  rows.read();
  std::tie(result.row_a, result.row_b) = rows.aligned({{result.line_a, result.line_b}}).front();
  const auto texts = rows.aligned(lines);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::tie(result.differences[i].row_a, result.differences[i].row_b) = texts[i];
  }
}

}  // namespace

LogDifference diff_logs(std::string_view text_a, const std::string& file_a, std::string_view text_b,
                        const std::string& file_b, std::size_t most, Compared compared) {
  LogReader reader_a(text_a, file_a);
  LogReader reader_b(text_b, file_b);
  LogDifference result;
  LogPairs pairs = pair_structures(reader_a.header(), file_a, reader_b.header(), file_b, compared);
  Names names;
  Kinds kinds;
  const auto read = compared == Compared::kEvents ? read_log : read_changes;
  const Log a = read(reader_a, pairs.labels_a, names, kinds);
  const Log b = read(reader_b, pairs.labels_b, names, kinds);
  InstantsOf instants(a, b);

  result.other_labels = std::move(pairs.other_labels);
  result.only_a = std::move(pairs.only_a);
  result.only_b = std::move(pairs.only_b);
  result.ending_a = a.ending;
  result.ending_b = b.ending;
  result.events_a = a.events.size();
  result.events_b = b.events.size();
  result.instants = instants.compared();
  result.other_scenes = a.header.scene_hash != b.header.scene_hash;
  find_first(a, b, instants, result);
  Tally(a, b, kinds, most, result).count(match_logs(a, b, instants, names.size()), instants);
  show_rows(text_a, text_b, result);
  result.kinds = kinds.sorted();
  return result;
}

}  // namespace kinex::formats
