// SPDX-License-Identifier: GPL-3.0-or-later
// The structures of a log that its scene did not maintain: they were built for others to read.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_USES_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_USES_H

#include <cstdint>
#include <set>
#include <string>

#include "experiments/formats/log_reader.h"

namespace kinex::formats {

// Their labels, which a plan makes of those of their readers: READER.STRUCTURE, READER.STRUCTURE:x (structures/plan.h).
std::set<std::string> labels_only_read(const LogHeader& header);

// External records of a log, by what the structures were built for.
struct ExternalByUse {
  std::uint64_t maintained = 0, read = 0;
  // "12 external", "12 external (and 30 of structures that these read)"
  std::string text() const;
};

}  // namespace kinex::formats

#endif
