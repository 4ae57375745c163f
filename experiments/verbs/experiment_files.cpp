// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/experiment_files.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/verbs/option_values.h"
#include "experiments/verbs/swept_work.h"

namespace kinex::verbs {

namespace {

constexpr int kMostJobs = 256;

// The name of a file, without ".svg" and the number of a panel.
std::string without_panel(const std::string& name) {
  const std::size_t dash = name.rfind('-');
  const bool numbered = dash != name.npos && dash + 1 < name.size() &&
                        name.find_first_not_of("0123456789", dash + 1) == name.npos;
  return numbered ? name.substr(0, dash) : name;
}

}  // namespace

void add_experiment_options(CLI::App& verb, ExperimentOptions& options,
                            const ExperimentWords& words) {
  verb.add_flag("--quick", options.quick, words.quick);
  verb.add_option("-o,--output", options.folder, words.folder);
  verb.add_flag("--force", options.force, "Replace results that exist, and an unfinished run of another version or command");
  verb.add_flag("--fresh", options.fresh, "Repeat also the finished part of an interrupted run");
  verb.add_option("--jobs", options.jobs, words.jobs);
  verb.add_option("--from", options.from,
                  std::string("Report what a sweep has run (kinex sweep run ") + words.name +
                      " ..), from its folders");
  verb.add_flag("--json", options.json, words.json);
}

bool make_folder(const char* option, const std::string& folder) {
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored)) return made;
  if (std::filesystem::exists(folder, ignored)) {
    throw formats::InputError(option, "", show_text(folder) + " is a file, not a folder", "name a folder");
  }
  throw formats::InputError(option, "", "the folder " + show_text(folder) + " cannot be made: " + error.message(),
                            "name another one");
}

void check_jobs(const ExperimentOptions& options) {
  check_range("--jobs", options.jobs, 1, kMostJobs);
  if (!options.from.empty() && (options.fresh || options.jobs != 1)) {
    throw formats::InputError(options.fresh ? "--fresh" : "--jobs", "",
                              "--from reports on what has been run, and runs nothing",
                              "leave one of the two out");
  }
}

ResultFile::ResultFile(std::string path, bool force, sweep::Journal& journal)
    : path_(std::move(path)), force_(force || journal.is_own_output(path_)), journal_(journal) {
  const formats::OutputFile probe(path_, force_);  // leaves nothing behind when the program is killed
}

void ResultFile::write(std::string_view text) const {
  journal_.note_output(path_, text);
  formats::OutputFile file(path_, force_);
  file.write(text);
  file.commit();
}

sweep::Journal experiment_journal(const ExperimentOptions& options, const sweep::Selection& selection) {
  if (options.folder == "-") {
    throw formats::InputError("--output", "", "standard output takes no folder of files",
                              "name a folder; --json prints the result");
  }
  const bool made = make_folder("--output", options.folder);
  using sweep::Leftover;
  const Leftover leftover = options.fresh   ? Leftover::kDrop
                            : options.force ? Leftover::kKeepOwn
                                            : Leftover::kKeep;
  try {
    return journal_of(options.from, options.folder + "/" + selection.experiment + ".unfinished",
                      selection, leftover);
  } catch (...) {
    std::error_code error;
    if (made)
      std::filesystem::remove(options.folder, error);  // what is refused leaves nothing behind
    throw;
  }
}

sweep::CellSource experiment_source(const ExperimentOptions& options, sweep::Journal& journal,
                                    const InterruptGuard& interrupt, const char* one,
                                    const char* many) {
  if (!journal.dropped_other().empty()) {
    options.voice.note("beginning anew: " + journal.path() + " was begun by " + journal.dropped_other());
  }
  if (journal.runs() && journal.found() > 0) {
    options.voice.note("going on: " + formats::counted(journal.found(), one, many) +
                       (journal.found() == 1 ? " is" : " are") +
                       " finished already; --fresh runs them again");
  }
  return {&journal, kThisProgram, [&interrupt] { return !interrupt.interrupted(); }};
}

