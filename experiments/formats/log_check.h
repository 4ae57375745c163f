// SPDX-License-Identifier: GPL-3.0-or-later
// Re-verifies an event log: its own claims, and its agreement with its scene.
//
// level 0  the format of every member, names, counts, digest and seal
// level 1  each instant: its name holds exactly that root, its decimal is its own; times never
//          decrease, compared exactly (exact logs; "intervals": as far as intervals tell)
// level 2  with the scene: its hash, name, objects and structures, and of each certificate of a
//          point structure the polynomial, made anew: it vanishes at the instant and is negative
//          right after it
// Whether an event is the right one, or one is missing, is decided by a replay: kinex-logcheck.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_CHECK_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_CHECK_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/log_reader.h"

namespace kinex {

struct LogVerdict {
  LogHeader header;
  std::uint64_t records = 0;
  std::uint64_t external = 0;
  std::uint64_t instants = 0;      // distinct (logs with names only)
  std::string status;              // of the last line; empty if there is none
  std::string digest;              // recomputed
  bool with_scene = false;         // level 2 was done ..
  std::uint64_t certificates = 0;  // .. for so many certificates,
  std::uint64_t unchecked = 0;     // but not for so many
  // "line 7: ..." for each claim that does not hold; at most kMaxProblems are kept.
  static constexpr std::size_t kMaxProblems = 20;
  std::vector<std::string> problems;
};

// Levels 0 and 1, with a scene level 2. Throws InputError for text that is no event log, or is cut
// off in the middle of a line. `hash`: of the scene's file.
LogVerdict check_log(std::string_view text, const std::string& file, const Scene* scene = nullptr,
                     const std::string& hash = {});

}  // namespace kinex

#endif
