// SPDX-License-Identifier: GPL-3.0-or-later
// Question: what do collision libraries answer where the exact answer is known, what do they
//   certify, and at what cost, compared with kinex?
// Workload: two convex polygons in motions that the libraries can express.
// Output: tables as text; --json and --markdown as for the benchmarks; pictures into the folder of
//   --plots. --quick: a few queries only.
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/lab/machine.h"
#include "experiments/peers/tables.h"

namespace {

using namespace kinex;
using namespace kinex::peers;

struct Options {
  lab::BenchOptions bench;
  std::string plots;
};

std::optional<Options> read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const bool more = i + 1 < argc;
    if (argument == "--json" && more) {
      options.bench.json = argv[++i];
    } else if (argument == "--markdown" && more) {
      options.bench.markdown = argv[++i];
    } else if (argument == "--plots" && more) {
      options.plots = argv[++i];
    } else if (argument == "--quick") {
      options.bench.smoke = true;
    } else {
      std::fprintf(stderr, "usage: %s [--json FILE] [--markdown FILE] [--plots FOLDER] [--quick]\n",
                   argv[0]);
      return std::nullopt;
    }
  }
  return options;
}

// The first line of the markdown (experiments/packaging/stale-pages reads it).
void write_origin(const Options& options) {
  if (options.bench.markdown.empty()) return;
  const std::string command =
      std::string("sh experiments/peers/run --markdown FILE") + (options.bench.smoke ? " --quick" : "");
  std::ofstream(options.bench.markdown, std::ios::app)
      << "Made by " << lab::provenance(command, lab::build_facts(), lab::machine_facts())
      << ". One core; CPU time.\n";
}

void write_plots(const Options& options, const std::vector<lab::Figure>& figures) {
  const lab::Drawings drawings = lab::draw(figures);
  if (!drawings.problem.empty()) std::fprintf(stderr, "%s\n", drawings.problem.c_str());
  std::ofstream markdown;
  if (!options.bench.markdown.empty()) markdown.open(options.bench.markdown, std::ios::app);
  for (std::size_t i = 0; i < figures.size() && i < drawings.svg.size(); ++i) {
    if (drawings.svg[i].empty()) continue;
    const std::string name = "peers-" + std::to_string(i + 1) + ".svg";
    std::ofstream(options.plots + "/" + name) << drawings.svg[i];
    markdown << "\n![" << figures[i].title << "](" << name << ")\n\n" << figures[i].caption << "\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = read_options(argc, argv);
  if (!options) return 2;
  try {
    write_origin(*options);
    PeerQuestions questions;
    answer_tables(options->bench, questions);
    distance_table(options->bench);
    cost_table(options->bench, questions);
    std::vector<lab::Figure> figures = sample_tables(options->bench, questions);
    for (lab::Figure& figure : crossover_tables(options->bench, questions)) {
      figures.push_back(std::move(figure));
    }
    if (!options->plots.empty()) write_plots(*options, figures);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kinex_peers: %s\n", error.what());
    return 1;
  }
  return 0;
}
