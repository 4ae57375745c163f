// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

#include "experiments/formats/input_error.h"
#include "experiments/lab/start_program.h"

#ifndef __has_feature
#define __has_feature(x) 0
#endif

namespace kinex::lab {

namespace {

#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr bool kAddressSanitizer = true;
#else
constexpr bool kAddressSanitizer = false;
#endif

[[noreturn]] void cannot_start(const std::string& program, int error) {
  throw formats::InputError(program, "", std::string("cannot be started: ") + std::strerror(error), "");
}

int close_all(const std::array<int, 4>& ends) {
  const int error = errno;
  for (const int end : ends) {
    if (end >= 0) ::close(end);
  }
  return error;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

constexpr const char* kLimitRemedy = "give a smaller limit, or raise that of the shell (ulimit -H)";

void set_limit(int resource, const char* name, rlim_t soft, rlim_t hard) {
  const rlimit limit{soft, hard};
  if (::setrlimit(resource, &limit) == 0) return;
  throw formats::InputError(name, "", std::string("this limit cannot be set: ") + std::strerror(errno),
                   kLimitRemedy);
}

void check_limit(int resource, const char* name, rlim_t wanted) {
  rlimit in_force{};
  if (::getrlimit(resource, &in_force) != 0 || in_force.rlim_max == RLIM_INFINITY ||
      wanted <= in_force.rlim_max) {
    return;
  }
  throw formats::InputError(name, "", "this limit is above the one in force here", kLimitRemedy);
}

rlim_t bytes_of(int megabytes) { return static_cast<rlim_t>(megabytes) << 20; }

}  // namespace

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments) {
  std::array<int, 4> ends{-1, -1, -1, -1};  // read and write end of both outputs
  if (::pipe2(&ends[0], O_CLOEXEC) != 0 || ::pipe2(&ends[2], O_CLOEXEC) != 0) {
    cannot_start(program, close_all(ends));
  }
  rusage own{};
  ::getrusage(RUSAGE_SELF, &own);
  own_peak_kb_ = own.ru_maxrss;
  began_ = std::chrono::steady_clock::now();
  const int failed =
      start_program(child_, program, ProgramName::kPath, arguments, ends[1], ends[3]);
  if (failed != 0) {
    child_ = 0;
    close_all(ends);
    cannot_start(program, failed);
  }
  ::close(ends[1]);
  ::close(ends[3]);
  descriptors_ = {ends[0], ends[2]};
  for (const int end : descriptors_) ::fcntl(end, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  if (child_ != 0) {
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  for (const int end : descriptors_) {
    if (end >= 0) ::close(end);
  }
}

bool ChildProcess::read() {
  for (std::size_t i = 0; i < descriptors_.size(); ++i) {
    while (descriptors_[i] >= 0) {
      std::array<char, 1 << 16> block;
      const ssize_t got = ::read(descriptors_[i], block.data(), block.size());
      if (got > 0) {
        texts_[i].append(block.data(), static_cast<std::size_t>(got));
      } else if (got < 0 && errno == EINTR) {
        continue;
      } else if (got < 0 && errno == EAGAIN) {
        break;
      } else {
        ::close(std::exchange(descriptors_[i], -1));
      }
    }
  }
  return descriptors_[0] >= 0 || descriptors_[1] >= 0;
}

ChildEnd ChildProcess::wait() {
  int status = 0;
  rusage used{};
  while (::wait4(child_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  child_ = 0;
  ChildEnd end;
  const auto taken = std::chrono::steady_clock::now() - began_;
  end.wall_s = std::chrono::duration<double>(taken).count();
  end.cpu_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (used.ru_maxrss > own_peak_kb_) end.peak_kb = used.ru_maxrss;
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

void check_limits(const ProcessLimits& limits) {
  if (limits.seconds > 0) {
    check_limit(RLIMIT_CPU, "seconds", static_cast<rlim_t>(limits.seconds) + 1);
  }
  if (limits.megabytes > 0) check_limit(RLIMIT_AS, "megabytes", bytes_of(limits.megabytes));
}

void limit_this_process(const ProcessLimits& limits, pid_t parent) {
  if (parent != 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::raise(SIGKILL);  // it has ended already
  }
  set_limit(RLIMIT_CORE, "core files", 0, 0);
  if (limits.seconds > 0) {
    const auto seconds = static_cast<rlim_t>(limits.seconds);
    set_limit(RLIMIT_CPU, "seconds", seconds, seconds + 1);
  }
  if (limits.megabytes > 0 && !kAddressSanitizer) {
    const rlim_t bytes = bytes_of(limits.megabytes);
    set_limit(RLIMIT_AS, "megabytes", bytes, bytes);
  }
}

long own_peak_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::strtol(line.c_str() + 6, nullptr, 10);
  }
  return 0;
}

}  // namespace kinex::lab
