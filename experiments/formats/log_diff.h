// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two event logs: the first difference, and counts of all differences.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_DIFF_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_DIFF_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/formats/log_ending.h"
#include "experiments/formats/log_match.h"
#include "experiments/formats/log_pairs.h"

namespace kinex::formats {

// The events of one kind of a structure in both logs.
struct KindDifference {
  std::string structure, kind;  // the label in a
  std::uint64_t events_a = 0, events_b = 0;
  std::uint64_t missing = 0, invented = 0;  // as below
};

// A record that is not the same in both logs. Lines and rows (log_table.h) are 0 and "" in a log without it.
struct RecordDifference {
  bool is_change = false;  // in one log only, not counted as missing or invented
  bool out_of_order = false, other_effect = false, other_instant = false;  // of records in both
  std::size_t line_a = 0, line_b = 0;
  std::string row_a, row_b;

  bool missing() const { return line_b == 0; }
  bool invented() const { return line_a == 0; }
};

// Compares the structures that log_pairs.h pairs.
//   kEvents      Their events, external and internal: all records except those of changes (motion, insert,
//                erase, and a rebuild that changed nothing). Two events are the same if structure, kind,
//                ids, "gone" and "came" agree.
//   kAttributes  Their external events. Two are the same if "gone" and "came" agree, or the ids where they
//                determine these; and the kind where the attribute is a cycle or of bodies. Those at one
//                instant have no order.
// log_match.h says which of several such of one log is which of the other. Where one log ends before the
// other, the records of the longer one after that end are counted by themselves, not as differences.
struct LogDifference {
  std::uint64_t events_a = 0, events_b = 0;  // of the structures in both
  // The first place at which the events differ, counted from 1, with both records as rows of a table
  // (log_table.h; "" and line 0 past a log's end): other events, or one event with another effect or at
  // another instant.
  std::uint64_t first = 0;  // 0: none
  std::size_t line_a = 0, line_b = 0;
  std::string row_a, row_b;
  std::uint64_t missing = 0;   // in a, not in b, though not after its end
  std::uint64_t invented = 0;  // in b, not in a, though not after its end
  // The fewest matched events to remove so that the rest are in the same order.
  std::uint64_t out_of_order = 0;
  std::uint64_t other_effects = 0;  // matched events, external in one log and internal in the other
  std::uint64_t other_instants = 0;  // matched events at different instants
  // Records of changes in one log and not in the other; in both logs together.
  std::uint64_t other_records = 0;
  std::uint64_t after_b = 0, after_a = 0;  // records of a after the end of b, of b after that of a
  // In the order of the logs, but for those after an end; as many as were asked for.
  std::vector<RecordDifference> differences;
  std::uint64_t different = 0;  // how many there are
  InstantsCompared instants = InstantsCompared::kNot;
  std::vector<std::string> only_a, only_b;  // labels of structures that the other log does not have
  std::vector<OtherLabel> other_labels;
  std::vector<KindDifference> kinds;  // by structure and kind
  bool other_scenes = false;                // the scene hashes differ
  LogEnding ending_a, ending_b;

  bool equal() const { return first == 0 && other_records == 0 && after_a == 0 && after_b == 0; }
};

// Throws InputError for text that is no event log, and for two logs with nothing to compare.
// Cut-off logs are compared as far as they go. `most`: differences to be listed. Cost: linear in the logs
// but for a sort, and for events that come often, and not as often in both; both are held in memory.
LogDifference diff_logs(std::string_view text_a, const std::string& file_a, std::string_view text_b,
                        const std::string& file_b, std::size_t most = 0,
                        Compared compared = Compared::kEvents);

}  // namespace kinex::formats

#endif
