// SPDX-License-Identifier: GPL-3.0-or-later
// Completion scripts: the tree of verbs and options as programs for bash, zsh and fish.
//
// The scripts need nothing but the shell (bash: not even the package bash-completion). They offer
// verbs, the options of a verb with their texts, names that the program knows (structures,
// workloads, papers, arithmetics, ..), and files where a file is expected.
#ifndef KINEX_EXPERIMENTS_VERBS_COMPLETION_SCRIPTS_H
#define KINEX_EXPERIMENTS_VERBS_COMPLETION_SCRIPTS_H

#include <string>

#include "experiments/verbs/command_tree.h"

namespace kinex::verbs {

std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

}  // namespace kinex::verbs

#endif
