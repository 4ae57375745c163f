// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/extremes/verdict.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/log_diff.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/scene_run.h"

namespace kinex::extremes {

std::string verdict_name(RunVerdict verdict) {
  switch (verdict) {
    case RunVerdict::kRight:
      return "right";
    case RunVerdict::kOrder:
      return "order";
    case RunVerdict::kWrong:
      return "wrong";
    case RunVerdict::kCorrupt:
      return "corrupt";
    case RunVerdict::kEndless:
      return "endless";
  }
  return "";
}

LoggedRun run_logged(const Scene& scene, const std::string& arithmetic, std::uint64_t max_events) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("kinex-extreme-" + std::to_string(::getpid()) + ".log"))
                               .string();
  SimulatorOptions options;
  options.audit = AuditLevel::kNone;
  options.max_events = max_events;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  formats::OutputFile file(path, true);
  formats::EventLog log(*simulator, formats::scene_hash(scene), &file);
  simulator->set_sink(&log);
  LoggedRun run;
  run.status = lab::run_scene(*simulator, {}).status;
  log.finish(run.status);
  run.events = log.records();
  run.corrupt = simulator->ledger(0).corrupt;
  if (!run.corrupt) run.attribute = simulator->structure(0).attribute().ids;
  run.log = formats::read_text_file(path);
  std::filesystem::remove(path);
  return run;
}

RunVerdict judge(const Scene& scene, const LoggedRun& exact, const std::string& arithmetic) {
  const LoggedRun run = run_logged(scene, arithmetic, kMostEvents * exact.events + kFreeEvents);
  if (run.corrupt) return RunVerdict::kCorrupt;
  if (run.status != RunStatus::kDone) return RunVerdict::kEndless;
  const formats::LogDifference difference = formats::diff_logs(exact.log, "exact", run.log, arithmetic);
  if (run.attribute != exact.attribute || difference.missing + difference.invented > 0) {
    return RunVerdict::kWrong;
  }
  return difference.equal() ? RunVerdict::kRight : RunVerdict::kOrder;
}

}  // namespace kinex::extremes
