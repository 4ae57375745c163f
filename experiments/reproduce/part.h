// SPDX-License-Identifier: GPL-3.0-or-later
// PaperPart: a figure or a section of a paper that the program reproduces.
#ifndef KINEX_EXPERIMENTS_REPRODUCE_PART_H
#define KINEX_EXPERIMENTS_REPRODUCE_PART_H

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/reproduce/claim.h"
#include "experiments/reproduce/series.h"
#include "experiments/verify/gnuplot.h"

namespace kinex {

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
  std::vector<SeriesPoint> (*points)(bool quick);
  // `results`: of all points of this part, in order; fewer after an interruption. `command`
  // reproduces it. nullptr for a part without runs.
  PartReport (*report)(const std::vector<SeriesResult>& results, const std::string& command);
  // Of such a part: it works until `go_on` returns false.
  PartReport (*study)(const std::string& command, const std::function<bool()>& go_on) = nullptr;
};

struct Paper {
  std::string_view name;   // "kds-report-1998"
  std::string_view title;  // with authors and year
  std::vector<PaperPart> parts;
};

const std::vector<Paper>& papers();

// kds_figure_3.cpp
std::vector<SeriesPoint> kds_figure_3_points(bool quick);
PartReport kds_figure_3_report(const std::vector<SeriesResult>& results,
                               const std::string& command);
// kds_large_runs.cpp
std::vector<SeriesPoint> kds_large_runs_points(bool quick);
PartReport kds_large_runs_report(const std::vector<SeriesResult>& results,
                                 const std::string& command);
// kds_section_9.cpp
std::vector<SeriesPoint> kds_section_9_points(bool quick);
PartReport kds_section_9_report(const std::vector<SeriesResult>& results,
                                const std::string& command);

// separation_translation.cpp
std::vector<SeriesPoint> separation_translation_points(bool quick);
PartReport separation_translation_report(const std::vector<SeriesResult>& results,
                                         const std::string& command);
// separation_rigid.cpp
std::vector<SeriesPoint> separation_rigid_points(bool quick);
PartReport separation_rigid_report(const std::vector<SeriesResult>& results,
                                   const std::string& command);
std::vector<SeriesPoint> separation_features_points(bool quick);
PartReport separation_features_report(const std::vector<SeriesResult>& results,
                                      const std::string& command);
// separation_far.cpp
std::vector<SeriesPoint> separation_hysteresis_points(bool quick);
PartReport separation_hysteresis_report(const std::vector<SeriesResult>& results,
                                        const std::string& command);
std::vector<SeriesPoint> separation_hierarchies_points(bool quick);
PartReport separation_hierarchies_study(const std::string& command,
                                        const std::function<bool()>& go_on);

}  // namespace kinex

#endif
