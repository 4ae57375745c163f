// SPDX-License-Identifier: GPL-3.0-or-later
// How the program prints its help: as CLI11 does, with lines of 80 columns at most.
#ifndef KINEX_EXPERIMENTS_VERBS_HELP_FORMAT_H
#define KINEX_EXPERIMENTS_VERBS_HELP_FORMAT_H

namespace CLI {
class App;
}

namespace kinex::verbs {

// Before the verbs are added: they take it from the program.
void set_help_format(CLI::App& app);

}  // namespace kinex::verbs

#endif
