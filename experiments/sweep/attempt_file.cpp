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
#include "experiments/sweep/append_whole.h"

namespace kinex::sweep {

namespace fs = std::filesystem;

namespace {

std::string random_text() {
  std::random_device random;
  char text[16];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(random()));
  return text;
}

bool is_attempt_name(const std::string& name) {
  return name.starts_with("shard-") && name.ends_with(".jsonl");
}

void add_attempt_files(const std::string& folder, std::vector<std::string>& files) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (is_attempt_name(at->path().filename().string())) paths.push_back(at->path().string());
  }
  if (error) {
    throw formats::InputError(folder, "", "cannot be read: " + error.message(),
                     "give the folder of a sweep, that of -o");
  }
  std::sort(paths.begin(), paths.end());
  files.insert(files.end(), paths.begin(), paths.end());
}

void read_attempt(const std::string& path, std::vector<Attempt>& attempts) {
  const std::string text = formats::read_text_file(path);
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

AttemptFile::AttemptFile(const std::string& folder, const Shard& shard,
                         const AttemptProvenance& provenance) {
  const std::string begin =
      folder + "/shard-" + std::to_string(shard.index) + "-" + utc_text("%Y%m%dT%H%M%SZ") + "-";
  do {
    path_ = begin + random_text() + ".jsonl";
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  } while (file_ < 0 && errno == EEXIST);
  if (file_ < 0) {
    throw formats::InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
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
  append_whole(file_, text + "\n", path_, size_);
}

std::vector<std::string> attempt_files(const std::vector<std::string>& folders) {
  std::vector<std::string> files;
  for (const std::string& folder : folders) add_attempt_files(folder, files);
  return files;
}

std::vector<Attempt> read_attempts(const std::vector<std::string>& folders) {
  std::vector<Attempt> attempts;
  for (const std::string& path : attempt_files(folders)) read_attempt(path, attempts);
  for (const Attempt& attempt : attempts) {
    const AttemptProvenance& first = attempts.front().provenance;
    if (attempt.provenance.program == first.program) continue;
    throw formats::InputError(attempt.path, "line 1",
                     "its records are of another commit, " + lab::commit_text(attempt.provenance.build) +
                         ", than those of " + attempts.front().path + ", " +
                         lab::commit_text(first.build),
                     "keep the records of each commit in a folder of their own");
  }
  return attempts;
}

}  // namespace kinex::sweep
