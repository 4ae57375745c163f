// SPDX-License-Identifier: GPL-3.0-or-later
// ChildProcess: another program that runs in parallel; its output is read while it runs, and its
// CPU time and memory are measured. By posix_spawn and wait4: experiments/README.md, "Kept by hand",
// says why not by Boost.Process.
#ifndef KINEX_EXPERIMENTS_LAB_CHILD_PROCESS_H
#define KINEX_EXPERIMENTS_LAB_CHILD_PROCESS_H

#include <sys/types.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

namespace kinex::lab {

struct ChildEnd {
  int code = 0;       // exit code; 0 if it was ended by a signal
  int signal = 0;     // 0: it exited
  double cpu_s = 0;   // user and system
  double wall_s = 0;  // from its start
  long peak_kb = 0;   // largest resident memory; 0 if no larger than that of this program
};

// Its standard input is empty; its standard output and standard error are collected. It has its own
// process group, so a Ctrl-C does not reach it. All signals that this program handles have their
// default actions in it. The destructor kills it.
class ChildProcess {
 public:
  // `program`: a path. Throws InputError if it cannot be started.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // File descriptors that become readable when there is something for read(); -1: closed.
  const std::array<int, 2>& descriptors() const { return descriptors_; }
  // Collects the available output without waiting. False when both outputs are closed: it has
  // ended.
  bool read();
  // Waits until it has ended. To be called once.
  ChildEnd wait();

  const std::string& out() const { return texts_[0]; }
  const std::string& err() const { return texts_[1]; }

 private:
  pid_t child_ = 0;  // 0: waited for
  std::array<int, 2> descriptors_{-1, -1};
  std::array<std::string, 2> texts_;
  long own_peak_kb_ = 0;  // of this program at the start of the child, which inherits the value
  std::chrono::steady_clock::time_point began_;
};

// Limits of a process; 0: none. A child sets its own before anything else.
struct ProcessLimits {
  int seconds = 0;  // CPU time; then SIGXCPU, a second later SIGKILL
  // Address space (RLIMIT_AS) in units of 2^20 bytes. Ignored in builds with AddressSanitizer,
  // which reserves more than any machine has.
  int megabytes = 0;
};
// Throws InputError for a limit above the one in force here (ulimit -H): a child could not set it.
void check_limits(const ProcessLimits& limits);
// Sets the limits, and no core files. If `parent` is not 0 the process is killed when that process
// ends. Throws InputError if a limit cannot be set.
void limit_this_process(const ProcessLimits& limits, pid_t parent);

// The largest resident memory of this program in KiB, without that of the program that started it;
// 0 if the system does not provide it.
long own_peak_kb();

}  // namespace kinex::lab

#endif
