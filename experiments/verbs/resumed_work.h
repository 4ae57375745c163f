// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of verbs that resume after an interruption (sweep/journal.h).
#ifndef KINEX_EXPERIMENTS_VERBS_RESUMED_WORK_H
#define KINEX_EXPERIMENTS_VERBS_RESUMED_WORK_H

#include <string>
#include <string_view>
#include <utility>

#include "experiments/sweep/journal.h"
#include "experiments/verbs/voice.h"

namespace kinex::verbs {

// A file of results. A resumed run replaces the output of the interrupted one without --force. The
// constructor throws InputError if the file cannot be written.
class ResultFile {
 public:
  ResultFile(std::string path, bool force, sweep::Journal& journal);
  void write(std::string_view text) const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool force_;
  sweep::Journal& journal_;
};

// A note, if there are any: "12 experiments are finished already".
void tell_what_is_found(const sweep::Journal& journal, const char* one, const char* many,
                        const Voice& voice);

}  // namespace kinex::verbs

#endif
