// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/proof_data.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "experiments/trade/binary_scale.h"
#include "experiments/view/data_writer.h"

namespace kinex {

namespace {

std::string_view kind_name(FrameFeature::Kind kind) {
  switch (kind) {
    case FrameFeature::Kind::kNone:
      return "";
    case FrameFeature::Kind::kVertex:
      return "vertex";
    case FrameFeature::Kind::kEdge:
      return "edge";
    case FrameFeature::Kind::kAcross:
      return "across";
    case FrameFeature::Kind::kCorner:
      return "corner";
    case FrameFeature::Kind::kSupport:
      return "support";
  }
  return "";
}

std::string_view kind_name(Tile::Kind kind) {
  switch (kind) {
    case Tile::Kind::kTriangle:
      return "triangle";
    case Tile::Kind::kLeft:
      return "left";
    case Tile::Kind::kRight:
      return "right";
    case Tile::Kind::kHalf:
      return "half";
  }
  return "";
}

void write_feature(JsonWriter& json, const FrameFeature& feature) {
  if (feature.kind == FrameFeature::Kind::kNone) {
    json.number(0);
    return;
  }
  json.begin_array().string(kind_name(feature.kind));
  json.number(std::uint64_t{feature.first}).number(std::uint64_t{feature.last}).end_array();
}

void write_claims(JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things) {
  json.key("claims").begin_array();
  for (const RecordedClaim& claim : run.claims) {
    json.begin_array().number(int{claim.predicate}).begin_array();
    for (const ObjectId id : claim.arguments) json.number(std::uint64_t{things.shown(index, id)});
    json.end_array().begin_array();
    for (const FrameFeature& feature : claim.features) write_feature(json, feature);
    json.end_array().end_array();
  }
  json.end_array();
}

void write_proof(JsonWriter& json, const PairProof& proof) {
  json.begin_array().number(proof.event);
  write_ids(json, proof.claims);
  if (proof.tile) {
    json.begin_array().string(kind_name(proof.tile->kind)).number(int{proof.tile->x});
    json.number(std::uint64_t{proof.tile->v}).number(std::uint64_t{proof.tile->other}).end_array();
  } else {
    json.number(0);
  }
  json.end_array();
}

}  // namespace

ShownThings::ShownThings(const std::vector<RecordedRun>& runs) : objects_(runs.front().objects) {
  std::map<std::string_view, ObjectId> known;
  for (const RecordedRun& run : runs) {
    std::vector<ObjectId>& shown = shown_.emplace_back();
    for (const RecordedThing& thing : run.things) {
      const auto [place, is_new] =
          known.try_emplace(thing.name, static_cast<ObjectId>(objects_ + things_.size()));
      if (is_new) things_.push_back(&thing);
      shown.push_back(place->second);
    }
  }
}

void ShownThings::write(JsonWriter& json, const Rational& scale) const {
  json.key("things").begin_array();
  for (const RecordedThing* thing : things_) {
    json.begin_array().string(thing->name);
    const std::vector<Rational>& c = thing->coordinates;
    if (c.size() != 3) {
      json.number(0).end_array();
      continue;
    }
    const Rational size = std::max(absolute(c[0]), absolute(c[1]));
    json.begin_array();
    for (std::size_t i = 0; i < 3; ++i) {
      if (size.is_zero()) {
        json.null();
      } else {
        write_double(json, (i < 2 ? c[i] / size : c[i] / size / scale).to_double());
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (c[2].is_zero()) {
        json.null();
      } else {
        write_double(json, (c[i] / c[2] / scale).to_double());
      }
    }
    json.end_array().end_array();
  }
  json.end_array();
}

void write_proofs(JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things) {
  write_claims(json, run, index, things);
  json.key("proofs").begin_array();
  for (const RecordedStructure& structure : run.structures) {
    json.begin_array();
    for (const PairHistory& history : structure.pairs) {
      json.begin_array().number(std::uint64_t{history.a}).number(std::uint64_t{history.b});
      json.begin_array();
      for (const PairProof& proof : history.proofs) write_proof(json, proof);
      json.end_array().end_array();
    }
    json.end_array();
  }
  json.end_array();
}

}  // namespace kinex
