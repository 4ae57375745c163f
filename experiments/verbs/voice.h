// SPDX-License-Identifier: GPL-3.0-or-later
// Voice: how much a command says, and in which colours: -q, -v and --color.
//
//   results   what was asked for (a scene, --json, -o -): standard output, always (print)
//   reports   what a command says for people: standard output, not with -q
//   notes     what it says on the side: standard error, not with -q
//   details   what only -v says: standard error
//   errors    standard error, always
//
// Every verb says in its help what its -q leaves out and what its -v says more (add_voice).
#ifndef KINEX_EXPERIMENTS_VERBS_VOICE_H
#define KINEX_EXPERIMENTS_VERBS_VOICE_H

#include <string>

namespace CLI {
class App;
}

namespace kinex::verbs {

struct Voice {
  bool quiet = false;
  bool verbose = false;
  bool colour_out = false, colour_err = false;

  void report(const std::string& text) const;
  // "kinex: TEXT", a line.
  void note(const std::string& text) const;
  void detail(const std::string& text) const;
  void error(const std::string& text) const;
  // As a heading on standard output.
  std::string heading(const std::string& text) const;
};

// Gives a verb -q and -v; their lines of help.
void add_voice(CLI::App& verb, const std::string& quiet, const std::string& verbose);
// Gives the program and all its verbs --color, and -q and -v where they have none of their own. To be
// called when all verbs are there.
void add_voice_options(CLI::App& app);
// That of a verb's command line, once it has been parsed. Colours go to terminals only, and not where
// the environment has NO_COLOR; --color always and --color never decide otherwise.
Voice voice_of(const CLI::App& verb);

}  // namespace kinex::verbs

#endif
