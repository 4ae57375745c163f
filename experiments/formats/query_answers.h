// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to continuous collision queries as text or JSON, and their comparison with a truth
// column.
#ifndef KINEX_EXPERIMENTS_FORMATS_QUERY_ANSWERS_H
#define KINEX_EXPERIMENTS_FORMATS_QUERY_ANSWERS_H

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/formats/query_file.h"

namespace kinex::formats {

struct ContactTally {
  std::uint64_t queries = 0, contacts = 0;
  // Against the truth column; all 0 without one. A positive is an answer "contact".
  std::uint64_t true_positives = 0, true_negatives = 0, false_positives = 0, false_negatives = 0;

  bool differs() const { return false_positives + false_negatives > 0; }
  void count(bool contact, std::optional<bool> truth);
};

// One query's answer.
struct ContactAnswer {
  std::uint64_t number = 0;  // of the query in its file, from 1
  std::size_t line = 0;
  bool contact = false;
  std::optional<ContactTime> time;  // of a contact; not narrowed before it is written
  std::optional<bool> truth;
};

// One line, with its end. Decimals have 17 digits after the point, as in event logs.
//   {"query": K, "line": L, "contact": BOOLEAN, "time": {"polynomial": [..], "root": K,
//    "interval": ["a", "b"], "decimal": S} or null, "truth": BOOLEAN or null}
// A rational instant has equal ends.
std::string answer_text(ContactAnswer& answer, RootCounters& counters);
std::string answer_json(ContactAnswer& answer, RootCounters& counters);

//   {"file": S, "kind": S, "queries": K, "contacts": K, "true_positives": K or null, ..}
std::string tally_text(const ContactTally& tally, const std::string& file, ContactKind kind,
                       bool has_truth);
std::string tally_json(const ContactTally& tally, const std::string& file, ContactKind kind,
                       bool has_truth);

}  // namespace kinex::formats

#endif
