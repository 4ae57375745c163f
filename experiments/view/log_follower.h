// SPDX-License-Identifier: GPL-3.0-or-later
// LogFollower: compares an event log with a new run of its scene, event by event. A log names its
// scene and its events; it has no motions and no states.
#ifndef KINEX_EXPERIMENTS_VIEW_LOG_FOLLOWER_H
#define KINEX_EXPERIMENTS_VIEW_LOG_FOLLOWER_H

#include <optional>
#include <string>
#include <string_view>

#include "core/motion/scene.h"
#include "experiments/formats/log_ending.h"
#include "experiments/formats/log_scene.h"
#include "experiments/view/recorder.h"

namespace kinex::view {

class LogFollower {
 public:
  // `text` must outlive it. Throws InputError for text that is no log, or if the log is of another
  // scene or of something else than `scene` maintains. `hash`: of the scene's file.
  LogFollower(std::string_view text, const std::string& file, const Scene& scene,
              const std::string& hash);

  const formats::LogHeader& header() const { return reader_.header(); }
  // True if this event is the log's next record: same structure, kind, ids, effect (external or
  // internal), difference ("gone" and "came") and, if the log has instants, the same instant. False
  // at the end of the log, and at the first difference; problem() then describes it.
  bool follow(const SeenEvent& event);
  // Call at the end of the run: records left in the log become a problem().
  void finish();
  const std::string& problem() const { return problem_; }
  // How the log ends; nullopt: it has records that were not looked at.
  std::optional<formats::LogEnding> ending() const {
    if (!has_ended_) return std::nullopt;
    return formats::ending_of(reader_);
  }

 private:
  bool next();

  formats::LogReader reader_;
  formats::LogRecord next_;
  std::string problem_;
  bool has_ended_ = false;
};

}  // namespace kinex::view

#endif
