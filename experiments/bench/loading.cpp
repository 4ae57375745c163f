// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how fast is a scene read, and how much longer does that take than a plain parse of its
//   bytes?
// Workload: points with linear motions (an id and four numbers per object), and scenes full of new
//   plans (as recorded ten times a second: six numbers per plan).
//   plain    rapidjson alone, to a handler that takes everything and keeps nothing
//   tree     parse_json: the same text as a tree, checked (UTF-8, names, depth)
//   scene    parse_scene: as an exact Scene, whose seams are checked
// Ratio: time over that of `plain`. Rounds are interleaved; the best of each counts; thread CPU
//   time. GMP's memory is the program's.
// Output: see result_table.h; options: see bench_options.h.
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/formats/json_document.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/bench_row.h"
#include "experiments/lab/bench_run.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/result_table.h"

namespace {

using namespace kinex;

// Keeps nothing. Public names are rapidjson's.
struct Nothing : rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Nothing> {
  bool Default() { return true; }
};

void parse_plainly(const std::string& text) {
  constexpr unsigned kFlags = rapidjson::kParseNumbersAsStringsFlag;
  rapidjson::MemoryStream stream(text.data(), text.size());
  Nothing nothing;
  rapidjson::Reader reader;
  if (reader.Parse<kFlags>(stream, nothing).IsError()) throw std::logic_error("loading: no JSON");
}

// CPU time of work whose result is destroyed after the clock has stopped.
template <class Work>
lab::BenchRun time_of(const Work& work) {
  const double begin = lab::cpu_seconds();
  const auto result = work();
  const double end = lab::cpu_seconds();
  static_cast<void>(result);
  return {.seconds = end - begin};
}

void add_rows(const lab::BenchRow& row, lab::ResultTable& table) {
  const Scene scene = lab::scene_of(row);
  const std::string text = formats::write_scene(scene), name(row.workload);
  std::size_t plans = 0;
  for (const SceneObject& object : scene.objects) plans += object.motion.pieces.size();
  const std::vector<lab::BenchRun> best = lab::best_of_rounds(
      {[&] { return time_of([&] { return (parse_plainly(text), 0); }); },
       [&] { return time_of([&] { return formats::parse_json(text, name); }); },
       [&] { return time_of([&] { return formats::parse_scene(text, name); }); }},
      {.count = row.rounds});
  if (formats::scene_hash(formats::parse_scene(text, name)) != formats::scene_hash(scene)) {
    throw std::logic_error("loading: the scene that was read is another");
  }
  const char* const names[] = {"plain", "tree", "scene"};
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double megabytes = static_cast<double>(text.size()) / 1e6, seconds = best[i].seconds;
    table.row({name, names[i], row.parameters.n, plans, megabytes, seconds, megabytes / seconds,
               seconds / best[0].seconds});
  }
}

void loading(const lab::BenchOptions& options) {
  lab::install_gmp_memory();
  lab::ResultTable table(
      options, "loading",
      "Scenes as they are read: CPU time, and time over that of a plain parse by rapidjson.",
      {{"workload", lab::ResultTable::kText, 14},
       {"read_as", lab::ResultTable::kText, 7},
       {"objects", 0, 7},
       {"plans", 0, 7},
       {"megabytes", 1},
       {"seconds", 4},
       {"megabytes_per_second", 0},
       {"time_over_plain", 2}});
  for (const lab::BenchRow& row : lab::bench_rows("loading", options)) add_rows(row, table);
}

}  // namespace

int main(int argc, char** argv) { return kinex::lab::bench_main(argc, argv, loading); }
