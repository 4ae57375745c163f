// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/helper_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "experiments/lab/start_program.h"

namespace kinex::lab {

namespace {

constexpr std::chrono::milliseconds kLook{10};
constexpr int kNoInterpreter = 127;  // a shell's exit code where a program is not found

// Opened anew for the output of a program; -1 if that fails.
int open_output(const std::string& path) {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

// False if it cannot be started, or its outputs cannot be written.
bool start(pid_t& child, const std::string& program, const std::vector<std::string>& arguments,
           const std::string& out, const std::string& err) {
  const int out_end = open_output(out);
  const int err_end = out == err ? out_end : open_output(err);
  const bool runs = out_end >= 0 && err_end >= 0 &&
                    start_program(child, program, ProgramName::kSearched, arguments, out_end, err_end) == 0;
  if (out_end >= 0) ::close(out_end);
  if (err_end >= 0 && err_end != out_end) ::close(err_end);
  return runs;
}

}  // namespace

HelperEnd run_helper(const std::string& program, const std::vector<std::string>& arguments,
                     const std::string& out, const std::string& err,
                     const std::function<bool()>& go_on) {
  pid_t child = 0;
  if (!start(child, program, arguments, out, err)) return {HelperEnd::How::kNotFound, 0};
  int status = 0;
  bool stopped = false;
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, stopped ? 0 : WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) return {HelperEnd::How::kNotFound, 0};
    if (stopped) continue;
    if (!go_on()) {
      ::kill(-child, SIGKILL);
      stopped = true;
    } else {
      std::this_thread::sleep_for(kLook);
    }
  }
  if (stopped) return {HelperEnd::How::kStopped, 0};
  if (!WIFEXITED(status)) return {HelperEnd::How::kSignal, WTERMSIG(status)};
  const int code = WEXITSTATUS(status);
  if (code == kNoInterpreter) return {HelperEnd::How::kNotFound, code};
  return {HelperEnd::How::kExited, code};
}

}  // namespace kinex::lab
