// SPDX-License-Identifier: GPL-3.0-or-later
// PaperPart: a figure or a section of a paper, as the program reproduces it.
#ifndef KINEX_EXPERIMENTS_LAB_PART_H
#define KINEX_EXPERIMENTS_LAB_PART_H

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/claim.h"
#include "experiments/lab/gnuplot.h"
#include "experiments/lab/judge.h"
#include "experiments/lab/series.h"

namespace kinex::lab {

// The results of a part.
struct PartReport {
  std::vector<PaperClaim> claims;
  std::vector<Figure> figures;
  std::vector<std::string> figure_names;  // of the SVG files, without ".svg"
  std::string tables;                     // Markdown
};

struct PaperPart {
  std::string_view name;  // "figure-3"
  std::string_view summary;
  int place;  // among the parts of its paper, which may be of several families
  std::vector<SeriesPoint> (*points)(bool quick);
  // `results`: of all points of this part, in order; fewer after an interruption. `command`
  // reproduces it. nullptr for a part without runs.
  PartReport (*report)(const std::vector<SeriesResult>& results, const std::string& command);
  // For a part without runs; it stops when `go_on` returns false.
  StudyResult (*study)(bool quick, const std::function<bool()>& go_on) = nullptr;
  PartReport (*study_report)(const StudyResult& result, const std::string& command) = nullptr;
};

struct Paper {
  std::string_view name;   // "kds-report-1998"
  std::string_view title;  // with authors and year
  std::vector<PaperPart> parts;
};

}  // namespace kinex::lab

#endif
