// SPDX-License-Identifier: GPL-3.0-or-later
// FCL 0.7: double precision, prisms as fcl::Convex. overlap: its defaults (libccd's GJK inside).
// distance: 0 its default solver, 1 GST_INDEP. Variants of cast: 0 its default solver, which takes
// 10 samples; 1 conservative advancement, 1000 iterations; 2 the same on a bounding volume
// hierarchy of triangles.
//
// The motions are made here, with the origin as reference point. Those that FCL makes from the end
// poses are unusable: its default kind, CCDM_TRANS, omits rotation, and CCDM_LINEAR never sets the
// reference point, so answers depend on uninitialised memory.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "experiments/peers/peer.h"

namespace {

using namespace kinex;
using namespace kinex::peers;
using Vertices = std::vector<fcl::Vector3d>;

struct Solid {
  void make(const PeerShape& shape, double half) {
    n = static_cast<int>(shape.size());
    vertices = std::make_shared<Vertices>();
    for (const double z : {-half, half}) {
      for (const auto& v : shape) vertices->emplace_back(v[0], v[1], z);
    }
    // Bottom, seen from below; top; sides.
    auto faces = std::make_shared<std::vector<int>>();
    faces->push_back(n);
    for (int i = n; i-- > 0;) faces->push_back(i);
    faces->push_back(n);
    for (int i = 0; i < n; ++i) faces->push_back(n + i);
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      for (const int v : {4, i, next, n + next, n + i}) faces->push_back(v);
    }
    convex = std::make_unique<fcl::Convexd>(vertices, n + 2, faces);
    triangles.reset();
  }

  // Made on demand.
  const fcl::CollisionGeometryd* mesh() {
    if (triangles) return triangles.get();
    std::vector<fcl::Triangle> parts;
    const auto part = [&](int i, int j, int k) {
      parts.emplace_back(static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                         static_cast<std::size_t>(k));
    };
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      part(i, next, n + next);
      part(i, n + next, n + i);
      if (i > 0 && next > 0) {
        part(0, next, i);
        part(n, n + i, n + next);
      }
    }
    triangles = std::make_unique<fcl::BVHModel<fcl::OBBRSSd>>();
    triangles->beginModel();
    triangles->addSubModel(*vertices, parts);
    triangles->endModel();
    return triangles.get();
  }

  int n = 0;
  std::shared_ptr<Vertices> vertices;
  std::unique_ptr<fcl::Convexd> convex;
  std::unique_ptr<fcl::BVHModel<fcl::OBBRSSd>> triangles;
};

class Fcl final : public Peer {
 public:
  bool load(const PeerShape& a, const PeerShape& b) override {
    a_.make(a, 1);
    b_.make(b, 0.5);
    return true;
  }

  PeerReply overlap(int, const PeerPose& a, const PeerPose& b) override {
    ++work.steps;
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::collide(a_.convex.get(), transform(a), b_.convex.get(), transform(b), request, result);
    return result.isCollision() ? PeerReply::kHit : PeerReply::kMiss;
  }

  double distance(int variant, const PeerPose& a, const PeerPose& b) override {
    ++work.steps;
    fcl::DistanceRequestd request;
    if (variant == 1) request.gjk_solver_type = fcl::GST_INDEP;
    fcl::DistanceResultd result;
    fcl::distance(a_.convex.get(), transform(a), b_.convex.get(), transform(b), request, result);
    return result.min_distance;
  }

  Cast cast(int variant, const PeerPose& a0, const PeerPose& a1, const PeerPose& b0,
            const PeerPose& b1) override {
    fcl::ContinuousCollisionRequestd request;
    if (variant != 0) {
      request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      request.num_max_iterations = 1000;
    }
    const fcl::CollisionGeometryd* a = a_.convex.get();
    const fcl::CollisionGeometryd* b = b_.convex.get();
    if (variant == 2) {
      a = a_.mesh();
      b = b_.mesh();
    }
    const Motion motion_a = motion(a0, a1), motion_b = motion(b0, b1);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(a, &motion_a, b, &motion_b, request, result);
    if (result.time_of_contact != result.time_of_contact) return {PeerReply::kNotANumber, 0};
    return {result.is_collide ? PeerReply::kHit : PeerReply::kMiss, result.time_of_contact};
  }

 private:
  using Motion = fcl::InterpMotion<double>;
  static Motion motion(const PeerPose& from, const PeerPose& to) {
    const fcl::Transform3d begin = transform(from), end = transform(to);
    return Motion(begin.linear(), begin.translation(), end.linear(), end.translation(),
                  fcl::Vector3d::Zero());
  }
  static fcl::Transform3d transform(const PeerPose& pose) {
    fcl::Transform3d result = fcl::Transform3d::Identity();
    result.rotate(Eigen::AngleAxisd(pose.angle, fcl::Vector3d::UnitZ()));
    result.translation() = fcl::Vector3d(pose.x, pose.y, 0);
    return result;
  }

  Solid a_, b_;
};

}  // namespace

extern "C" kinex::peers::Peer* kinex_make_peer() { return new Fcl; }
