// SPDX-License-Identifier: GPL-3.0-or-later
// What made a result: the build and the machine.
#ifndef KINEX_EXPERIMENTS_VERIFY_MACHINE_H
#define KINEX_EXPERIMENTS_VERIFY_MACHINE_H

#include <cstdint>
#include <string>

namespace kinex {

struct BuildFacts {
  std::string program;  // name and version
  std::string commit;   // of the sources; "unknown" outside of a repository
  bool dirty = false;   // with changes that are not committed
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
MachineFacts machine_facts();

}  // namespace kinex

#endif
