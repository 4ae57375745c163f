// SPDX-License-Identifier: GPL-3.0-or-later
// EventLog: writes the records of a run as JSON lines, and makes their digest.
//
// Format, version 2: one JSON object a line. Members come in the order in which they are given
// here; nothing else may be there. Nothing in a log depends on the machine.
//
// Header, the first line:
//   "format": "kinex-log", "version": 2
//   "scene": NAME, "scene_hash": HEX    of the scene's file
//   "arithmetic": A, "exact": BOOLEAN
//   "instants": "names", "intervals" or "none"    the detail in which records give instants
//   "build": "kinex VERSION"
//   "structures": [{"label", "structure", "key", "options", "kinds"}, ..]    in the order of the run
//       "key": only for a structure that orders by a key, written as in a scene's "maintain"
//       "options": {"over": .., PARAMETER: ..} as there; only if something is not as usual
//       "kinds": its own, then "motion", "insert", "erase", "settled", "rebuild"
//   "objects": [ID, ..]    the scene's, in its order
//
// Record, one for each event and each change of the scene:
//   "seq": K              from 1
//   "structure": LABEL, "kind": KIND, "ids": [ID, ..]
//   "certificate": {"predicate": NAME, "ids": [ID, ..]}    the one that failed, or null
//   "external": BOOLEAN   the attribute changed
//   "reason": TEXT        of a rebuild only
//   "gone": .., "came": ..    the change of the attribute if the ids do not determine it (in every
//       "settled", and in a "rebuild" that changed it)
//       edges: those removed and those added, as arrays of pairs, in the scene's order within and
//         between pairs
//       sequence, cycle, object: the whole attribute before and after, as arrays of ids
//   "time": {..}          none where "instants" is "none"
//     exact, "names":      {"polynomial": [C, ..], "root": K, "interval": [A, B], "decimal": D}
//     exact, "intervals":  {"interval": [A, B], "decimal": D}
//     inexact:             {"decimal": D}
//     polynomial  primitive, square-free, positive leading coefficient; low degree first
//     root        the place of the instant among its real roots, from 1
//     interval    ends are dyadic and no roots, and the instant is the only root in it; A = B for a
//                 rational instant, whose polynomial is linear
//     decimal     for readers, truncated towards zero to 12 significant digits
//                 (core/numbers/instant_digits.h)
//
// Kinds of all structures:
//   motion         the flight plan of an object changed; its consequences are reported after it
//   insert, erase  an object came or went; the attribute changes as inserting or erasing does
//   settled        the end of an instant: changes that its external events have not reported
//   rebuild        the structure was built anew
// Replaying a structure's external records, insertions and erasures gives its attribute right after
// every instant.
//
// Last line:
//   "end": "done", "limit" or "interrupted"
//   "reached": T or null    the run is valid up to this time; null: for all time (no end)
//   "records": N, "external": N
//   "corrupt": {LABEL: TEXT, ..}    structures that an inexact arithmetic led into an impossible
//       state, in the order of the run, each with what was found and when; they have no records
//       from then on. Only if there are any
//   "digest": HEX           see log_digest.h
//   "seal": HEX             SHA-256 of the file up to and including the quotation mark before it
#ifndef KINEX_EXPERIMENTS_FORMATS_EVENT_LOG_H
#define KINEX_EXPERIMENTS_FORMATS_EVENT_LOG_H

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/event.h"
#include "core/engine/simulator.h"
#include "core/numbers/instant_name.h"
#include "experiments/formats/file_io.h"
#include "experiments/formats/log_digest.h"
#include "experiments/formats/provenance.h"
#include "experiments/formats/sha256.h"

namespace kinex::formats {

class JsonWriter;

inline constexpr std::string_view kLogFormat = "kinex-log";
inline constexpr int kLogVersion = 2;

class EventLog final : public EventSink {
 public:
  // Requires a simulator with its structures. Without a file only the digest is computed, and no
  // instant is named. A provenance goes into the header.
  EventLog(const Simulator& simulator, std::string_view scene_hash, OutputFile* file,
           InstantDetail instants = InstantDetail::kName,
           const std::optional<Provenance>& provenance = std::nullopt);

  // For a log without a file: pass it to Simulator::set_sink untimed, and let it charge the clock
  // for hashing.
  void charge_to(RunClock& clock) { digest_.charge_to(clock); }

  void event(const Event& event, Arithmetic& arithmetic) override;
  void instant_ended() override;
  void instant_abandoned() override;
  // Writes the last line and gives the file its name.
  void finish(RunStatus status);

  std::uint64_t records() const { return records_; }
  std::string digest() { return digest_.hex(); }

 private:
  void write_header(std::string_view scene_hash, const std::optional<Provenance>& provenance);
  // To pending_:
  void append_record(const Event& event, Arithmetic& arithmetic);
  void append_name(ObjectId id);
  void append_ids(std::span<const ObjectId> ids);
  void append_side(std::span<const ObjectId> ids, StructureId structure);
  void append_instant(Arithmetic& arithmetic);
  void write_corrupt(JsonWriter& json) const;
  void write_line();

  const Simulator& simulator_;
  OutputFile* file_;
  std::vector<DigestedStructure> structures_;
  std::vector<std::size_t> widths_;  // of the tuples of the attribute; 0: it is no set of tuples
  // JSON: what follows "seq" in a record, by structure and kind, and the scene's objects.
  std::vector<std::vector<std::string>> heads_;
  std::vector<std::string> names_;
  std::string line_;
  std::uint64_t records_ = 0;
  std::uint64_t external_ = 0;
  LogDigest digest_;
  Sha256 seal_;
  InstantDetail instants_;
  std::string instant_;               // the last "time" that was written ..
  std::uint64_t instant_number_ = 0;  // .. and the number of its name
  // The records of the present instant, which may be abandoned; and the counts before it.
  std::string pending_;
  std::uint64_t settled_records_ = 0;
  std::uint64_t settled_external_ = 0;
};

// "names", "intervals", "none": as headers and options say it.
std::string_view detail_name(InstantDetail detail);

// The program's name and version, as logs and summaries give it.
std::string build_name();

}  // namespace kinex::formats

#endif
