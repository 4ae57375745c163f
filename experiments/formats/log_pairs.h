// SPDX-License-Identifier: GPL-3.0-or-later
// Which structures of one event log are compared with which of another.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_PAIRS_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_PAIRS_H

#include <map>
#include <string>
#include <vector>

#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// What two logs are compared for.
enum class Compared {
  // Every event, external and internal. Structures: of the same name, key and options.
  kEvents,
  // What external events change, whatever the method. Structures: for one attribute (those of one group,
  // StructureInfo::group, or of one name) by the same key, of the same objects, and with the same
  // parameters; those that only one of the two has, and the names of what they read, do not matter.
  kAttributes,
};

// A structure that has another label or another name in the other log.
struct OtherLabel {
  std::string label_a, label_b;
};

struct LogPairs {
  // The label in a log -> the one under which it is compared, that of a. Of several structures that could be
  // compared those with the same label go first, then those of the same name and options.
  std::map<std::string, std::string> labels_a, labels_b;
  std::vector<OtherLabel> other_labels;
  std::vector<std::string> only_a, only_b;  // labels of structures that are not compared
};

// Each structure is in one pair at most. Throws InputError that names `file_b` if both logs have structures, but
// none to compare.
LogPairs pair_structures(const LogHeader& a, const std::string& file_a, const LogHeader& b,
                         const std::string& file_b, Compared compared);

}  // namespace kinex::formats

#endif
