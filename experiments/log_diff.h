// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two event logs: where they first part, and how much they disagree.
#ifndef KINEX_EXPERIMENTS_LOG_DIFF_H
#define KINEX_EXPERIMENTS_LOG_DIFF_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

// Two events are the same if structure, kind and ids agree; the k-th such event of one log is
// matched with the k-th of the other. Instants are compared only between two exact logs, where each
// has one name.
struct LogDifference {
  std::uint64_t events_a = 0, events_b = 0;
  // The first place at which the logs differ, counted from 1, with both lines ("" past a log's
  // end).
  std::uint64_t first = 0;  // 0: none
  std::size_t line_a = 0, line_b = 0;
  std::string text_a, text_b;
  std::uint64_t missing = 0;   // in a, not in b
  std::uint64_t invented = 0;  // in b, not in a
  std::uint64_t out_of_order =
      0;  // fewest matched events to take out so that the rest are in one order
  std::uint64_t other_instants = 0;  // matched events at another instant (exact logs only)
  bool other_scenes = false;         // the scene hashes differ

  bool equal() const { return first == 0; }
};

// Throws InputError for text that is no event log. Cut-off logs are compared as far as they go.
// Cost: linear in the logs but for a sort; both are held in memory.
LogDifference diff_logs(std::string_view text_a, const std::string& file_a, std::string_view text_b,
                        const std::string& file_b);

}  // namespace kinex

#endif
