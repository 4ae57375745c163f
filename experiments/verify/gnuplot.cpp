// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verify/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

extern char** environ;

namespace kinex {

namespace fs = std::filesystem;

namespace {

constexpr Look kLooks[] = {{"#0072B2", 7},  {"#D55E00", 5},  {"#009E73", 9},
                           {"#CC79A7", 13}, {"#E69F00", 11}, {"#56B4E9", 15}};

// A folder of its own under the system's temporary one; removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    fs::path base = fs::temp_directory_path(error);
    if (error) base = "/tmp";
    std::string name = (base / "kinex-plots-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Without a shell. Output and messages go to `log`. The exit code, or -1 if it could not be
// started.
int run(const std::string& program, const std::string& argument, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  std::string name = program, first = argument;
  char* arguments[] = {name.data(), first.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -2;
}

}  // namespace

Drawings draw(const std::vector<Figure>& figures, const std::string& program) {
  Drawings drawings;
  drawings.svg.resize(figures.size());
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    drawings.problem = "no temporary folder could be made";
    return drawings;
  }
  std::ofstream script(folder.path() / "plots.gp");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    // The folder's name is safe inside quotes: it comes from mkdtemp.
    script << "reset\nset encoding utf8\nset terminal svg size " << figures[i].width << ","
           << figures[i].height << " dynamic enhanced font 'Helvetica,13' background 'white'\n"
           << "set output '" << (folder.path() / std::to_string(i)).string() << ".svg'\n"
           << figures[i].script << "\nunset output\n";
  }
  script.close();
  const int code =
      run(program, (folder.path() / "plots.gp").string(), (folder.path() / "log").string());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string svg = read(folder.path() / (std::to_string(i) + ".svg"));
    if (svg.find("</svg>") != std::string::npos) drawings.svg[i] = svg;
  }
  if (code == -1 || code == 127) {
    drawings.problem = program + " is not installed";
  } else if (code != 0) {
    drawings.problem = program + " failed: " + read(folder.path() / "log").substr(0, 300);
  }
  return drawings;
}

const Look& look(std::size_t i) { return kLooks[i % std::size(kLooks)]; }

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '_' || c == '^' || c == '{' || c == '}' || c == '@' || c == '&') {
      if (c == '\'') {
        result += "''";
        continue;
      }
      result += '\\';
    }
    result += c;
  }
  return result + "'";
}

}  // namespace kinex
