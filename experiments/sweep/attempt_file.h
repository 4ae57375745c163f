// SPDX-License-Identifier: GPL-3.0-or-later
// Attempt files: the store of a sweep. Each attempt at a shard appends to a file of its own, so
// there are no locks and no shared database, and network file systems will do.
//
// FOLDER/shard-I-START-RANDOM.jsonl, JSON lines, each written at once and flushed to the disk:
//   first line    provenance: the plan, the program, the machine, the command
//   each other    the Record of a cell that has ended
// A last line that is not whole, of an attempt that was killed, is dropped by readers.
#ifndef KINEX_EXPERIMENTS_SWEEP_ATTEMPT_FILE_H
#define KINEX_EXPERIMENTS_SWEEP_ATTEMPT_FILE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/lab/machine.h"
#include "experiments/sweep/record.h"

namespace kinex::sweep {

struct Provenance {
  std::string plan_name, plan_hash;
  std::string plan;     // Plan::text
  std::string program;  // program_identity()
  BuildFacts build;
  MachineFacts machine;
  std::string host, command, shard;
  std::string job;      // of a batch system; empty: none
  std::string started;  // UTC
};

std::string provenance_line(const Provenance& provenance);
Provenance parse_provenance(std::string_view line, const std::string& file);

class AttemptFile {
 public:
  // Creates it; nothing that exists is opened. Throws InputError.
  AttemptFile(const std::string& folder, const Shard& shard, const Provenance& provenance);
  ~AttemptFile();
  AttemptFile(const AttemptFile&) = delete;
  AttemptFile& operator=(const AttemptFile&) = delete;

  // The record is on the disk when it returns. Where there is no room for it nothing of it stays,
  // and it throws InputError.
  void append(const Record& record);
  const std::string& path() const { return path_; }

 private:
  void write_line(const std::string& text);

  std::string path_;
  int file_ = -1;
  std::int64_t size_ = 0;
};

// What an attempt file holds.
struct Attempt {
  std::string path;
  Provenance provenance;
  std::vector<Record> records;  // record k is line k + 2
};

// All attempt files of the folders, by name; files without a whole first line are left out. Throws
// InputError for a line that is no record, and where two files come from different programs: their
// records are not mixed.
std::vector<Attempt> read_attempts(const std::vector<std::string>& folders);

}  // namespace kinex::sweep

#endif
