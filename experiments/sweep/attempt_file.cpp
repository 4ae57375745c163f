// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/attempt_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/sweep/canonical_json.h"

namespace kinex::sweep {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;

std::string random_text() {
  std::random_device random;
  char text[16];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(random()));
  return text;
}

bool is_attempt_name(const std::string& name) {
  return name.starts_with("shard-") && name.ends_with(".jsonl");
}

std::vector<std::string> attempt_paths(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (is_attempt_name(at->path().filename().string())) paths.push_back(at->path().string());
  }
  if (error) {
    throw InputError(folder, "", "cannot be read: " + error.message(),
                     "give the folder of a sweep, that of -o");
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void read_attempt(const std::string& path, std::vector<Attempt>& attempts) {
  const std::string text = read_text_file(path);
  std::size_t begin = 0, number = 1;
  for (std::size_t end; (end = text.find('\n', begin)) != text.npos; begin = end + 1, ++number) {
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (number == 1) {
      attempts.push_back({path, parse_provenance(line, path), {}});
    } else {
      attempts.back().records.push_back(parse_record(line, path, number));
    }
  }
}

}  // namespace

std::string provenance_line(const Provenance& provenance) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("kinex_sweep").number(kVersion);
  json.key("plan_name").string(provenance.plan_name);
  json.key("plan_hash").string(provenance.plan_hash).key("program").string(provenance.program);
  json.key("version").string(provenance.build.program);
  json.key("commit").string(provenance.build.commit).key("dirty").boolean(provenance.build.dirty);
  json.key("compiler").string(provenance.build.compiler);
  json.key("flags").string(provenance.build.flags);
  json.key("libraries").string(provenance.build.libraries);
  json.key("cpu").string(provenance.machine.cpu);
  json.key("cores").number(static_cast<std::uint64_t>(provenance.machine.cores));
  json.key("memory_kb").number(static_cast<std::uint64_t>(provenance.machine.memory_kb));
  json.key("kernel").string(provenance.machine.kernel).key("host").string(provenance.host);
  json.key("command").string(provenance.command).key("shard").string(provenance.shard);
  json.key("job").string(provenance.job).key("started").string(provenance.started);
  json.key("plan").raw(provenance.plan).end_object();
  return text;
}

Provenance parse_provenance(std::string_view line, const std::string& file) {
  const JsonValue value = parse_json(line, file);
  const LineFields fields(value, file, 1);
  if (fields.whole("kinex_sweep") != kVersion) {
    throw InputError(file, "line 1", "it was written in another version of this format",
                     "use the program that wrote it, or another folder");
  }
  Provenance provenance;
  provenance.plan_name = fields.text("plan_name");
  provenance.plan_hash = fields.text("plan_hash");
  provenance.plan = canonical_json(fields.member("plan"));
  provenance.program = fields.text("program");
  provenance.build.program = fields.text("version");
  provenance.build.commit = fields.text("commit");
  provenance.build.dirty = fields.boolean("dirty");
  provenance.build.compiler = fields.text("compiler");
  provenance.build.flags = fields.text("flags");
  provenance.build.libraries = fields.text("libraries");
  provenance.machine.cpu = fields.text("cpu");
  provenance.machine.cores = fields.whole("cores");
  provenance.machine.memory_kb = fields.whole("memory_kb");
  provenance.machine.kernel = fields.text("kernel");
  provenance.host = fields.text("host");
  provenance.command = fields.text("command");
  provenance.shard = fields.text("shard");
  provenance.job = fields.text("job");
  provenance.started = fields.text("started");
  return provenance;
}

AttemptFile::AttemptFile(const std::string& folder, const Shard& shard,
                         const Provenance& provenance) {
  const std::string begin =
      folder + "/shard-" + std::to_string(shard.index) + "-" + utc_text("%Y%m%dT%H%M%SZ") + "-";
  do {
    path_ = begin + random_text() + ".jsonl";
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) {
    throw InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
                     "give a folder that can be written with -o");
  }
  try {
    write_line(provenance_line(provenance));
  } catch (...) {
    ::close(file_);
    ::unlink(path_.c_str());
    throw;
  }
}

AttemptFile::~AttemptFile() { ::close(file_); }

void AttemptFile::append(const Record& record) { write_line(record_line(record)); }

void AttemptFile::write_line(const std::string& text) {
  const std::string line = text + "\n";
  const ssize_t written = ::write(file_, line.data(), line.size());
  int error = written < 0 ? errno : ENOSPC;
  if (written == static_cast<ssize_t>(line.size())) {
    // A pipe or a special file system may have nothing to flush.
    if (::fdatasync(file_) == 0 || errno == EINVAL || errno == ENOTSUP) {
      size_ += written;
      return;
    }
    error = errno;
  }
  if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) error = errno;
  throw InputError(path_, "", std::string("cannot be written: ") + std::strerror(error),
                   "make room on the disk; the same command goes on from here");
}

std::vector<Attempt> read_attempts(const std::vector<std::string>& folders) {
  std::vector<Attempt> attempts;
  for (const std::string& folder : folders) {
    for (const std::string& path : attempt_paths(folder)) read_attempt(path, attempts);
  }
  for (const Attempt& attempt : attempts) {
    const Provenance& first = attempts.front().provenance;
    if (attempt.provenance.program == first.program) continue;
    throw InputError(attempt.path, "line 1",
                     "its records are of another commit, " + commit_text(attempt.provenance.build) +
                         ", than those of " + attempts.front().path + ", " +
                         commit_text(first.build),
                     "keep the records of each commit in a folder of their own");
  }
  return attempts;
}

}  // namespace kinex::sweep
