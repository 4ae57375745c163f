// SPDX-License-Identifier: GPL-3.0-or-later
// RecordStore: finished runs, and logs that a second program accepted, in a file that grows as they
// end, so that an experiment of hours resumes where it was stopped.
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

namespace kinex {

class RecordStore {
 public:
  // Reads the file if there is one; its first line names the format and the commit of the program
  // that wrote it. Records of another commit are not mixed with new ones: InputError, unless
  // `fresh`, which begins anew. An incomplete last line is dropped. Throws InputError.
  RecordStore(std::string path, const std::string& commit, bool fresh);

  // nullptr if it has not been run. Called from any thread.
  const RunRecord* find(const std::string& key) const;
  // Written through at once. Called from any thread.
  const RunRecord& add(const RunRecord& record);
  // What a second program accepted; with the run of `run`.
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

}  // namespace kinex

#endif
