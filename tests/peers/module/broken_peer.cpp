// SPDX-License-Identifier: GPL-3.0-or-later
// The x of the second body's pose decides: below 1 a miss, below 2 it dies, then it never ends.
#include <unistd.h>
#include <csignal>

#include "experiments/peers/peer.h"

namespace {

class Broken final : public kinex::peers::Peer {
 public:
  bool load(const kinex::peers::PeerShape& a, const kinex::peers::PeerShape&) override { return a.size() < 9; }
  kinex::peers::PeerReply overlap(int, const kinex::peers::PeerPose&, const kinex::peers::PeerPose& b) override {
    if (b.x < 1) return kinex::peers::PeerReply::kMiss;
    if (b.x < 2) raise(SIGKILL);
    for (;;) pause();
  }
  double distance(int, const kinex::peers::PeerPose&, const kinex::peers::PeerPose&) override { return 0; }
  Cast cast(int, const kinex::peers::PeerPose&, const kinex::peers::PeerPose&, const kinex::peers::PeerPose&,
            const kinex::peers::PeerPose&) override {
    return {};
  }
};

}  // namespace

extern "C" kinex::peers::Peer* kinex_make_peer() { return new Broken; }
