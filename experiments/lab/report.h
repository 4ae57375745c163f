// SPDX-License-Identifier: GPL-3.0-or-later
// Report: what an experiment found, for its page: a verdict, sections, figures. An experiment says
// what its tables and figures hold; how they are shown is decided here, once for all of them.
#ifndef KINEX_EXPERIMENTS_LAB_REPORT_H
#define KINEX_EXPERIMENTS_LAB_REPORT_H

#include <string>
#include <vector>

#include "experiments/lab/gnuplot.h"
#include "experiments/lab/html_page.h"
#include "experiments/lab/machine.h"
#include "experiments/lab/time_taken.h"

namespace kinex::lab {

struct PageFacts {
  std::string command;  // the command that reproduces the page
  TimeTaken taken;
  BuildFacts build;
  MachineFacts machine;
};

struct Report {
  std::string title;      // "kinex verify"
  std::string verdict;    // one line
  bool good = false;      // of the verdict's colour
  bool interrupted = false;
  Html lead;              // below the verdict
  std::string question;   // what was asked, and how it was answered
  std::vector<HtmlSection> before, after;  // .. the plots
  std::vector<Figure> figures;
};

// The page, self-contained. `drawings`: of report.figures, in their order; if some are missing the
// page gives the reason.
std::string report_page(const Report& report, const Drawings& drawings, const PageFacts& facts);

// ---- parts of sections

// How a run is made again: `scene` says which, and the commit is added; `commands`: a line each.
Html origin_part(const std::string& scene, const PageFacts& facts);
Html commands_part(const std::string& commands);
// A sentence in small print.
Html note_part(const std::string& text);

}  // namespace kinex::lab

#endif
