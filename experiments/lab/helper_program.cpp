// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/helper_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

extern char** environ;

namespace kinex::lab {

namespace {

constexpr std::chrono::milliseconds kLook{10};
constexpr int kNoInterpreter = 127;  // a shell's exit code where a program is not found

// 0 if it runs.
int start(pid_t& child, const std::string& program, const std::vector<std::string>& arguments,
          const std::string& out, const std::string& err) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int kAnew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), kAnew, 0600);
  if (out == err) {
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), kAnew, 0600);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t ignored_here;  // what this program ignores (InterruptGuard) is none of the helper's
  sigemptyset(&ignored_here);
  sigaddset(&ignored_here, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &ignored_here);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int failed =
      posix_spawnp(&child, program.c_str(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failed;
}

}  // namespace

HelperEnd run_helper(const std::string& program, const std::vector<std::string>& arguments,
                     const std::string& out, const std::string& err,
                     const std::function<bool()>& go_on) {
  pid_t child = 0;
  if (start(child, program, arguments, out, err) != 0) return {HelperEnd::How::kNotFound, 0};
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
