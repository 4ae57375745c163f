// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance: what made a result, as a member of its file.
//
// A summary always has it. The header of an event log has it on request only (kinex run --provenance): a log
// without it is the same, byte for byte, wherever it is made. It is in no digest of events.
#ifndef KINEX_EXPERIMENTS_FORMATS_PROVENANCE_H
#define KINEX_EXPERIMENTS_FORMATS_PROVENANCE_H

#include <string>

#include "experiments/formats/json_node.h"
#include "experiments/formats/json_writer.h"

namespace kinex::formats {

struct Provenance {
  std::string commit;  // of the sources; "unknown" outside of a repository
  bool dirty = false;  // the sources had uncommitted changes
  std::string compiler, flags, libraries;
  std::string cpu;
  std::string command;  // as it was typed
};

// {"commit", "dirty", "compiler", "flags", "libraries", "cpu", "command"}, in this order.
void write_provenance(JsonWriter& json, const Provenance& provenance);
// The inverse. Throws InputError for anything else.
Provenance read_provenance(const JsonNode& node);

}  // namespace kinex::formats

#endif
