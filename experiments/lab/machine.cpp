// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/machine.h"

#include <gsl/gsl_version.h>
#include <mpfr.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string_view>

#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/sha256.h"
#include "kinex_commit.h"  // written by commit.cmake at build time

namespace kinex::lab {

namespace {

std::string machine_text(const MachineFacts& machine) {
  return machine.cpu + ", " + std::to_string(machine.cores) +
         (machine.cores == 1 ? " core, " : " cores, ") +
         std::to_string(machine.memory_kb / 1000000) + " GB";
}

// In quotes where a shell would read something else.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

BuildFacts build_facts() {
  BuildFacts facts;
  facts.program = formats::build_name();
  facts.commit = KINEX_COMMIT;
  facts.dirty = KINEX_DIRTY != 0;
#ifdef __clang__
  facts.compiler = __VERSION__;
#else
  facts.compiler = "GCC " __VERSION__;
#endif
  facts.flags = KINEX_FLAGS;
  facts.libraries = std::string("GMP ") + gmp_version + ", MPFR " + mpfr_get_version() + ", GSL " +
                    GSL_VERSION + ", SQLite " + sqlite3_libversion();
  return facts;
}

std::string program_identity() {
  const BuildFacts facts = build_facts();
  if (!facts.dirty && facts.commit != "unknown") return facts.commit;
  return facts.commit + " " + formats::sha256_hex(formats::read_text_file("/proc/self/exe"));
}

MachineFacts machine_facts() {
  MachineFacts facts;
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) != 0 || colon == std::string::npos) continue;
    facts.cpu = line.substr(colon + 2);
    break;
  }
  facts.cores = sysconf(_SC_NPROCESSORS_ONLN);
  facts.memory_kb = sysconf(_SC_PHYS_PAGES) * (sysconf(_SC_PAGESIZE) / 1024);
  utsname system;
  if (uname(&system) == 0) {
    facts.kernel = std::string(system.sysname) + " " + system.release + " " + system.machine;
    if (facts.cpu.empty()) facts.cpu = system.machine;
  }
  return facts;
}

std::string commit_text(const BuildFacts& build) {
  return build.commit + (build.dirty ? " with changes that are not committed" : "");
}

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string words{std::istreambuf_iterator<char>(file), {}};
  std::string line = "kinex";
  // After the program's own name, every word ends with a zero.
  for (std::size_t at = words.find('\0'); at != std::string::npos && at + 1 < words.size();) {
    const std::size_t end = words.find('\0', at + 1);
    line += " " + shell_word(words.substr(at + 1, end - at - 1));
    at = end;
  }
  return line;
}

formats::Provenance run_provenance() {
  const BuildFacts build = build_facts();
  return {build.commit,    build.dirty,         build.compiler, build.flags,
          build.libraries, machine_facts().cpu, command_line()};
}

std::string version_text() {
  const BuildFacts build = build_facts();
  const MachineFacts machine = machine_facts();
  return build.program + "\ncommit     " + commit_text(build) + "\ncompiler   " + build.compiler +
         "\nflags      " + build.flags + "\nlibraries  " + build.libraries + "\nprocessor  " +
         machine_text(machine);
}

std::string provenance(const std::string& command, const BuildFacts& build,
                       const MachineFacts& machine) {
  return "`" + command + "`, " + build.program + " at " + commit_text(build) + ", " +
         build.compiler + ", flags `" + build.flags + "`; " + machine_text(machine);
}

}  // namespace kinex::lab
