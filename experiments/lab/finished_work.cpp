// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/finished_work.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_value.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/sha256.h"

namespace kinex {

namespace {

constexpr const char* kOutput = "output ";
constexpr const char* kBeginAnew = "give --fresh to begin anew, or another folder with -o";

std::string header_line(const std::string& program) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("kinex_finished_work").number(1).key("program").string(program);
  json.end_object();
  return text + "\n";
}

std::string piece_line(const std::string& key, const std::string& data) {
  std::string text;
  JsonWriter json(text);
  json.begin_object().key("piece").string(key).key("data").string(data).end_object();
  return text + "\n";
}

}  // namespace

FinishedWork::FinishedWork(std::string path, const std::string& program, bool fresh)
    : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) {
    throw InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
                     "give a folder that can be written with -o");
  }
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      throw InputError(path_, "", "another run is at work in this folder",
                       "wait for it, or give another folder with -o");
    }
    const std::string header = header_line(program);
    const std::string text = fresh ? "" : read_text_file(path_);
    std::size_t whole = 0, number = 1;
    for (std::size_t end; (end = text.find('\n', whole)) != text.npos; whole = end + 1, ++number) {
      const std::string line = text.substr(whole, end + 1 - whole);
      if (number == 1) {
        if (line == header) continue;
        throw InputError(path_, "line 1", "it was begun by another version of the program",
                         kBeginAnew);
      }
      const JsonValue value = parse_json(line, path_, number);
      const JsonValue* key = value.find("piece");
      const JsonValue* data = value.find("data");
      if (key == nullptr || data == nullptr) {
        throw InputError(path_, "line " + std::to_string(number), "it is no finished piece of work",
                         kBeginAnew);
      }
      if (key->text.rfind(kOutput, 0) != 0) ++found_;
      pieces_.insert_or_assign(key->text, data->text);
    }
    // Without the incomplete last line of a killed run.
    if (::ftruncate(file_, static_cast<off_t>(whole)) != 0) {
      throw InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno), "");
    }
    if (whole == 0) append(header);
  } catch (...) {
    ::close(file_);  // and the file is left as it is
    throw;
  }
}

// Without finished work there is nothing to resume from.
FinishedWork::~FinishedWork() {
  if (pieces_.empty()) remove();
  ::close(file_);
}

void FinishedWork::append(const std::string& line) {
  const ssize_t written = ::write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  throw InputError(path_, "",
                   std::string("cannot be written: ") +
                       (written < 0 ? std::strerror(errno) : "the disk is full"),
                   "make room on the disk; the same command goes on from here");
}

std::optional<std::string> FinishedWork::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = pieces_.find(key);
  if (found == pieces_.end()) return std::nullopt;
  return found->second;
}

void FinishedWork::add(const std::string& key, const std::string& data) {
  const std::lock_guard lock(mutex_);
  append(piece_line(key, data));
  pieces_.insert_or_assign(key, data);
}

void FinishedWork::note_output(const std::string& path, std::string_view text) {
  add(kOutput + path, sha256_hex(text));
}

bool FinishedWork::is_own_output(const std::string& path) const {
  std::error_code absent;
  if (!std::filesystem::is_regular_file(path, absent)) return false;
  const std::optional<std::string> digest = find(kOutput + path);
  return digest && *digest == sha256_hex(read_text_file(path));
}

void FinishedWork::remove() { ::unlink(path_.c_str()); }

}  // namespace kinex
