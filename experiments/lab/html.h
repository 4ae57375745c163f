// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of all pages of results: the head with its style, escaping, figures, and a foot that states
// how the page was made. Pages are self-contained: no scripts, no files, no network.
#ifndef KINEX_EXPERIMENTS_LAB_HTML_H
#define KINEX_EXPERIMENTS_LAB_HTML_H

#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/gnuplot.h"
#include "experiments/lab/machine.h"

namespace kinex::lab {

struct PageFacts {
  std::string command;  // the command that reproduces the page
  double seconds = 0;   // wall-clock time of the whole command
  BuildFacts build;
  MachineFacts machine;
};

// From the doctype to the heading.
std::string html_head(const std::string& title);
// Escapes text for HTML; "+-" becomes one character.
std::string escape(std::string_view text);
// A heading and the pictures, embedded, or the reason why there are none.
std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings);
// Command, build, machine.
std::string facts_part(const PageFacts& facts);

}  // namespace kinex::lab

#endif