void keep_figures(const std::string& folder, const std::vector<std::string>& names,
                  const sweep::Journal& journal) {
  std::set<std::string> taken;
  std::error_code error;  // a folder that cannot be read has no figures
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::filesystem::path& file = entry.path();
    const std::string path = folder + "/" + file.filename().string(), name = file.stem().string();
    if (file.extension() != ".svg" || journal.is_own_output(path)) continue;
    for (const std::string& one : names) {
      if (name == one || name.starts_with(one + "-")) taken.insert(path);
    }
  }
  if (taken.empty()) return;
  throw formats::InputError("--output", *taken.begin(),
                            "exists already, and a figure may have this name",
                            "name another folder, or --force to replace it");
}

PlotFiles::PlotFiles(std::string folder, bool force, const std::vector<std::string>& titles,
                     sweep::Journal& journal)
    : folder_(std::move(folder)), force_(force), journal_(journal) {
  if (folder_.empty() || force_) return;
  std::set<std::string> names, taken;
  for (const std::string& title : titles) names.insert(lab::anchor_of(title));
  std::error_code error;  // a folder that cannot be read has no plots
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".svg") continue;
    const std::string name = file.stem().string();
    if (names.count(name) == 0 && names.count(without_panel(name)) == 0) continue;
    const std::string path = folder_ + "/" + file.filename().string();
    if (!journal_.is_own_output(path)) taken.insert(path);
  }
  if (taken.empty()) return;
  throw formats::InputError("--plots", *taken.begin(), "exists already, and a plot may have this name",
                            "name another folder, or --force to replace it");
}

void PlotFiles::write(const std::vector<lab::Figure>& figures, const lab::Drawings& drawings) const {
  if (folder_.empty()) return;
  std::string last;
  int panel = 0;
  for (std::size_t i = 0; i < figures.size() && i < drawings.svg.size(); ++i) {
    if (drawings.svg[i].empty()) continue;
    const std::string name = lab::anchor_of(figures[i].title);
    panel = name == last ? panel + 1 : 1;
    last = name;
    ResultFile(folder_ + "/" + name + (panel > 1 ? "-" + std::to_string(panel) : "") + ".svg", force_,
               journal_)
        .write(drawings.svg[i]);
  }
}

ReportFiles::ReportFiles(const ExperimentOptions& options, std::string name, sweep::Journal& journal)
    : options_(options),
      journal_(journal),
      database_(options.folder + "/" + name + ".sqlite", options.force, journal),
      page_(options.folder + "/" + name + ".html", options.force, journal),
      table_(options.folder + "/" + name + ".txt", options.force, journal) {}

void ReportFiles::write(Contents contents, const InterruptGuard& interrupt) const {
  lab::Report& report = contents.report;
  database_.write(contents.database);
  const lab::Drawings drawings = lab::draw(report.figures, "gnuplot", interrupt.go_on_a_while());
  if (contents.plots != nullptr) contents.plots->write(report.figures, drawings);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began_;
  contents.facts.taken = {seconds.count(), journal_.found_seconds()};
  report.verdict = contents.verdict(contents.facts.taken);
  page_.write(lab::report_page(report, drawings, contents.facts));
  const std::string verdict = report.verdict + "\n" + contents.details;
  table_.write(contents.table + contents.lead + verdict + "\nMade by " +
               lab::provenance(contents.facts.command, contents.facts.build, contents.facts.machine) + "\n");
  if (!report.interrupted) journal_.remove();
  if (!drawings.problem.empty()) options_.voice.note("no plots: " + drawings.problem);
  if (report.interrupted) {
    options_.voice.note("interrupted: the finished part is written, and the same command resumes");
  }
  const std::string files =
      "page: " + page_.path() + "; table: " + table_.path() + "; database: " + database_.path();
  if (options_.json) {  // its lines stay alone on standard output
    options_.voice.note(verdict + files);
  } else {
    options_.voice.report(contents.lead + verdict + files + "\n");
  }
}

lab::PageFacts facts_of(std::string command) {
  lab::PageFacts facts;
  facts.command = std::move(command);
  facts.build = lab::build_facts();
  facts.machine = lab::machine_facts();
  return facts;
}

}  // namespace kinex::verbs
