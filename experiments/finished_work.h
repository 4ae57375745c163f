// SPDX-License-Identifier: GPL-3.0-or-later
// FinishedWork: the finished pieces of a long experiment, in a file beside its results, so that the
// same command goes on where it was stopped, in whatever way.
#ifndef KINEX_EXPERIMENTS_FINISHED_WORK_H
#define KINEX_EXPERIMENTS_FINISHED_WORK_H

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace kinex {

// A line for each piece, appended with one write: what a killed program leaves is whole lines and
// at most a part of the last one, which is dropped. Called from any thread. Errors are InputErrors.
class FinishedWork {
 public:
  // `program`: what identifies the program (program_identity()): pieces that another one made are
  // refused. `fresh`: begins anew whatever the file holds. One process at a time uses the file.
  FinishedWork(std::string path, const std::string& program, bool fresh);
  ~FinishedWork();
  FinishedWork(const FinishedWork&) = delete;
  FinishedWork& operator=(const FinishedWork&) = delete;

  // UTF-8 text.
  std::optional<std::string> find(const std::string& key) const;
  void add(const std::string& key, const std::string& data);
  std::size_t found() const { return found_; }  // pieces that the file had at first

  // Results that are not complete are written too, so that they can be read. They may be replaced
  // by the complete ones as long as they are what was written.
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
