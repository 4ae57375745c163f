// SPDX-License-Identifier: GPL-3.0-or-later
// The build and the machine that made a result.
#ifndef KINEX_EXPERIMENTS_LAB_MACHINE_H
#define KINEX_EXPERIMENTS_LAB_MACHINE_H

#include <cstdint>
#include <string>

#include "experiments/formats/provenance.h"

namespace kinex::lab {

struct BuildFacts {
  std::string program;  // name and version
  std::string commit;   // of the sources; "unknown" outside of a repository
  bool dirty = false;   // the sources had uncommitted changes
  std::string compiler;
  std::string flags;
  std::string libraries;  // names and versions
};

struct MachineFacts {
  std::string cpu;
  std::int64_t cores = 0;
  std::int64_t memory_kb = 0;
  std::string kernel;
};

BuildFacts build_facts();
// Identifies the program for results that must not be mixed: the commit, with a digest of the
// program if the commit does not determine it (changed sources, or outside a repository).
std::string program_identity();
MachineFacts machine_facts();

// "34be52d..", or "34be52d.. with changes that are not committed".
std::string commit_text(const BuildFacts& build);
// The command of this process as a shell would read it: "kinex run 'a scene.json'".
std::string command_line();
// Of a result of this process.
formats::Provenance run_provenance();
// What --version prints: name and version in the first line, then the build and the processor.
std::string version_text();
// For documents, in Markdown: "`COMMAND`, kinex 0.1.0 at COMMIT, GCC 12.2.0, flags `..`; CPU, 2
// cores, 24 GB".
std::string provenance(const std::string& command, const BuildFacts& build,
                       const MachineFacts& machine);

}  // namespace kinex::lab

#endif
