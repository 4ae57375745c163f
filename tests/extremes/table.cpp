// SPDX-License-Identifier: GPL-3.0-or-later
// kinex_extremes: which extreme breaks which arithmetic, and how.
//   kinex_extremes                     the table as Markdown
//   kinex_extremes --check FILE        exit code 1 if FILE is something else
// Exit code 1 also if a run does not end.
#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/formats/file_io.h"
#include "tests/extremes/extreme.h"
#include "tests/extremes/verdict.h"

namespace kinex::extremes {
namespace {

constexpr std::array<const char*, 8> kArithmetics{"double",  "gsl",      "mpfr:24",  "mpfr:53",
                                                  "mpfr:64", "mpfr:100", "mpfr:200", "mpfr:400"};

constexpr const char* kHead =
    "# Extremes: what breaks which arithmetic\n"
    "\n"
    "Made by `kinex_extremes` (tests/extremes). The test `extremes.table` makes it again and compares, so "
    "it is never\nolder than the code. The scenes and what is known about them: "
    "`tests/corpus/extremes/index.json`. `exact` and\n`sturm` are right in all of them (tested). Each run of "
    "the others is compared with the exact one, event by event:\n"
    "\n"
    "- **right**: the same events in the same order, and the same structure at the end\n"
    "- **order**: the same events in another order; simultaneous ones in any order but that of ids "
    "count here\n"
    "- **wrong**: silently wrong: events missed or invented, or another structure at the end (these runs have "
    "no\n  audits; that at the end of `kinex run` finds a wrong structure)\n"
    "- **corrupt**: the numbers contradict each other, and the structure has noticed it\n"
    "- **endless**: more than a million events, and 20 times as many as there are; there is none, "
    "and none that "
    "crashes\n\nLeft out are scenes of more than 250 objects, and those that the index says take "
    "too long here: they end too in `double` and `gsl` (test `SlowExtremes`).\n\n";

using Row = std::array<RunVerdict, kArithmetics.size()>;

std::string heading(const std::string& first) {
  std::string line = "| " + first + " |", rule = "| --- |";
  for (const char* arithmetic : kArithmetics) {
    line += std::string(" ") + arithmetic + " |";
    rule += " --- |";
  }
  return line + "\n" + rule + "\n";
}

std::string group_of(const std::string& name) { return name.substr(0, name.find('/')); }

// How many of a group come to each verdict.
std::string summary(const std::vector<std::pair<std::string, Row>>& rows) {
  std::vector<std::string> groups;
  std::map<std::string, std::array<std::array<int, kVerdicts>, kArithmetics.size()>> counts;
  for (const auto& [name, row] : rows) {
    const std::string group = group_of(name);
    if (counts.count(group) == 0) groups.push_back(group);
    for (std::size_t a = 0; a < row.size(); ++a) {
      ++counts[group][a][static_cast<std::size_t>(row[a])];
    }
  }
  std::string text = heading("group");
  for (const std::string& group : groups) {
    text += "| " + group + " |";
    for (const auto& verdicts : counts[group]) {
      std::string cell;
      for (std::size_t v = 0; v < verdicts.size(); ++v) {
        if (verdicts[v] == 0) continue;
        cell += (cell.empty() ? " " : ", ") + std::to_string(verdicts[v]) + " " +
                verdict_name(static_cast<RunVerdict>(v));
      }
      text += cell + " |";
    }
    text += "\n";
  }
  return text;
}

int print_table(const std::string& check) {
  std::vector<std::pair<std::string, Row>> rows;
  bool endless = false;
  for (const Extreme& extreme : read_extremes()) {
    const Scene scene = extreme.scene();
    if (!extreme.page || scene.objects.size() > kMostPageObjects) continue;
    const LoggedRun exact = run_logged(scene, "exact", 0);
    Row row{};
    for (std::size_t a = 0; a < kArithmetics.size(); ++a) {
      row[a] = judge(scene, exact, kArithmetics[a]);
      endless = endless || row[a] == RunVerdict::kEndless;
    }
    rows.emplace_back(extreme.name, row);
  }
  std::string text = kHead + summary(rows) + "\n" + heading("extreme");
  for (const auto& [name, row] : rows) {
    text += "| " + name + " |";
    for (const RunVerdict verdict : row) text += " " + verdict_name(verdict) + " |";
    text += "\n";
  }
  if (check.empty()) {
    std::fputs(text.c_str(), stdout);
    return endless ? 1 : 0;
  }
  std::istringstream ours(text), theirs(formats::read_text_file(check));
  bool equal = true;
  for (std::string a, b;;) {
    const bool more_a = static_cast<bool>(std::getline(ours, a));
    const bool more_b = static_cast<bool>(std::getline(theirs, b));
    if (!more_a && !more_b) break;
    if (more_a && more_b && a == b) continue;
    equal = false;
    if (more_b) std::printf("- %s\n", b.c_str());
    if (more_a) std::printf("+ %s\n", a.c_str());
  }
  if (!equal) std::printf("%s is not what kinex_extremes prints\n", check.c_str());
  return equal && !endless ? 0 : 1;
}

}  // namespace
}  // namespace kinex::extremes

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool checks = arguments.size() == 2 && arguments[0] == "--check";
  if (!arguments.empty() && !checks) {
    std::fputs("kinex_extremes: write nothing, or --check FILE\n", stderr);
    return 2;
  }
  try {
    return kinex::extremes::print_table(checks ? arguments[1] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kinex_extremes: %s\n", error.what());
    return 2;
  }
}
