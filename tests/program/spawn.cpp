// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/program/spawn.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/places.h"

namespace kinex {

namespace {

void redirect(const std::string& path, int flags, int target) {
  const int file = ::open(path.c_str(), flags, 0600);
  if (file < 0 || ::dup2(file, target) < 0) ::_exit(126);
  ::close(file);
}

// Until something is in the file, for two minutes at most.
void wait_for(const std::string& file) {
  for (int i = 0; i < 6000; ++i) {
    std::error_code absent;
    const auto size = std::filesystem::file_size(file, absent);
    if (!absent && size > 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

namespace {

// `watch`: called in the parent while the child runs.
Finished run_and_watch(const std::vector<std::string>& arguments, const std::string& input,
                       const std::string& output, const std::function<void(pid_t)>& watch) {
  const ScratchFolder scratch;
  write_file(scratch.file("in"), input);
  std::vector<char*> argv{const_cast<char*>(KINEX_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);  // a shell's job in the background has it ignored
    redirect(scratch.file("in"), O_RDONLY, STDIN_FILENO);
    redirect(output.empty() ? scratch.file("out") : output, O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(scratch.file("err"), O_WRONLY | O_CREAT, STDERR_FILENO);
    ::execv(KINEX_PROGRAM, argv.data());
    ::_exit(127);
  }
  if (watch) watch(child);
  int status = 0;
  ::waitpid(child, &status, 0);
  Finished finished;
  finished.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  finished.out = read_file(scratch.file("out"));
  finished.err = read_file(scratch.file("err"));
  return finished;
}

}  // namespace

Finished run_kinex(const std::vector<std::string>& arguments, const std::string& input,
                   const std::string& output, const std::string& signal_when_begun, int signal) {
  if (signal_when_begun.empty()) return run_and_watch(arguments, input, output, nullptr);
  return run_and_watch(arguments, input, output, [&](pid_t child) {
    wait_for(signal_when_begun + ".partial-" + std::to_string(child));
    ::kill(child, signal);
  });
}

Finished run_kinex_until(const std::vector<std::string>& arguments, const std::string& file,
                         int lines, int signal) {
  return run_and_watch(arguments, "", "", [&](pid_t child) {
    for (int i = 0; i < 120000; ++i) {
      const std::string text = read_file(file);
      if (std::count(text.begin(), text.end(), '\n') >= lines) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(child, signal);
  });
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "kinex-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace kinex
