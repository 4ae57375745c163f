// SPDX-License-Identifier: GPL-3.0-or-later
// LogDigest: the SHA-256 that identifies the events of a run and their order, independent of the
// machine, the arithmetic and the detail of a log.
//
// It is taken over bytes, not over JSON, so that a run can have one without writing a log:
//   "kinex-digest 2\n"
//   [[LABEL,STRUCTURE,[KIND,..]],..] + "\n"    compact JSON (below), the structures of the run
//   [ID,..] + "\n"                             compact JSON, the scene's objects in its order
//   and for every record
//     u8 structure    place in the first array
//     u8 kind         place in its list
//     u8 flags        bit 0: "external"; bit 1: the record has "gone" and "came"
//     u8 number of ids, the ids
//     if flags has bit 1: u32 number of ids in "gone" (pairs flattened), the ids, and the same for
//     "came"
//   An id is the u32 place of the object in the scene's order; of a derived object it is
//   0xffffffff, the u32 length of its name in bytes, and the name in UTF-8. u32 are little-endian.
// Compact JSON has no spaces; in strings only '"' and '\' (with a '\' before them) and the bytes
// below 0x20 and 0x7f (as \u00xx, lower-case) are escaped.
#ifndef KINEX_EXPERIMENTS_FORMATS_LOG_DIGEST_H
#define KINEX_EXPERIMENTS_FORMATS_LOG_DIGEST_H

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/engine/event.h"
#include "core/engine/run_clock.h"
#include "experiments/formats/sha256.h"

namespace kinex {
class Simulator;
}  // namespace kinex

namespace kinex::formats {

// A log's description of a structure, without its key and options.
struct DigestedStructure {
  std::string label, structure;
  std::vector<std::string> kinds;
};

class LogDigest {
 public:
  LogDigest(const std::vector<DigestedStructure>& structures,
            const std::vector<std::string>& objects);
  // For a run that is about to start. Requires a simulator with its structures.
  explicit LogDigest(const Simulator& simulator);

  // One event of `simulator`'s run.
  void add(const Event& event, const Simulator& simulator);

  // Or a record in parts: its head, then its ids, then, for a difference, twice a count and the
  // ids.
  void head(std::uint8_t structure, std::uint8_t kind, bool external, bool difference,
            std::size_t ids);
  void object(std::uint32_t place) { put(place); }
  void derived(std::string_view name);
  void count(std::size_t ids) { put(static_cast<std::uint32_t>(ids)); }

  // Hashing time is charged to RunPhase::kReport of this clock, which must outlive the digest.
  void charge_to(RunClock& clock) { clock_ = &clock; }
  // From now on additions since the last settle() can be taken back.
  void hold() { holds_ = true; }
  void settle() { settled_ = used_; }
  void take_back() { used_ = settled_; }

  // 64 lower-case hexadecimal digits of everything added so far.
  std::string hex();

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 14;

  void begin(const std::vector<DigestedStructure>& structures,
             const std::vector<std::string_view>& objects);
  void add_ids(std::span<const ObjectId> ids, const Simulator& simulator);
  void put(std::uint32_t number);
  void make_room(std::size_t bytes) {
    if (used_ + bytes > size_) flush(bytes);
  }
  // Hashes what cannot be taken back; then there is room for `bytes` more.
  void flush(std::size_t bytes);

  std::size_t objects_ = 0;  // of the scene
  std::unique_ptr<char[]> block_ = std::make_unique<char[]>(kBlock);
  std::size_t size_ = kBlock, used_ = 0;
  std::size_t settled_ = 0;  // bytes of the block that cannot be taken back
  bool holds_ = false;
  RunClock* clock_ = nullptr;
  Sha256 hash_;
};

// The structures of a simulator, as a log lists them.
std::vector<DigestedStructure> digested_structures(const Simulator& simulator);

}  // namespace kinex::formats

#endif
