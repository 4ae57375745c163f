// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/feature_members.h"

#include <algorithm>
#include <utility>

#include "core/numbers/show_number.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"

namespace kinex::formats {

namespace {

constexpr const char* kRemedy = "remove it: the places have been changed";

[[noreturn]] void refuse(const FeatureMembers& members, const char* name,
                         const std::string& problem) {
  throw InputError(members.file, members.path + "/" + name, problem, kRemedy);
}

std::vector<std::array<Rational, 2>> read_pairs(const JsonNode& node) {
  node.require_array();
  std::vector<std::array<Rational, 2>> pairs;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const JsonNode pair = node.at(i);
    pair.require_array();
    if (pair.size() != 2) pair.fail(counted(pair.size(), "number", "numbers"), "write two");
    pairs.push_back({pair.at(0).rational(), pair.at(1).rational()});
  }
  return pairs;
}

FeatureMembers::Bound read_bound(const JsonNode& node) {
  if (node.is(JsonValue::Kind::kNull)) return std::nullopt;
  return node.rational();
}

std::string read_name(const JsonNode& node) {
  if (node.string().empty()) node.fail("an empty name", "write a name, or remove it");
  return std::string(node.string());
}

void write_pairs(JsonWriter& json, const std::vector<std::array<Rational, 2>>& pairs) {
  json.begin_array();
  for (const auto& pair : pairs) json.begin_array().quoted(pair[0]).quoted(pair[1]).end_array();
  json.end_array();
}

}  // namespace

FeatureMembers read_members(const JsonNode& node, const std::string& file) {
  FeatureMembers members;
  members.file = file;
  members.path = node.path();
  if (!node.is(JsonValue::Kind::kObject)) return members;
  if (const auto weight = node.find("weight")) members.weight = weight->rational();
  if (const auto colour = node.find("colour")) members.colour = read_name(*colour);
  if (const auto ends = node.find("ends")) {
    ends->require_array();
    for (std::size_t i = 0; i < ends->size(); ++i) members.ends.push_back(read_name(ends->at(i)));
    if (members.ends.size() != 2 || members.ends[0] == members.ends[1]) {
      ends->fail("not the ends of an edge", "write two different vertices");
    }
  }
  if (const auto polygon = node.find("polygon")) members.polygon = read_pairs(*polygon);
  if (const auto rotors = node.find("rotors")) {
    members.rotors = read_pairs(*rotors);
    for (std::size_t i = 0; i < members.rotors.size(); ++i) {
      if (!members.rotors[i][0].is_zero() || !members.rotors[i][1].is_zero()) continue;
      rotors->at(i).fail("a rotor [0, 0]", "write [1, 0] for no turn");
    }
  }
  if (const auto from = node.find("from")) members.from = read_bound(*from);
  if (const auto to = node.find("to")) members.to = read_bound(*to);
  if (const auto cuts = node.find("cuts")) {
    cuts->require_array();
    for (std::size_t i = 0; i < cuts->size(); ++i) members.cuts.push_back(cuts->at(i).rational());
  }
  return members;
}

void write_members(JsonWriter& json, const FeatureMembers& members) {
  if (members.weight) json.key("weight").quoted(*members.weight);
  if (!members.colour.empty()) json.key("colour").string(members.colour);
  if (!members.ends.empty()) json.key("ends").value(members.ends);
  if (!members.polygon.empty()) write_pairs(json.key("polygon"), members.polygon);
  if (!members.rotors.empty()) write_pairs(json.key("rotors"), members.rotors);
  for (const auto& [name, bound] : {std::pair("from", &members.from), {"to", &members.to}}) {
    if (!*bound) continue;
    json.key(name);
    **bound ? json.quoted(***bound) : json.null();
  }
  if (members.cuts.empty()) return;
  json.key("cuts").begin_array();
  for (const Rational& t : members.cuts) json.quoted(t);
  json.end_array();
}

std::vector<Vertex2> turned(const std::vector<Vertex2>& polygon, const Rational& p,
                            const Rational& q) {
  const Rational norm = p * p + q * q, cosine = (p * p - q * q) / norm,
                 sine = Rational(2) * p * q / norm;
  std::vector<Vertex2> result;
  for (const Vertex2& v : polygon) {
    result.push_back({cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1]});
  }
  return result;
}

