// SPDX-License-Identifier: GPL-3.0-or-later
// MixedTiles without a simulator: two polygons in any pose, and a point in any motion.
#ifndef KINEX_TESTS_STRUCTURES_COLLISION_TILE_BENCH_H
#define KINEX_TESTS_STRUCTURES_COLLISION_TILE_BENCH_H

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "core/engine/scheduler.h"
#include "predicates/bodies/pose_2.h"
#include "tests/structures/collision/scene_of_bodies.h"
#include "tests/structures/collision/tile_geometry.h"

namespace kinex::test {

// A at rest, and B with any motion from t = 0 on.
struct Bench {
  // `b` is B' itself, not B.
  Bench(const Polygon& a, const Polygon& b, CutPolicy policy)
      : scene(scene_of_bodies(
            {rigid("a", a, {{0}, {0}, {1}, {0}}), rigid("b", b, {{0, 1}, {0, 1}, {1, 1}, {0, 1}})},
            0, std::nullopt)),
        kernel(make_arithmetic("exact", scene, needs(scene)), 2),
        constants(kernel),
        frames{BodyFrame(OuterHierarchy(frame_polygon(a, false), policy), constants),
               BodyFrame(OuterHierarchy(frame_polygon(b, false), policy), constants)},
        predicates(kernel) {
    kernel.arithmetic().set_now(0);
    for (ObjectId id = 0; id < 2; ++id) {
      kernel.set_motion(id, scene.objects[id].motion.pieces[0].trajectory, std::nullopt);
    }
    const std::array<ObjectId, 2> bases{0, 1};
    pose = kernel.derive("a|b", make_pose_2(), bases);
    tiles = std::make_unique<MixedTiles>(kernel, predicates, pose,
                                         std::array<BodyFrame*, 2>{&frames[0], &frames[1]});
    for (std::uint8_t z = 0; z < 2; ++z) {
      const OuterHierarchy& tree = frames[z].hierarchy();
      for (std::uint32_t v = 0; v < 4; ++v) {
        if (tree.node(v).cut == OuterHierarchy::kNone) continue;
        offset[z] = tiles->level({Tile::Kind::kTriangle, z, v, 0}) - 1 - tree.node(v).cut_level;
      }
    }
  }
  static NumberNeeds needs(const Scene& scene) {
    NumberNeeds needs = needs_of_objects(scene);
    needs.add(pose_2_kind(scene));
    return needs;
  }
  // The point is at p and moves by d; the rotor is p + iq.
  void move(const Vertex2& p, const Vertex2& d, std::vector<Rational> rotor_p,
            std::vector<Rational> rotor_q) {
    kernel.set_motion(1, path({{p[0], d[0]}, {p[1], d[1]}, std::move(rotor_p), std::move(rotor_q)}),
                      std::nullopt);
  }
  void place(const Vertex2& p, const Vertex2& rotor) { move(p, {0, 0}, {rotor[0]}, {rotor[1]}); }
  TileGeometry geometry(const Vertex2& rotor, bool b_first = false) const {
    return {frames[0].hierarchy(), frames[1].hierarchy(), offset, rotor, b_first};
  }
  Sign sign(const Query& query) { return kernel.arithmetic().sign_after(query); }
  // The first certificate that is negative right after now; the count if none is.
  std::uint32_t failing(const Tile& tile) {
    const MixedTiles::Certificates proof = tiles->certificates(tile);
    std::uint32_t slot = 0;
    while (slot < proof.count && sign(proof.query[slot]) != Sign::kNegative) ++slot;
    return slot;
  }
  // Moves on until the tile holds. Flat tiles on the way occur only where normals are identically
  // parallel.
  MixedTiles::Move settled(MixedTiles::Move move, bool flat_tiles) {
    for (int moves = 0; move.tile && !holds(*move.tile); ++moves) {
      EXPECT_TRUE(flat_tiles) << "a tile that does not hold";
      EXPECT_LT(moves, 30);
      const auto next = tiles->next(*move.tile, failing(*move.tile));
      if (!flat_tiles || moves >= 30 || !next) break;
      move = *next;
    }
    return move;
  }
  bool holds(const Tile& tile) { return failing(tile) == tiles->certificates(tile).count; }

  Scene scene;
  Scheduler kernel;
  FrameConstants constants;
  std::array<BodyFrame, 2> frames;
  PosePredicates predicates;
  ObjectId pose = kNoObject;
  std::unique_ptr<MixedTiles> tiles;
  std::array<int, 2> offset{};
};

}  // namespace kinex::test

#endif
