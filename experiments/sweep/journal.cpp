// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/sweep/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/sha256.h"
#include "experiments/sweep/append_whole.h"

namespace kinex::sweep {

namespace {

std::string output_line(const std::string& path, const std::string& digest) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("output").string(path).key("sha256").string(digest).end_object();
  return text + "\n";
}

// What is wrong with records that begin with this text, if they are to be gone on with; empty: nothing.
std::string foreign(const std::string& text, const std::string& path, const AttemptProvenance& own) {
  if (text.empty()) return "";
  try {
    const AttemptProvenance begun = parse_provenance(text.substr(0, text.find('\n')), path);
    if (begun.program != own.program) return "another version of the program";
    if (begun.plan_hash != own.plan_hash) return "another command, \"" + begun.plan_name + "\"";
    return "";
  } catch (const formats::InputError&) {
    return "another version of the program";  // and of the format
  }
}

// False: another run holds the file. A run that was killed can hold it for a moment longer, by a child that had not yet
// become a program of its own.
bool lock(int file) {
  constexpr auto kPause = std::chrono::milliseconds(20);
  for (int tries = 0; tries < 100; ++tries) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

}  // namespace

Journal::Journal(std::string path, const AttemptProvenance& provenance, Leftover leftover)
    : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) {
    throw formats::InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
                              "give a folder that can be written with -o");
  }
  try {
    if (!lock(file_)) {
      throw formats::InputError(path_, "", "another run is at work in this folder",
                                "wait for it, or give another folder with -o");
    }
    std::string text = leftover == Leftover::kDrop ? "" : formats::read_text_file(path_);
    const std::size_t last = text.rfind('\n');
    text.resize(last == text.npos ? 0 : last + 1);  // without the incomplete last line of a killed run
    if (const std::string other = foreign(text, path_, provenance); !other.empty()) {
      if (leftover == Leftover::kKeep) {
        throw formats::InputError(path_, "line 1", "it was begun by " + other,
                                  "give another folder with -o, or --fresh or --force to begin anew");
      }
      dropped_other_ = other;
      text.clear();
    }
    read_lines(text);
    if (::ftruncate(file_, static_cast<off_t>(text.size())) != 0) {
      throw formats::InputError(path_, "",
                                std::string("cannot be written: ") + std::strerror(errno), "");
    }
    size_ = static_cast<std::int64_t>(text.size());
    if (text.empty()) append(provenance_line(provenance) + "\n");
  } catch (...) {
    ::close(file_);  // and the file is left as it is
    throw;
  }
}

Journal::Journal(const std::vector<Attempt>& attempts) {
  for (const auto& [key, record] : settle(attempts)) records_.emplace(key, *record);
  note_found();
}

// Without records there is nothing to resume from.
Journal::~Journal() {
  if (file_ < 0) return;
  if (records_.empty() && outputs_.empty()) remove();
  ::close(file_);
}

void Journal::read_lines(const std::string& text) {
  std::size_t begin = 0, number = 1;
  for (std::size_t end; (end = text.find('\n', begin)) != text.npos; begin = end + 1, ++number) {
    const std::string line = text.substr(begin, end - begin);
    if (number == 1) continue;  // the provenance
    const formats::JsonDocument document = formats::parse_json(line, path_, number);
    const formats::JsonValue& value = *document;
    const formats::JsonValue* output = value.find("output");
    const formats::JsonValue* digest = value.find("sha256");
    if (output != nullptr && digest != nullptr) {
      outputs_.insert_or_assign(std::string(output->text()), digest->text());
      continue;
    }
    Record record = parse_record(line, path_, number);
    std::string key = record.key;
    records_.insert_or_assign(std::move(key), std::move(record));
  }
  note_found();
}

void Journal::note_found() {
  found_ = records_.size();
  for (const auto& [key, record] : records_) {
    if (record.outcome != Outcome::kKilled) found_seconds_ += record.wall_s;
  }
}

void Journal::append(const std::string& line) { append_whole(file_, line, path_, size_); }

const Record* Journal::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = records_.find(key);
  if (found == records_.end() || found->second.outcome == Outcome::kKilled) return nullptr;
  return &found->second;
}

const Record& Journal::add(const Record& record) {
  const std::lock_guard lock(mutex_);
  if (file_ < 0) throw std::logic_error("a journal without a file takes no records");
  const std::string line = record_line(record);
  append(line + "\n");
  // Two threads may have run the same cell: the first one stays, for find() has handed it out.
  return records_.try_emplace(record.key, parse_record(line, path_, 0)).first->second;
}

// As seen from the journal's folder: however that is spelt, and wherever it is moved to.
std::string Journal::name_of(const std::string& path) const {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(path, error);
  const fs::path folder = fs::weakly_canonical(path_, error).parent_path();
  return error ? path : whole.lexically_relative(folder).string();
}

void Journal::note_output(const std::string& path, std::string_view text) {
  const std::lock_guard lock(mutex_);
  const std::string name = name_of(path), digest = formats::sha256_hex(text);
  if (file_ >= 0) append(output_line(name, digest));
  outputs_.insert_or_assign(name, digest);
}

bool Journal::is_own_output(const std::string& path) const {
  std::error_code absent;
  if (!std::filesystem::is_regular_file(path, absent)) return false;
  const std::lock_guard lock(mutex_);
  const auto found = outputs_.find(name_of(path));
  return found != outputs_.end() &&
         found->second == formats::sha256_hex(formats::read_file_bytes(path));
}

void Journal::remove() {
  if (file_ >= 0) ::unlink(path_.c_str());
}

}  // namespace kinex::sweep