void join_pieces(Motion& motion) {
  std::vector<MotionPiece> joined;
  for (MotionPiece& piece : motion.pieces) {
    if (!joined.empty() && joined.back().to == piece.from &&
        joined.back().trajectory == piece.trajectory) {
      joined.back().to = piece.to;
    } else {
      joined.push_back(std::move(piece));
    }
  }
  motion.pieces = std::move(joined);
}

void open_ends(Motion& motion, const Rational& start, const Rational& end) {
  MotionPiece& first = motion.pieces.front();
  MotionPiece& last = motion.pieces.back();
  if (first.from != start || last.to != end) return;
  first.from.reset();
  last.to.reset();
}

void note_pieces(const Motion& found, const Motion& wanted, FeatureMembers& members) {
  const FeatureMembers::Bound& from = wanted.pieces.front().from;
  const FeatureMembers::Bound& to = wanted.pieces.back().to;
  if (from != found.pieces.front().from) members.from = from;
  if (to != found.pieces.back().to) members.to = to;
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < wanted.pieces.size(); ++i) {
    if (wanted.pieces[i].to == found.pieces[at].to) {
      ++at;
    } else {
      members.cuts.push_back(*wanted.pieces[i].to);
    }
  }
}

void restore_pieces(const FeatureMembers& members, const Rational& start, const Rational& end,
                    const Rational& shift, Motion& motion) {
  std::vector<MotionPiece>& pieces = motion.pieces;
  for (const Rational& cut : members.cuts) {
    const Rational t = cut + shift;
    const auto piece = std::find_if(pieces.begin(), pieces.end(), [&](const MotionPiece& one) {
      return (!one.from || *one.from < t) && (!one.to || t < *one.to);
    });
    if (piece == pieces.end()) refuse(members, "cuts", "no piece goes on at " + show_number(cut));
    const auto later = pieces.insert(piece + 1, *piece);
    later->from = t;
    (later - 1)->to = t;
  }
  if (members.from) {
    FeatureMembers::Bound& from = pieces.front().from;
    if (from && *from != start)
      refuse(members, "from", "the object appears later than the scene starts");
    from = *members.from;
    if (from) *from += shift;
    if (from && *from > start) refuse(members, "from", "it is after the first place");
  }
  if (members.to) {
    FeatureMembers::Bound& to = pieces.back().to;
    if (to && *to != end) refuse(members, "to", "the object disappears before the scene ends");
    to = *members.to;
    if (to) *to += shift;
    if (to && *to < end) refuse(members, "to", "it is before the last place");
  }
}

void restore_frame(const FeatureMembers& members, std::vector<Vertex2>& polygon, Motion& motion) {
  if (members.polygon.empty()) return;
  const bool turns = !members.rotors.empty();
  const std::vector<Vertex2> there =
      turned(members.polygon, turns ? members.rotors[0][0] : 1, turns ? members.rotors[0][1] : 0);
  const auto same = [&](const Vertex2& a, const Vertex2& b) {
    return a[0] - there[0][0] == b[0] && a[1] - there[0][1] == b[1];
  };
  if (!std::equal(there.begin(), there.end(), polygon.begin(), polygon.end(), same)) {
    refuse(members, "polygon", "it is not that of the places");
  }
  polygon = members.polygon;
  for (MotionPiece& piece : motion.pieces) {
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
      piece.trajectory.coordinates[axis][0] -= there[0][axis];
    }
  }
}

void restore_rotors(const FeatureMembers& members, Motion& motion) {
  const auto& rotors = members.rotors;
  if (rotors.empty() || members.polygon.empty()) return;
  if (rotors.size() != 1 && rotors.size() != motion.pieces.size()) {
    refuse(members, "rotors",
           counted(rotors.size(), "rotor", "rotors") + " for " +
               counted(motion.pieces.size(), "piece", "pieces"));
  }
  for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
    const auto& [p, q] = rotors[rotors.size() == 1 ? 0 : i];
    if (p * rotors[0][1] != q * rotors[0][0]) refuse(members, "rotors", "the body turns");
    motion.pieces[i].trajectory.coordinates[2] = {p};
    motion.pieces[i].trajectory.coordinates[3] = {q};
  }
}

}  // namespace kinex::formats
