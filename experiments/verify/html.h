// SPDX-License-Identifier: GPL-3.0-or-later
// What all pages of results share: the head with its style, escaping, figures, and a foot that says
// how the page was made. A page needs nothing else: no scripts, no files, no network.
#ifndef KINEX_EXPERIMENTS_VERIFY_HTML_H
#define KINEX_EXPERIMENTS_VERIFY_HTML_H

#include <string>
#include <string_view>
#include <vector>

#include "experiments/verify/gnuplot.h"
#include "experiments/verify/machine.h"

namespace kinex {

struct PageFacts {
  std::string command;  // how to get it again
  double seconds = 0;   // all of it, wall clock
  BuildFacts build;
  MachineFacts machine;
};

// From the doctype to the heading.
std::string html_head(const std::string& title);
// Text as HTML; "+-" becomes one character.
std::string escape(std::string_view text);
// A heading and the pictures inside the page, or why there are none.
std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings);
// Command, build, machine.
std::string facts_part(const PageFacts& facts);

}  // namespace kinex

#endif
