// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on a run of an extreme in an inexact arithmetic, against the exact run, by the code
// of `kinex diff`.
#ifndef KINEX_TESTS_EXTREMES_VERDICT_H
#define KINEX_TESTS_EXTREMES_VERDICT_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/engine/simulator.h"
#include "core/motion/scene.h"

namespace kinex::extremes {

enum class RunVerdict {
  kRight,    // the same events in the same order, and the same structure at the end
  kOrder,    // the same events in another order, and the same structure at the end
  kWrong,    // events missed or invented, or another structure at the end, undetected
  kCorrupt,  // the structure has noticed that the numbers contradict each other
  kEndless,  // no end within kMostEvents times as many events as there are
};
inline constexpr int kVerdicts = 5;
inline constexpr std::uint64_t kMostEvents = 20, kFreeEvents = 1000000;
// Larger scenes take too long for the page of verdicts.
inline constexpr std::size_t kMostPageObjects = 250;
// "right", "order", "wrong", "corrupt", "endless".
std::string verdict_name(RunVerdict verdict);

struct LoggedRun {
  RunStatus status = RunStatus::kDone;
  std::string log;
  std::uint64_t events = 0;
  bool corrupt = false;
  std::vector<ObjectId> attribute;  // at the end, of the first structure
};

// max_events 0: no limit.
LoggedRun run_logged(const Scene& scene, const std::string& arithmetic, std::uint64_t max_events);

RunVerdict judge(const Scene& scene, const LoggedRun& exact, const std::string& arithmetic);

}  // namespace kinex::extremes

#endif
