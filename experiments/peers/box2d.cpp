// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D 2.4: single precision. Polygons of up to 255 vertices by raw vertex arrays; its own
// polygon shapes take 8. overlap and distance: b2Distance, started from its cache. cast:
// b2TimeOfImpact, which stops at a gap of 0.005 with a tolerance of 0.00125.
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include <limits>

#include "experiments/peers/peer.h"

// Counters that the library exports and declares in no header.
extern B2_API int32 b2_gjkIters, b2_toiIters;

namespace {

using namespace kinex;
using namespace kinex::peers;

class Box2d final : public Peer {
 public:
  bool load(const PeerShape& a, const PeerShape& b) override {
    return put(a, vertices_a_, a_) && put(b, vertices_b_, b_);
  }

  PeerReply overlap(int, const PeerPose& a, const PeerPose& b) override {
    const double d = distance(0, a, b);
    if (d != d) return PeerReply::kNotANumber;
    return d <= 0 ? PeerReply::kHit : PeerReply::kMiss;
  }

  double distance(int, const PeerPose& a, const PeerPose& b) override {
    b2DistanceInput input;
    input.proxyA = a_;
    input.proxyB = b_;
    input.transformA = transform(a);
    input.transformB = transform(b);
    input.useRadii = false;
    b2DistanceOutput output;
    b2Distance(&output, &cache_, &input);
    ++work.steps;
    work.iterations += static_cast<std::uint64_t>(output.iterations);
    work.supports += 2 * static_cast<std::uint64_t>(output.iterations);
    return static_cast<double>(output.distance);
  }

  Cast cast(int, const PeerPose& a0, const PeerPose& a1, const PeerPose& b0,
            const PeerPose& b1) override {
    b2TOIInput input;
    input.proxyA = a_;
    input.proxyB = b_;
    input.sweepA = sweep(a0, a1);
    input.sweepB = sweep(b0, b1);
    input.tMax = 1;
    b2TOIOutput output;
    const int32 iterations = b2_gjkIters, steps = b2_toiIters;
    b2TimeOfImpact(&output, &input);
    work.iterations += static_cast<std::uint64_t>(b2_gjkIters - iterations);
    work.steps += static_cast<std::uint64_t>(b2_toiIters - steps);
    Cast result{PeerReply::kFailed, static_cast<double>(output.t)};
    if (result.time != result.time) result.reply = PeerReply::kNotANumber;
    if (output.state == b2TOIOutput::e_separated) result.reply = PeerReply::kMiss;
    if (output.state == b2TOIOutput::e_touching || output.state == b2TOIOutput::e_overlapped) {
      result.reply = PeerReply::kHit;
    }
    return result;
  }

  void forget() override { cache_.count = 0; }

 private:
  static bool put(const PeerShape& shape, std::vector<b2Vec2>& vertices, b2DistanceProxy& proxy) {
    if (shape.size() > 255) return false;
    vertices.clear();
    for (const auto& v : shape) {
      vertices.emplace_back(static_cast<float>(v[0]), static_cast<float>(v[1]));
    }
    proxy.Set(vertices.data(), static_cast<int32>(vertices.size()), b2_polygonRadius);
    return true;
  }
  static b2Transform transform(const PeerPose& pose) {
    return b2Transform(b2Vec2(static_cast<float>(pose.x), static_cast<float>(pose.y)),
                       b2Rot(static_cast<float>(pose.angle)));
  }
  static b2Sweep sweep(const PeerPose& from, const PeerPose& to) {
    b2Sweep result;
    result.localCenter.SetZero();
    result.c0.Set(static_cast<float>(from.x), static_cast<float>(from.y));
    result.c.Set(static_cast<float>(to.x), static_cast<float>(to.y));
    result.a0 = static_cast<float>(from.angle);
    result.a = static_cast<float>(to.angle);
    result.alpha0 = 0;
    return result;
  }

  std::vector<b2Vec2> vertices_a_, vertices_b_;
  b2DistanceProxy a_, b_;
  b2SimplexCache cache_{0, 0, {0, 0, 0}, {0, 0, 0}};
};

}  // namespace

extern "C" kinex::peers::Peer* kinex_make_peer() { return new Box2d; }
