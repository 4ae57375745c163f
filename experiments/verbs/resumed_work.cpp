// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/verbs/resumed_work.h"

#include "experiments/formats/counted.h"
#include "experiments/formats/file_io.h"

namespace kinex::verbs {

ResultFile::ResultFile(std::string path, bool force, sweep::Journal& journal)
    : path_(std::move(path)), force_(force || journal.is_own_output(path_)), journal_(journal) {
  const formats::OutputFile probe(path_, force_);  // leaves nothing behind when the program is killed
}

void ResultFile::write(std::string_view text) const {
  journal_.note_output(path_, text);
  formats::OutputFile file(path_, force_);
  file.write(text);
  file.commit();
}

void tell_what_is_found(const sweep::Journal& journal, const char* one, const char* many,
                        const Voice& voice) {
  if (!journal.runs() || journal.found() == 0) return;
  voice.note("going on: " + formats::counted(journal.found(), one, many) +
             (journal.found() == 1 ? " is" : " are") +
             " finished already; --fresh runs them again");
}

}  // namespace kinex::verbs
