// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the built program and keeps what it printed.
#ifndef KINEX_TESTS_PROGRAM_SPAWN_H
#define KINEX_TESTS_PROGRAM_SPAWN_H

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace kinex {

struct Finished {
  int exit_code = -1;  // -signal if it was killed
  std::string out, err;
};

// Runs `kinex` with these arguments and `input` as standard input. What it prints goes to `output`
// if that is given, and is not kept. With `signal_when_begun`, a file that it writes, it gets
// `signal` as soon as something of that file is written.
Finished run_kinex(const std::vector<std::string>& arguments, const std::string& input = "",
                   const std::string& output = "", const std::string& signal_when_begun = "",
                   int signal = SIGINT);

// Runs `kinex` with these arguments; it gets `signal` as soon as `file` has so many whole lines.
Finished run_kinex_until(const std::vector<std::string>& arguments, const std::string& file,
                         int lines, int signal);

// A fresh folder that is removed at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void write_file(const std::string& path, const std::string& text);
std::string read_file(const std::string& path);

}  // namespace kinex

#endif
