// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of all pages of results (html_page.h): escaping, figures, and how the page was made.
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

// Escapes text for HTML; "+-" becomes one character.
std::string escape(std::string_view text);
// The pictures, embedded, and the reason why some are missing; empty if there are none to draw.
std::string plots_part(const std::vector<Figure>& figures, const Drawings& drawings);
// Command, build, machine.
std::string facts_part(const PageFacts& facts);

}  // namespace kinex::lab

#endif
