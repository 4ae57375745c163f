// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of verbs that resume after an interruption (finished_work.h).
#ifndef KINEX_EXPERIMENTS_VERBS_RESUMED_WORK_H
#define KINEX_EXPERIMENTS_VERBS_RESUMED_WORK_H

#include <string>
#include <string_view>
#include <utility>

#include "experiments/lab/finished_work.h"

namespace kinex {

// A file of results. What an interrupted run wrote is replaced without --force by the run that goes
// on. Throws InputError as soon as it is made, if the file cannot be written.
class ResultFile {
 public:
  ResultFile(std::string path, bool force, FinishedWork& finished);
  void write(std::string_view text) const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool force_;
  FinishedWork& finished_;
};

// On stderr, if there are any: "12 experiments are finished already".
void tell_what_is_found(const FinishedWork& finished, const char* one, const char* many);

}  // namespace kinex

#endif
