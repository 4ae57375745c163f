// SPDX-License-Identifier: GPL-3.0-or-later
// Journal: the records of an experiment while it runs (cell_source.h), in one file beside its results,
// from which the same command goes on, however it was stopped; or the records of a sweep that was run
// elsewhere.
//
// The file is like an attempt file: provenance, then a record a line; and lines that name the
// results that were written from it.
#ifndef KINEX_EXPERIMENTS_SWEEP_JOURNAL_H
#define KINEX_EXPERIMENTS_SWEEP_JOURNAL_H

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "experiments/sweep/attempt_file.h"
#include "experiments/sweep/settled.h"

namespace kinex::sweep {

// What becomes of the records that an interrupted run has left in the file.
enum class Leftover {
  kKeep,     // they are used; those of another program, or of another plan, are refused
  kKeepOwn,  // they are used; those of another program, or of another plan, are dropped
  kDrop,     // they are dropped
};

// Called from any thread. Errors are InputErrors.
class Journal {
 public:
  // One process at a time uses the file.
  Journal(std::string path, const AttemptProvenance& provenance, Leftover leftover);
  // The settled records of attempts, without a file: nothing is added.
  explicit Journal(const std::vector<Attempt>& attempts);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // nullptr: there is none, or its process was ended from outside. It stays where it is.
  const Record* find(const std::string& key) const;
  // Written with one write: a killed program leaves whole lines and at most part of the last one,
  // which is dropped. Returns it as it will be read back.
  const Record& add(const Record& record);
  std::size_t found() const { return found_; }  // records that the file had at first
  // Seconds by the clock that the cells of those records took: the sum, without killed ones.
  double found_seconds() const { return found_seconds_; }
  // Whose records it had and dropped (kKeepOwn): "another version of the program". Empty: none.
  const std::string& dropped_other() const { return dropped_other_; }
  const std::string& path() const { return path_; }
  bool runs() const { return file_ >= 0; }      // cells that it does not have are to be run

  // Incomplete results are written too, so that they can be read. They may be replaced by the
  // complete ones unless the file has been changed since.
  void note_output(const std::string& path, std::string_view text);  // before it is written
  bool is_own_output(const std::string& path) const;

  // Everything is finished and written.
  void remove();

 private:
  std::string name_of(const std::string& path) const;
  void read_lines(const std::string& text);
  void append(const std::string& line);
  void note_found();

  std::string path_;
  int file_ = -1;
  std::int64_t size_ = 0;  // of the file
  std::size_t found_ = 0;
  double found_seconds_ = 0;
  std::string dropped_other_;
  mutable std::mutex mutex_;
  std::map<std::string, Record> records_;       // by key
  std::map<std::string, std::string> outputs_;  // digests by name_of()
};

}  // namespace kinex::sweep

#endif
