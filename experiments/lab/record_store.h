// SPDX-License-Identifier: GPL-3.0-or-later
// RecordStore: finished runs, and checks by a second program, in a file that grows as they end. A
// long experiment resumes from it.
#ifndef KINEX_EXPERIMENTS_LAB_RECORD_STORE_H
#define KINEX_EXPERIMENTS_LAB_RECORD_STORE_H

#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "experiments/lab/checked_by.h"
#include "experiments/lab/run_record.h"

namespace kinex::lab {

class RecordStore {
 public:
  // Reads the file if it exists. Its first line names the format and the commit of the program that
  // wrote it. Throws InputError for records of another commit, unless `fresh`, which discards them.
  // An incomplete last line is dropped.
  RecordStore(std::string path, const std::string& commit, bool fresh);

  // nullptr if it has not been run. Called from any thread.
  const RunRecord* find(const std::string& key) const;
  // Writes the record to the file before it returns. Called from any thread.
  const RunRecord& add(const RunRecord& record);
  // The check of this run by this program, if it accepted the log; nullopt otherwise.
  std::optional<CheckedBy> find_check(const RunKey& run, const std::string& program) const;
  void add_check(const CheckedBy& checked);
  std::size_t size() const { return records_.size(); }
  const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void append(const std::string& line);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  mutable std::mutex mutex_;
  std::map<std::string, RunRecord> records_;  // references stay valid
  std::map<std::string, CheckedBy> checks_;
};

}  // namespace kinex::lab

#endif
