// SPDX-License-Identifier: GPL-3.0-or-later
// LogFollower: follows an event log while its scene is run again, and reports where they differ. An
// event log names its scene and what happened, but holds no motions and no states.
#ifndef KINEX_EXPERIMENTS_VIEW_LOG_FOLLOWER_H
#define KINEX_EXPERIMENTS_VIEW_LOG_FOLLOWER_H

#include <string>
#include <string_view>

#include "core/motion/scene.h"
#include "experiments/formats/log_scene.h"
#include "experiments/view/recorder.h"

namespace kinex {

class LogFollower {
 public:
  // `text` must outlive it. Throws InputError for text that is no log, or if the log is of another
  // scene or of something else than `scene` maintains. `hash`: of the scene's file.
  LogFollower(std::string_view text, const std::string& file, const Scene& scene,
              const std::string& hash);

  const LogHeader& header() const { return reader_.header(); }
  // True if the log has this record next: same structure, kind, ids, effect (external or internal),
  // difference ("gone" and "came") and, as far as the log tells, the same instant. False at the end
  // of the log, and where they part; then problem() says how.
  bool follow(const SeenEvent& event);
  // The run is at its end: the log must be, too.
  void finish();
  const std::string& problem() const { return problem_; }

 private:
  LogReader reader_;
  LogRecord next_;
  std::string problem_;
};

}  // namespace kinex

#endif
