// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/gnuplot.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "experiments/lab/helper_program.h"
#include "experiments/lab/temporary_folder.h"

namespace kinex::lab {

namespace fs = std::filesystem;

namespace {

constexpr Look kLooks[] = {{"#0072B2", 7},  {"#D55E00", 5},  {"#009E73", 9},
                           {"#CC79A7", 13}, {"#E69F00", 11}, {"#56B4E9", 15}};

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

Drawings draw(const std::vector<Figure>& figures, const std::string& program,
              const std::function<bool()>& go_on) {
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
  const std::string log = (folder.path() / "log").string();
  const HelperEnd end =
      run_helper(program, {(folder.path() / "plots.gp").string()}, log, log, go_on);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string svg = read(folder.path() / (std::to_string(i) + ".svg"));
    if (svg.find("</svg>") != std::string::npos) drawings.svg[i] = svg;
  }
  if (end.how == HelperEnd::How::kNotFound) {
    drawings.problem = program + " is not installed";
  } else if (end.how == HelperEnd::How::kStopped) {
    drawings.problem = "interrupted";
  } else if (end.how == HelperEnd::How::kSignal || end.code != 0) {
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

}  // namespace kinex::lab
