// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the built program and collects its exit code and outputs; folders and files for tests.
#ifndef KINEX_TESTS_PROGRAM_SPAWN_H
#define KINEX_TESTS_PROGRAM_SPAWN_H

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace kinex {

struct Finished {
  int exit_code = -1;  // the negated signal number if a signal ended it
  std::string out, err;
};

// Runs `kinex` with these arguments and `input` as standard input. If `output` is given, standard
// output goes to that file and `out` is empty. If `signal_when_begun` is given, an output file of
// the program, `signal` is sent to it when the temporary version of that file is not empty (after
// two minutes in any case).
Finished run_kinex(const std::vector<std::string>& arguments, const std::string& input = "",
                   const std::string& output = "", const std::string& signal_when_begun = "",
                   int signal = SIGINT);

// Runs `kinex` with these arguments; `signal` is sent to it as soon as `file` has this many
// complete lines.
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
// The whole file; "" if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace kinex

#endif
