// SPDX-License-Identifier: GPL-3.0-or-later
// Question: how fast is a scene read, and how much longer does that take than a plain parse of its
//   bytes?
// Workload: points with linear motions (uniform-square: an id and four numbers per object), and
//   scenes full of new plans (walks, as recorded ten times a second: six numbers per plan).
//   plain    rapidjson alone, to a handler that takes everything and keeps nothing
//   tree     parse_json: the same text as a tree, checked (UTF-8, names, depth)
//   scene    parse_scene: as an exact Scene, whose seams are checked
// Ratio: time over that of `plain`. Rounds are interleaved; the best of each counts; thread CPU
//   time. GMP's memory is the program's.
// Output: see result_table.h; options: see options.h.
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/bench/options.h"
#include "experiments/bench/result_table.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/cpu_clock.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/workload.h"

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
double seconds_of(const Work& work) {
  const double begin = lab::cpu_seconds();
  const auto result = work();
  const double end = lab::cpu_seconds();
  static_cast<void>(result);
  return end - begin;
}

void load(const char* workload, int n, int m, int rounds, ResultTable& table) {
  lab::WorkloadParameters parameters;
  parameters.n = n;
  parameters.m = m;
  const Scene scene = lab::generate_scene(*lab::find_workload(workload), parameters);
  const std::string text = formats::write_scene(scene);
  const std::string hash = formats::scene_hash(scene);
  std::size_t plans = 0;
  for (const SceneObject& object : scene.objects) plans += object.motion.pieces.size();
  std::vector<double> best(3);
  for (int round = 0; round < rounds; ++round) {
    const double seconds[] = {
        seconds_of([&] { return (parse_plainly(text), 0); }),
        seconds_of([&] { return formats::parse_json(text, workload); }),
        seconds_of([&] { return formats::parse_scene(text, workload); }),
    };
    for (std::size_t i = 0; i < best.size(); ++i) {
      if (round == 0 || seconds[i] < best[i]) best[i] = seconds[i];
    }
  }
  if (formats::scene_hash(formats::parse_scene(text, workload)) != hash) {
    throw std::logic_error("loading: the scene that was read is another");
  }
  const char* const names[] = {"plain", "tree", "scene"};
  for (std::size_t i = 0; i < best.size(); ++i) {
    const auto bytes = static_cast<double>(text.size());
    table.row({workload, names[i], n, plans, bytes / 1e6, best[i], bytes / 1e6 / best[i], best[i] / best[0]});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = bench_options(argc, argv);
  if (!options) return 2;
  lab::install_gmp_memory();
  ResultTable table(*options, "loading",
                    "Scenes as they are read: CPU time, and time over that of a plain parse by rapidjson.",
                    {{"workload", ResultTable::kText, 14},
                     {"read_as", ResultTable::kText, 7},
                     {"objects", 0, 7},
                     {"plans", 0, 7},
                     {"megabytes", 1},
                     {"seconds", 4},
                     {"megabytes_per_second", 0},
                     {"time_over_plain", 2}});
  const bool smoke = options->smoke;
  load("uniform-square", smoke ? 100 : 100000, 0, smoke ? 1 : 9, table);
  load("walks", smoke ? 10 : 308, smoke ? 10 : 369, smoke ? 1 : 9, table);
  return 0;
}
