// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a command line, and what to write instead.
#ifndef KINEX_EXPERIMENTS_VERBS_USAGE_ERROR_H
#define KINEX_EXPERIMENTS_VERBS_USAGE_ERROR_H

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace kinex::verbs {

// The verb, or the verb of a verb, that a command line has named; the program itself if none.
const CLI::App& innermost(const CLI::App& app);

// The message for a command line that could not be parsed: the verb or option, the problem, a remedy;
// for an unknown verb or option also the names that are near.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace kinex::verbs

#endif
