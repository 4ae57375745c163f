// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/second_program.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/numbers/stop.h"
#include "experiments/formats/event_log.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/lab/gmp_memory.h"
#include "experiments/lab/helper_program.h"
#include "experiments/lab/scene_run.h"
#include "experiments/lab/temporary_folder.h"

namespace kinex::lab {

namespace fs = std::filesystem;

namespace {

constexpr const char* kName = "kinex-logcheck";
constexpr std::chrono::seconds kPatience{60};  // the runs are small: it takes a second at most
constexpr int kWrong = 1, kGaveUp = 3;         // its exit codes

std::string found_program() {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path() / kName;
  return !error && fs::exists(here, error) ? here.string() : kName;
}

// The program of a folder, which python3 runs as it is.
constexpr const char* kPythonMain = "__main__.py";

bool is_folder(const std::string& path) {
  std::error_code error;
  return path.find('/') != path.npos && fs::is_directory(path, error);
}

// Of a path; a name is looked for among programs.
bool is_runnable(const std::string& program) {
  return program.find('/') == program.npos || access(program.c_str(), X_OK) == 0;
}

// As in kinex-logcheck.
std::string python_program() {
  const char* given = std::getenv("PYTHON");
  return given == nullptr || *given == '\0' ? "python3" : given;
}

// True if there is such a program: at this path, or in PATH.
bool is_there(const std::string& program) {
  std::error_code error;
  if (is_folder(program)) return fs::exists(fs::path(program) / kPythonMain, error);
  if (program.find('/') != program.npos) return fs::exists(program, error);
  const char* path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (fs::exists(fs::path(folders.substr(begin, end - begin)) / program, error)) return true;
    begin = end + 1;
  }
  return false;
}

void write_file(const fs::path& path, const std::string& text) {
  formats::OutputFile file(path.string(), true);
  file.write(text);
  file.commit();
}

// nullptr if there is no such member, or it is no text.
const formats::JsonValue* text_member(const formats::JsonValue& report, const char* name) {
  const formats::JsonValue* found = report.find(name);
  return found == nullptr || found->kind() != formats::JsonValue::Kind::kString ? nullptr : found;
}

// The parts of a report of kinex-logcheck --json other than its verdict.
void read_report(const formats::JsonValue& report, CheckedBy& checked) {
  const auto leave_out = [&](const std::string& what) {
    checked.left_out += (checked.left_out.empty() ? "" : "; ") + what;
  };
  std::string reason;  // of the preceding levels, which are named together
  std::vector<int> undone;
  const auto name_undone = [&] {
    if (undone.empty()) return;
    std::string what = undone.size() == 1 ? "level " : "levels ";
    for (std::size_t i = 0; i < undone.size(); ++i) {
      what += (i == 0 ? "" : ", ") + std::to_string(undone[i]);
    }
    leave_out(what + ": " + reason);
    undone.clear();
  };
  if (const formats::JsonValue* levels = report.find("levels")) {
    for (const formats::JsonValue& one : levels->items()) {
      const formats::JsonValue* level = one.find("level");
      const formats::JsonValue* done = one.find("done");
      if (level == nullptr || done == nullptr) continue;
      const int number = std::atoi(std::string(level->text()).c_str());
      if (done->boolean()) {
        checked.levels.push_back(number);
        continue;
      }
      const formats::JsonValue* detail = text_member(one, "detail");
      const std::string why(detail == nullptr ? "no reason is given" : detail->text());
      if (why != reason) name_undone();
      reason = why;
      undone.push_back(number);
    }
  }
  name_undone();
  if (const formats::JsonValue* missing = report.find("not_followed")) {
    for (const formats::JsonValue& label : missing->items()) {
      leave_out(std::string(label.text()) + " has no replay");
    }
  }
  if (const formats::JsonValue* partly = report.find("partly")) {
    for (const formats::JsonValue& what : partly->items()) {
      leave_out("not followed: " + std::string(what.text()));
    }
  }
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

SecondProgram::SecondProgram(std::string path, std::function<bool()> go_on,
                             const std::atomic<bool>* interrupt)
    : path_(path.empty() ? found_program() : path),
      name_(path.empty() ? kName : std::move(path)),
      go_on_(std::move(go_on)),
      interrupt_(interrupt) {}

bool SecondProgram::exists() const { return is_there(path_); }

CheckedBy SecondProgram::check(const RunKey& run) const {
  CheckedBy checked;
  checked.program = name_;
  checked.run = run;
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    checked.message = "no temporary folder could be made";
    return checked;
  }
  const fs::path scene_path = folder.path() / "scene.json", log_path = folder.path() / "log.jsonl";
  const fs::path out = folder.path() / "out", err = folder.path() / "err";
  const Scene scene = scene_for(run);
  write_file(scene_path, formats::write_scene(scene));
  try {
    SimulatorOptions options;
    options.audit = AuditLevel::kNone;
    options.interrupt = interrupt_;
    const auto simulator = make_simulator(scene, "exact", options);
    const GmpGuard guard(&simulator->deadline());
    formats::OutputFile file(log_path.string(), true);
    formats::EventLog log(*simulator, formats::scene_hash(scene), &file);
    simulator->set_sink(&log);
    const formats::RunOutcome outcome = run_scene(*simulator, {});
    log.finish(outcome.status);
  } catch (const Stopped&) {
    // Asked below.
  }
  const auto began = std::chrono::steady_clock::now();
  bool late = false;
  const auto go_on = [&] {
    late = std::chrono::steady_clock::now() - began > kPatience;
    return go_on_() && !late;
  };
  if (!go_on()) {
    checked.message = "interrupted";
    return checked;
  }
  std::string program = path_;
  std::vector<std::string> arguments{log_path.string(), "--scene", scene_path.string(), "--json"};
  if (is_folder(path_) && is_there(path_)) {
    program = python_program();
    // -B: none of Python's own files is left there.
    arguments.insert(arguments.begin(), {"-B", path_});
  }
  const HelperEnd end = run_helper(program, arguments, out, err, go_on);
  switch (end.how) {
    case HelperEnd::How::kNotFound:
      checked.message = !is_there(path_)      ? name_ + " was not found"
                        : !is_runnable(path_) ? name_ + " is not executable"
                                              : "python3 was not found";
      return checked;
    case HelperEnd::How::kStopped:
      checked.message =
          late ? "it took longer than " + std::to_string(kPatience.count()) + " s" : "interrupted";
      return checked;
    case HelperEnd::How::kSignal:
      checked.message = name_ + " was ended by signal " + std::to_string(end.code);
      return checked;
    case HelperEnd::How::kExited:
      break;
  }
  std::string told;  // the reason of a failure
  try {
    const formats::JsonDocument report_document =
        formats::parse_json(formats::read_text_file(out.string()), name_);
    const formats::JsonValue& report = *report_document;
    read_report(report, checked);
    if (const formats::JsonValue* message = text_member(report, "message")) told = message->text();
    const formats::JsonValue* line = report.find("line");
    if (!told.empty() && line != nullptr && line->kind() == formats::JsonValue::Kind::kNumber) {
      told = "line " + std::string(line->text()) + ": " + told;
    }
  } catch (const formats::InputError&) {
    checked.levels.clear();
    checked.left_out.clear();
    told = first_line(formats::read_text_file(err.string()));
  }
  if (told.empty()) told = "exit code " + std::to_string(end.code);
  if (end.code == 0 && !checked.levels.empty()) {
    checked.finding = CheckedBy::Finding::kFine;
  } else if (end.code == kWrong) {
    checked.finding = CheckedBy::Finding::kRefused;
    checked.message = told;
  } else {
    checked.message = end.code == kGaveUp ? name_ + " gave up: " + told : told;
  }
  return checked;
}

}  // namespace kinex::lab
