// SPDX-License-Identifier: GPL-3.0-or-later
// EventLog: writes the events of a run as JSON lines, and their digest.
//
// First line: {"format": "kinex-log", "version": 1, "scene": NAME, "scene_hash": HEX, "arithmetic":
// A,
//   "exact": BOOLEAN, "build": "kinex VERSION",
//   "structures": [{"label": L, "structure": NAME, "kinds": [..]}]}
// One line an event: {"seq": K, "structure": L, "kind": S, "ids": [..],
//   "certificate": {"predicate": S, "ids": [..]} or null (a change of the scene),
//   "external": BOOLEAN, "time": {"polynomial": [..], "root": K, "interval": ["a", "b"], "decimal":
//   S}} where an inexact arithmetic gives "decimal" alone.
// Last line: {"end": STATUS, "events": K, "digest": HEX}
//
// The digest is the SHA-256 of one line ["LABEL", "KIND", "ID", ..] and "\n" for each event: it
// names what happened and in which order, not when. There is nothing in a log that depends on the
// machine.
#ifndef KINEX_EXPERIMENTS_EVENT_LOG_H
#define KINEX_EXPERIMENTS_EVENT_LOG_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/event.h"
#include "core/simulator.h"
#include "experiments/file_io.h"
#include "experiments/sha256.h"

namespace kinex {

inline constexpr std::string_view kLogFormat = "kinex-log";
inline constexpr int kLogVersion = 1;

// The line that an event adds to the digest.
std::string digest_line(std::string_view label, std::string_view kind,
                        const std::vector<std::string_view>& ids);

class EventLog final : public EventSink {
 public:
  // `simulator` has its structures. Without a file only the digest is made, and no instant is
  // described.
  EventLog(const Simulator& simulator, std::string_view scene_hash, OutputFile* file);

  void event(const Event& event, Arithmetic& arithmetic) override;
  // Writes the last line and gives the file its name.
  void finish(RunStatus status);

  std::uint64_t events() const { return events_; }
  std::string digest() const { return digest_.hex(); }

 private:
  void write_line(const Event& event, std::string_view kind, Arithmetic& arithmetic);

  const Simulator& simulator_;
  OutputFile* file_;
  std::vector<std::vector<std::string>> kinds_;
  std::string line_;
  std::uint64_t events_ = 0;
  Sha256 digest_;
};

// The program's name and version, as logs and summaries give it.
std::string build_name();

}  // namespace kinex

#endif
