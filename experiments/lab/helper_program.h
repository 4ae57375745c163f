// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a helper program (gnuplot, kinex-logcheck) to its end.
#ifndef KINEX_EXPERIMENTS_LAB_HELPER_PROGRAM_H
#define KINEX_EXPERIMENTS_LAB_HELPER_PROGRAM_H

#include <functional>
#include <string>
#include <vector>

namespace kinex::lab {

struct HelperEnd {
  enum class How {
    kExited,
    kNotFound,  // the program, or the interpreter of a script, does not exist
    kSignal,    // ended by a signal that this program did not send
    kStopped,   // `go_on` returned false, and it was ended
  };
  How how = How::kExited;
  int code = 0;  // of kExited; the signal of kSignal
};

// Runs `program` (searched in PATH if it has no slash) without a shell and waits for it. Its
// standard input is empty; its outputs go to the files `out` and `err`, which may be the same. It
// has its own process group, so a Ctrl-C does not reach it. `go_on` is called a hundred times a
// second; when it returns false the whole group is killed.
HelperEnd run_helper(const std::string& program, const std::vector<std::string>& arguments,
                     const std::string& out, const std::string& err,
                     const std::function<bool()>& go_on);

}  // namespace kinex::lab

#endif
