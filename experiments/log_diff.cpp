// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/log_diff.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "experiments/event_log.h"
#include "experiments/log_reader.h"

namespace kinex {

namespace {

struct Entry {
  std::uint32_t name;     // of structure, kind and ids
  std::uint32_t instant;  // of polynomial and root; 0 in an inexact log
  std::size_t line;
  std::string_view text;
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

std::vector<Entry> read_entries(LogReader& reader, Names& names, Names& instants) {
  std::vector<Entry> entries;
  LogEvent event;
  while (reader.next(event)) {
    const std::string name =
        digest_line(event.structure, event.kind, {event.ids.begin(), event.ids.end()});
    std::string instant;
    if (reader.header().exact) {
      instant = event.time.polynomial.to_string() + " root " + std::to_string(event.time.root);
    }
    entries.push_back({names.number(name), instants.number(instant), event.line, event.text});
  }
  return entries;
}

// For each event of `a` the position in `b` of the event that it is matched with, or kNone.
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

void find_first(const std::vector<Entry>& a, const std::vector<Entry>& b, bool with_instants,
                LogDifference& result) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const bool both = i < a.size() && i < b.size();
    if (both && a[i].name == b[i].name && (!with_instants || a[i].instant == b[i].instant))
      continue;
    result.first = i + 1;
    if (i < a.size()) {
      result.line_a = a[i].line;
      result.text_a = a[i].text;
    }
    if (i < b.size()) {
      result.line_b = b[i].line;
      result.text_b = b[i].text;
    }
    return;
  }
}

}  // namespace

LogDifference diff_logs(std::string_view text_a, const std::string& file_a, std::string_view text_b,
                        const std::string& file_b) {
  LogReader reader_a(text_a, file_a);
  LogReader reader_b(text_b, file_b);
  Names names, instants;
  const std::vector<Entry> a = read_entries(reader_a, names, instants);
  const std::vector<Entry> b = read_entries(reader_b, names, instants);
  const bool with_instants = reader_a.header().exact && reader_b.header().exact;

  LogDifference result;
  result.events_a = a.size();
  result.events_b = b.size();
  result.other_scenes = reader_a.header().scene_hash != reader_b.header().scene_hash;
  find_first(a, b, with_instants, result);
  const std::vector<std::size_t> matched = match(a, b, names.size());
  std::size_t common = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (matched[i] == kNone) continue;
    ++common;
    if (with_instants && a[i].instant != b[matched[i]].instant) ++result.other_instants;
  }
  result.missing = a.size() - common;
  result.invented = b.size() - common;
  result.out_of_order = common - longest_in_order(matched);
  return result;
}

}  // namespace kinex
