// SPDX-License-Identifier: GPL-3.0-or-later
// Methods: the queries that a library offers, and its answers.
#ifndef KINEX_EXPERIMENTS_PEERS_METHOD_H
#define KINEX_EXPERIMENTS_PEERS_METHOD_H

#include <string>
#include <vector>

#include "experiments/peers/case.h"

namespace kinex::peers {

struct PeerMethod {
  enum class Kind {
    kSteps,     // overlap() in poses at equal distances in time
    kAdvance,   // conservative advancement: as far as the bodies cannot meet, by distance()
    kCast,      // the library's continuous test
    kDistance,  // distance() in the first pose, as the answer's time
  };
  std::string name;
  std::string module;  // of the library
  Kind kind = Kind::kCast;
  int variant = 0;             // of overlap or cast
  int steps = 0;               // kSteps
  double stop = 0;             // kAdvance: a contact is a distance of at most this
  double tolerance = 0;        // a contact may be reported at a gap of this size: documented
  bool single = false;         // works on floats
  double most_turn = 3;        // kCast: longer turns are cut into parts below this
  const char* certifies = "";  // the instants that its answer covers: "samples", ..
};

struct PeerAnswer {
  PeerReply reply = PeerReply::kUnsupported;
  double time = 0;  // of the reported contact
  PeerWork work;
  double seconds = 0;       // CPU time of one query; 0 if not measured
  double load_seconds = 0;  // of making the library's shapes
};

// The methods that are compared on all families. Modules that are not there are left out.
std::vector<PeerMethod> peer_methods();
// Fixed steps by a library, for as many steps.
PeerMethod steps_method(const std::string& module, int steps);
// Conservative advancement by a library.
PeerMethod advance_method(const std::string& module, double stop);
bool has_module(const std::string& module);
std::string module_path(const std::string& module);

// Runs the method once. Requires that the peer has loaded the shapes.
PeerAnswer ask(Peer& peer, const PeerMethod& method, const PeerCase& question);

// The largest number of steps of conservative advancement.
inline constexpr std::uint64_t kMostAdvances = 200000;

}  // namespace kinex::peers

#endif
