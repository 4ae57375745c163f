// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/golden/golden_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/workload.h"
#include "tests/places.h"
#include "tests/structures/test_scenes.h"

namespace kinex::golden {

namespace {

using Options = std::map<std::string, std::string>;

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error(what); }

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

int number(const Options& options, const std::string& name, int otherwise) {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : std::stoi(found->second);
}

// "x", "y", "z", "direction:3:4" or "distance:ID".
Key parse_key(const std::string& text, const Scene& scene) {
  const std::vector<std::string> parts = split(text, ':');
  Key key;
  if (parts[0] == "direction") {
    key.kind = Key::Kind::kDirection;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      key.direction.push_back(*Rational::parse(parts[i]));
    }
  } else if (parts[0] == "distance") {
    key.kind = Key::Kind::kSquaredDistance;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
      if (scene.objects[id].id == parts.at(1)) key.object = id;
    }
    if (key.object == kNoObject) refuse("no object " + parts[1]);
  } else {
    key.axis = parts[0][0] - 'x';
  }
  return key;
}

// Flight plans in random pieces; objects that come and go.
Scene make_flights(const Options& options) {
  return test::random_flights(static_cast<std::uint64_t>(number(options, "seed", 1)),
                              number(options, "n", 7), number(options, "dimension", 2),
                              number(options, "degree", 1), true);
}

// Coordinates of the size of 1e150 and of 1e-150 in one scene.
Scene make_magnitudes(const Options& options) {
  test::Random random(static_cast<std::uint64_t>(number(options, "seed", 1)));
  std::vector<Trajectory> paths;
  for (int i = 0; i < number(options, "n", 8); ++i) {
    Trajectory path = random.small_path(2, number(options, "degree", 1), 1000);
    for (std::vector<Rational>& axis : path.coordinates) {
      for (Rational& c : axis) c *= *Rational::parse(i % 2 == 0 ? "1e150" : "1e-150");
    }
    paths.push_back(std::move(path));
  }
  return test::scene_of(paths, 0, Rational(2));
}

std::string run_log(const Scene& scene, const std::string& arithmetic, Golden& golden) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("kinex-golden-" + std::to_string(::getpid()) + ".log"))
                               .string();
  SimulatorOptions options;
  options.audit = arithmetic == "exact" ? AuditLevel::kEnd : AuditLevel::kNone;
  const auto simulator = lab::make_simulator(scene, arithmetic, options);
  formats::OutputFile file(path, true);
  formats::EventLog log(*simulator, formats::scene_hash(scene), &file);
  simulator->set_sink(&log);
  const formats::RunOutcome outcome = lab::run_scene(*simulator, {});
  log.finish(outcome.status);
  EXPECT_TRUE(outcome.clean(*simulator)) << scene.name;
  golden.records = log.records();
  golden.digest = log.digest();
  const std::string text = formats::read_text_file(path);
  std::filesystem::remove(path);
  return text;
}

}  // namespace

std::string table_path() { return KINEX_SOURCE_DIR "/tests/golden/digests.txt"; }

Table read_table() {
  std::ifstream in(table_path());
  if (!in) refuse("cannot read " + table_path());
  Table table;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line[0] == '#') {
      if (table.rows.empty()) table.head += line + "\n";
      continue;
    }
    if (line[0] != ' ') {
      table.rows.push_back({line, line.find(" sturm=no") == std::string::npos, {}});
      continue;
    }
    std::istringstream words(line);
    std::string name, value, more;
    if (table.rows.empty() || !(words >> name >> value) || (words >> more)) {
      refuse(table_path() + ":" + std::to_string(number) + ": not a result");
    }
    Golden& golden = table.rows.back().golden;
    if (name == "records") {
      golden.records = std::stoull(value);
    } else if (name == "digest") {
      golden.digest = value;
    } else if (name == "body") {
      golden.body = value;
    } else {
      refuse(table_path() + ":" + std::to_string(number) + ": " + name);
    }
  }
  return table;
}

void write_table(const Table& table) {
  std::ofstream out(table_path());
  out << table.head;
  for (const Row& row : table.rows) {
    out << row.scene << "\n  records " << row.golden.records << "\n  digest " << row.golden.digest
        << "\n  body   " << row.golden.body << "\n";
  }
  if (!out.flush()) refuse("cannot write " + table_path());
}

Scene make_scene(const std::string& description) {
  std::istringstream words(description);
  std::string family;
  words >> family;
  Options options;
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) refuse(description + ": " + word);
    options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  Scene scene;
  if (family == "file") {
    scene = formats::read_scene(KINEX_SOURCE_DIR "/" + options.at("path"));
  } else if (family == "flights") {
    scene = make_flights(options);
  } else if (family == "magnitudes") {
    scene = make_magnitudes(options);
  } else {
    const lab::Workload* workload = lab::find_workload(family);
    if (workload == nullptr) refuse("no family " + family);
    lab::WorkloadParameters parameters;
    parameters.n = number(options, "n", 8);
    parameters.m = number(options, "m", 0);
    parameters.seed = static_cast<std::uint64_t>(number(options, "seed", 1));
    parameters.degree = number(options, "degree", 1);
    parameters.dimension = number(options, "dimension", 0);
    parameters.turns = number(options, "turns", -1);
    const auto separation = options.find("separation");
    if (separation != options.end()) {
      parameters.separation = Rational::parse(separation->second);
    }
    scene = lab::generate_scene(*workload, parameters);
  }
  const auto maintain = options.find("maintain");
  if (maintain == options.end()) return scene;
  scene.maintain.clear();
  for (const std::string& name : split(maintain->second, ',')) {
    Request request;
    request.structure = request.label = name;
    const auto key = options.find("key");
    if (key != options.end()) request.key = parse_key(key->second, scene);
    scene.maintain.push_back(std::move(request));
  }
  return scene;
}

Golden run(const Scene& scene, const std::string& arithmetic) {
  Golden golden;
  const std::string log = run_log(scene, arithmetic, golden);
  const std::size_t first = log.find('\n') + 1;
  const std::size_t last = log.rfind('\n', log.size() - 2) + 1;
  golden.body = formats::sha256_hex(std::string_view(log).substr(first, last - first));
  return golden;
}

}  // namespace kinex::golden
