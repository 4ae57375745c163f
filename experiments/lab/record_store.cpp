// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/lab/record_store.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "experiments/formats/file_io.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_value.h"
#include "experiments/formats/json_writer.h"

namespace kinex::lab {

namespace {

std::string header_line(const std::string& commit) {
  std::string text;
  formats::JsonWriter json(text);
  json.begin_object().key("kinex_runs").number(1).key("commit").string(commit).end_object();
  return text;
}

}  // namespace

RecordStore::RecordStore(std::string path, const std::string& commit, bool fresh)
    : path_(std::move(path)) {
  const std::string header = header_line(commit);
  std::string kept = header + "\n";
  if (!fresh && std::filesystem::exists(path_)) {
    const std::string text = formats::read_text_file(path_);
    std::size_t begin = 0, number = 1;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
      const std::string line = text.substr(begin, end - begin);
      if (number == 1 && line != header) {
        throw formats::InputError(path_, "line 1", "it was begun by another version of the program",
                         "give --fresh to begin anew, or another folder");
      }
      if (is_checked_by_line(line)) {
        StoredCheck stored = parse_checked_by(line, path_, number);
        kept += line + "\n";
        checks_.insert_or_assign(std::move(stored.key), std::move(stored.checked));
      } else if (number > 1) {
        RunRecord record = parse_record(line, path_, number);
        kept += line + "\n";
        std::string key = record.key;
        records_.insert_or_assign(std::move(key), std::move(record));
      }
      ++number;
    }
  }
  // Without the incomplete last line of a killed run.
  formats::OutputFile clean(path_, true);
  clean.write(kept);
  clean.commit();
  file_.reset(std::fopen(path_.c_str(), "ab"));
  if (!file_) {
    throw formats::InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
                     "give a folder that can be written");
  }
}

const RunRecord* RecordStore::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = records_.find(key);
  return found == records_.end() ? nullptr : &found->second;
}

std::optional<CheckedBy> RecordStore::find_check(const RunKey& run,
                                                 const std::string& program) const {
  const std::lock_guard lock(mutex_);
  const auto found = checks_.find(checked_by_key(run, program));
  if (found == checks_.end()) return std::nullopt;
  CheckedBy checked = found->second;
  checked.run = run;
  return checked;
}

void RecordStore::append(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() ||
      std::fflush(file_.get()) != 0) {
    throw formats::InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno),
                     "make room on the disk; the same command goes on from here");
  }
}

const RunRecord& RecordStore::add(const RunRecord& record) {
  const std::lock_guard lock(mutex_);
  const std::string line = record_line(record) + "\n";
  append(line);
  // As it will be read back: results do not depend on when the record was made.
  std::string key = record.key;
  return records_.insert_or_assign(std::move(key), parse_record(line, path_, 0)).first->second;
}

void RecordStore::add_check(const CheckedBy& checked) {
  const std::lock_guard lock(mutex_);
  append(checked_by_line(checked) + "\n");
  checks_.insert_or_assign(checked_by_key(checked.run, checked.program), checked);
}

}  // namespace kinex::lab
