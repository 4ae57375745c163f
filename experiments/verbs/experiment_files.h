// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the verbs that run experiments (verify, trade, reproduce): their options, the files
// of their results, and the records from which the same command goes on (sweep/journal.h).
#ifndef KINEX_EXPERIMENTS_VERBS_EXPERIMENT_FILES_H
#define KINEX_EXPERIMENTS_VERBS_EXPERIMENT_FILES_H

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/lab/report.h"
#include "experiments/sweep/cell_source.h"
#include "experiments/sweep/experiment.h"
#include "experiments/verbs/interrupt.h"
#include "experiments/verbs/voice.h"

namespace CLI {
class App;
}

namespace kinex::verbs {

struct ExperimentOptions {
  std::string folder = ".";
  std::vector<std::string> from;  // folders of a sweep
  int jobs = 1;
  bool quick = false, force = false, fresh = false, json = false;
  Voice voice;
};
// What --help says of them in one verb.
struct ExperimentWords {
  const char* name;  // of the verb
  const char *quick, *folder, *jobs, *json;
};
void add_experiment_options(CLI::App& verb, ExperimentOptions& options,
                            const ExperimentWords& words);
// Makes the folder that the option names if there is none, and says whether it did. Throws InputError.
bool make_folder(const char* option, const std::string& folder);
// Throws InputError for --jobs out of range, and for --fresh or --jobs beside --from.
void check_jobs(const ExperimentOptions& options);

// A file of results. A resumed run replaces the output of the interrupted one without --force. The
// constructor throws InputError if the file cannot be written.
class ResultFile {
 public:
  ResultFile(std::string path, bool force, sweep::Journal& journal);
  void write(std::string_view text) const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool force_;
  sweep::Journal& journal_;
};

// The records of an experiment: those of a sweep (--from), or its own file NAME.unfinished in the
// folder, which is made.
sweep::Journal experiment_journal(const ExperimentOptions& options, const sweep::Selection& selection);
// The cells of the journal, and others run in children of this program, until an interruption. A note
// says how many (`one`, `many`) it has already. Both must outlive it.
sweep::CellSource experiment_source(const ExperimentOptions& options, sweep::Journal& journal,
                                    const InterruptGuard& interrupt, const char* one,
                                    const char* many);
// Throws InputError if the folder has a figure, NAME.svg or NAME-...svg for one of the names, that is not of the
// interrupted run that goes on. Before anything is run: figures are written last.
void keep_figures(const std::string& folder, const std::vector<std::string>& names,
                  const sweep::Journal& journal);

// The plots of an experiment as files of their own, TITLE.svg, and TITLE-2.svg, .. for more panels of one
// title. A resumed run replaces those of the interrupted one without --force.
class PlotFiles {
 public:
  // A folder that exists; empty: no plots are written. Throws InputError if it has a file of a name that
  // one of these titles would have.
  PlotFiles(std::string folder, bool force, const std::vector<std::string>& titles, sweep::Journal& journal);
  void write(const std::vector<lab::Figure>& figures, const lab::Drawings& drawings) const;

 private:
  std::string folder_;
  bool force_;
  sweep::Journal& journal_;
};
// The files NAME.html, NAME.txt and NAME.sqlite of an experiment. The constructor throws InputError if
// one cannot be written.
class ReportFiles {
 public:
  struct Contents {
    std::string database, table;  // of the files; the table without the verdict
    lab::Report report;           // its verdict is filled in here, when all is done
    lab::PageFacts facts;         // without the time
    std::string lead;             // lines before the verdict
    std::function<std::string(const lab::TimeTaken& taken)> verdict;
    std::string details;          // lines after it
    const PlotFiles* plots = nullptr;  // the plots as files, too; nullptr: not
  };
  ReportFiles(const ExperimentOptions& options, std::string name, sweep::Journal& journal);
  // Draws the figures, writes all files, and prints the verdict.
  void write(Contents contents, const InterruptGuard& interrupt) const;

 private:
  const ExperimentOptions& options_;
  sweep::Journal& journal_;
  ResultFile database_, page_, table_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

// Of this program on this machine.
lab::PageFacts facts_of(std::string command);

}  // namespace kinex::verbs

#endif
