// SPDX-License-Identifier: GPL-3.0-or-later
// FinishedWork: the finished pieces of a long experiment, in a file beside its results, from which
// the same command resumes, however it was stopped.
#ifndef KINEX_EXPERIMENTS_LAB_FINISHED_WORK_H
#define KINEX_EXPERIMENTS_LAB_FINISHED_WORK_H

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

// One line for each piece, appended with one write: a killed program leaves whole lines and at most
// part of the last one, which is dropped. Called from any thread. Errors are InputErrors.
class FinishedWork {
 public:
  // `program`: program_identity(); pieces of another program are refused. `fresh`: begins anew
  // whatever the file holds. One process at a time uses the file.
  FinishedWork(std::string path, const std::string& program, bool fresh);
  ~FinishedWork();
  FinishedWork(const FinishedWork&) = delete;
  FinishedWork& operator=(const FinishedWork&) = delete;

  // UTF-8 text.
  std::optional<std::string> find(const std::string& key) const;
  void add(const std::string& key, const std::string& data);
  std::size_t found() const { return found_; }  // pieces that the file had at first

  // Incomplete results are written too, so that they can be read. They may be replaced by the
  // complete ones unless the file has been changed since.
  void note_output(const std::string& path, std::string_view text);  // before it is written
  bool is_own_output(const std::string& path) const;

  // Everything is finished and written.
  void remove();

 private:
  void append(const std::string& line);

  std::string path_;
  int file_ = -1;
  std::size_t found_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, std::string> pieces_;
};

}  // namespace kinex

#endif
