// SPDX-License-Identifier: GPL-3.0-or-later
// SecondProgram: checks the log of a small run by kinex-logcheck, a program in another language
// that shares nothing with this one (experiments/logcheck).
#ifndef KINEX_EXPERIMENTS_LAB_SECOND_PROGRAM_H
#define KINEX_EXPERIMENTS_LAB_SECOND_PROGRAM_H

#include <atomic>
#include <functional>
#include <string>

#include "experiments/lab/checked_by.h"

namespace kinex::lab {

class SecondProgram {
 public:
  // `path`: the program, or a folder with a __main__.py, which python3 runs; empty: the one beside this program, or else in PATH. `go_on` and
  // `interrupt` as in run_record.
  SecondProgram(std::string path, std::function<bool()> go_on, const std::atomic<bool>* interrupt);

  // Runs `run` in `exact`, with a log in a temporary folder, and checks it at all levels. After an
  // interruption the result is "not checked".
  CheckedBy check(const RunKey& run) const;
  // Whether there is such a program: at its path, or in PATH.
  bool exists() const;
  // Its name in results: "kinex-logcheck", or the path that was given.
  const std::string& name() const { return name_; }

 private:
  std::string path_, name_;
  std::function<bool()> go_on_;
  const std::atomic<bool>* interrupt_;
};

}  // namespace kinex::lab

#endif
