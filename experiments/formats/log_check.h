// SPDX-License-Identifier: GPL-3.0-or-later
// Verifies an event log again: its own claims, and its agreement with its scene.
//
// level 0  the format of every member, names, counts, digest and seal
// level 1  each instant: its interval isolates exactly that root, its decimal is correct; times
//          never decrease, compared exactly (exact logs; "intervals": as far as intervals decide)
// level 2  with the scene: its hash, name, objects and structures; for each certificate of a point
//          structure the recomputed polynomial vanishes at the instant and is negative right after
// It does not decide whether an event is the right one, or whether one is missing: that takes a
// replay (kinex-logcheck).
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_CHECK_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_CHECK_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/scene.h"
#include "experiments/formats/log_reader.h"
#include "experiments/formats/log_uses.h"
#include "experiments/formats/unchecked_certificates.h"

namespace kinex::formats {

struct LogVerdict {
  LogHeader header;
  std::uint64_t records = 0;
  std::uint64_t external = 0;
  ExternalByUse external_by_use;   // the same in two parts
  std::uint64_t instants = 0;      // distinct (logs with names only)
  std::string status;              // of the last line; empty if there is none
  std::vector<LogCorruption> corrupt;  // as the last line says
  std::string digest;              // recomputed
  bool with_scene = false;         // it was compared with its scene
  std::uint64_t certificates = 0;  // certificates checked at level 2
  UncheckedCertificates unchecked;  // those that level 2 could not check
  // "line 7: ..." for each claim that does not hold; at most kMaxProblems are kept.
  static constexpr std::size_t kMaxProblems = 20;
  std::vector<std::string> problems;

  // Level 1, as far as the log's detail allows.
  bool instants_checked() const { return header.has_intervals(); }
  // Level 2: some certificates at least, where there are some.
  bool certificates_checked() const {
    return with_scene && header.has_names() && (certificates > 0 || unchecked.count() == 0);
  }
};

// Checks levels 0 and 1, and level 2 if there is a scene. Throws InputError for text that is no
// event log; that one was cut off is a problem. `hash`: that of the scene's file; if the log was
// not made from that, its header alone is compared with the scene.
LogVerdict check_log(std::string_view text, const std::string& file, const Scene* scene = nullptr,
                     const std::string& hash = {});

}  // namespace kinex::formats

#endif
