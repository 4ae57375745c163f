// SPDX-License-Identifier: GPL-3.0-or-later
// Attempt files: the store of a sweep. Each attempt at a shard appends to its own file. So there
// are no locks and no shared database, and network file systems suffice.
//
// FOLDER/shard-I-START-RANDOM.jsonl has JSON lines, each written by one call and flushed to the
// disk:
//   first line      provenance: the plan, the program, the machine, the command
//   other lines     the Record of a cell that has ended
// Readers drop an incomplete last line: its attempt was killed.
#ifndef KINEX_EXPERIMENTS_SWEEP_ATTEMPT_FILE_H
#define KINEX_EXPERIMENTS_SWEEP_ATTEMPT_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/sweep/attempt_provenance.h"
#include "experiments/sweep/record.h"

namespace kinex::sweep {

class AttemptFile {
 public:
  // Creates a new file; never opens an existing one. Throws InputError.
  AttemptFile(const std::string& folder, const Shard& shard, const AttemptProvenance& provenance);
  ~AttemptFile();
  AttemptFile(const AttemptFile&) = delete;
  AttemptFile& operator=(const AttemptFile&) = delete;

  // The record is on the disk when the call returns. If the disk is full, the file stays as it was
  // and InputError is thrown.
  void append(const Record& record);
  const std::string& path() const { return path_; }

 private:
  void write_line(const std::string& text);

  std::string path_;
  int file_ = -1;
  std::int64_t size_ = 0;
};

// The contents of an attempt file.
struct Attempt {
  std::string path;
  AttemptProvenance provenance;
  std::vector<Record> records;  // record k is line k + 2
};

// The names of all attempt files in the folders, folder by folder, sorted. Throws InputError for a folder that cannot be read.
std::vector<std::string> attempt_files(const std::vector<std::string>& folders);

// All attempts in these files; files without a complete first line are skipped.
// Throws InputError for a line that is no record, and if two files come from different programs.
std::vector<Attempt> read_attempts(const std::vector<std::string>& folders);

}  // namespace kinex::sweep

#endif
