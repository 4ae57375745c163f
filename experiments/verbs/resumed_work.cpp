// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/resumed_work.h"

#include <cstdio>

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"

namespace kinex {

ResultFile::ResultFile(std::string path, bool force, FinishedWork& finished)
    : path_(std::move(path)), force_(force || finished.is_own_output(path_)), finished_(finished) {
  const OutputFile probe(path_, force_);  // leaves nothing behind when the program is killed
}

void ResultFile::write(std::string_view text) const {
  finished_.note_output(path_, text);
  OutputFile file(path_, force_);
  file.write(text);
  file.commit();
}

void tell_what_is_found(const FinishedWork& finished, const char* one, const char* many) {
  if (finished.found() == 0) return;
  std::fprintf(
      stderr, "kinex: going on: %s finished already; --fresh runs them again\n",
      (counted(finished.found(), one, many) + (finished.found() == 1 ? " is" : " are")).c_str());
}

}  // namespace kinex
