// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/view/proof_data.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "experiments/lab/binary_scale.h"
#include "experiments/view/data_writer.h"

namespace kinex::view {

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

std::string_view figure_name(ClaimFigure figure) {
  switch (figure) {
    case ClaimFigure::kNone:
      return "none";
    case ClaimFigure::kOrder:
      return "order";
    case ClaimFigure::kNearer:
      return "nearer";
    case ClaimFigure::kLengths:
      return "lengths";
    case ClaimFigure::kTurn:
      return "turn";
    case ClaimFigure::kDirections:
      return "directions";
    case ClaimFigure::kCircle:
      return "circle";
    case ClaimFigure::kHalfPlane:
      return "half-plane";
    case ClaimFigure::kAlong:
      return "along";
    case ClaimFigure::kRay:
      return "ray";
    case ClaimFigure::kNormals:
      return "normals";
    case ClaimFigure::kDiscs:
      return "discs";
    case ClaimFigure::kGap:
      return "gap";
    case ClaimFigure::kBeyond:
      return "beyond";
    case ClaimFigure::kAngle:
      return "angle";
    case ClaimFigure::kExtents:
      return "extents";
    case ClaimFigure::kStrips:
      return "strips";
    case ClaimFigure::kRectangles:
      return "rectangles";
  }
  return "";
}

std::string_view kind_name(ArgumentRole::Kind kind) {
  switch (kind) {
    case ArgumentRole::Kind::kPoint:
      return "point";
    case ArgumentRole::Kind::kBody:
      return "body";
    case ArgumentRole::Kind::kPose:
      return "pose";
    case ArgumentRole::Kind::kFrameLine:
      return "line";
    case ArgumentRole::Kind::kFramePoint:
      return "frame point";
    case ArgumentRole::Kind::kNumber:
      return "number";
  }
  return "";
}

std::string_view shape_name(ProofMark::Shape shape) {
  switch (shape) {
    case ProofMark::Shape::kChain:
      return "chain";
    case ProofMark::Shape::kJoin:
      return "join";
    case ProofMark::Shape::kThrough:
      return "through";
    case ProofMark::Shape::kLine:
      return "line";
    case ProofMark::Shape::kOutline:
      return "outline";
  }
  return "";
}

void write_feature(formats::JsonWriter& json, const FrameFeature& feature) {
  if (feature.kind == FrameFeature::Kind::kNone) {
    json.number(0);
    return;
  }
  json.begin_array().string(kind_name(feature.kind));
  json.number(std::uint64_t{feature.first}).number(std::uint64_t{feature.last}).end_array();
}

void write_claims(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
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

void write_direction(formats::JsonWriter& json, const std::vector<Integer>& direction) {
  if (direction.empty()) {
    json.number(0);
    return;
  }
  Integer largest(1);
  for (const Integer& v : direction) largest = std::max(largest, abs(v));
  json.begin_array();
  for (const Integer& v : direction) write_double(json, Rational(v, largest).to_double());
  json.end_array();
}

void write_forms(formats::JsonWriter& json, const RecordedRun& run) {
  json.key("forms").begin_array();
  for (const ClaimForm& form : run.forms) {
    json.begin_array().string(figure_name(form.figure)).number(form.sign).string(form.says);
    write_direction(json, form.direction);
    json.begin_array();
    for (const ArgumentRole& role : form.roles) {
      json.begin_array().string(role.name).string(kind_name(role.kind));
      json.number(int{role.frame}).end_array();
    }
    json.end_array().begin_array();
    for (const std::uint8_t place : form.places) json.number(int{place});
    json.end_array().end_array();
  }
  json.end_array();
}

void write_part(formats::JsonWriter& json, const PolygonFeature& part) {
  json.begin_array().string(part.edge ? "edge" : "vertex").number(std::uint64_t{part.body});
  json.number(std::uint64_t{part.place}).end_array();
}

void write_outline(formats::JsonWriter& json, const ProofMark& mark, const Rational& scale) {
  json.begin_array();
  for (const std::vector<Rational>& point : mark.outline) {
    json.begin_array();
    for (std::size_t i = 0; i < 2; ++i) {
      write_double(json, (point[i] / point[2] / scale).to_double());
    }
    json.end_array();
  }
  json.end_array();
}

// Places in the tables of one structure's proof, by text.
class Texts {
 public:
  std::uint64_t place(std::string_view text) {
    const auto [known, is_new] = places_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return known->second;
  }
  void write(formats::JsonWriter& json) const {
    json.begin_array();
    for (const std::string_view text : texts_) json.string(text);
    json.end_array();
  }

 private:
  std::map<std::string_view, std::uint64_t> places_;
  std::vector<std::string_view> texts_;
};

class ProofWriter {
 public:
  ProofWriter(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
              const ShownThings& things, const Rational& span, const Rational& scale)
      : json_(json),
        index_(index),
        things_(things),
        start_(run.start.to_double()),
        span_(span.to_double()),
        scale_(scale) {}

  void write(const RecordedProof& proof) {
    json_.begin_object().key("reads");
    write_optional(proof.reads ? std::optional<std::uint64_t>(*proof.reads) : std::nullopt);
    json_.key("ends");
    write_optional(proof.ends);
    Texts roles;
    json_.key("certificates").begin_array();
    for (const RecordedCertificate& certificate : proof.certificates) {
      json_.begin_array().number(std::uint64_t{certificate.group});
      json_.number(std::uint64_t{certificate.slot}).number(roles.place(certificate.role));
      json_.number(std::uint64_t{certificate.claim});
      write_failure(certificate);
      json_.end_array();
    }
    json_.end_array().key("roles");
    roles.write(json_);
    json_.key("groups").begin_array();
    for (const RecordedGroup& group : proof.groups) write_group(group);
    json_.end_array().key("changes").begin_array();
    for (const ProofChange& change : proof.changes) {
      json_.begin_array().number(change.event);
      for (const auto* list : {&change.gone, &change.came, &change.states, &change.ended}) {
        write_ids(json_, *list);
      }
      json_.end_array();
    }
    json_.end_array().end_object();
  }

 private:
  void write_optional(const std::optional<std::uint64_t>& value) {
    if (value) {
      json_.number(*value);
    } else {
      json_.null();
    }
  }

  void write_failure(const RecordedCertificate& certificate) {
    const double u = (certificate.time - start_) / span_;
    switch (certificate.outlook) {
      case Outlook::kNever:
        json_.number(0);
        return;
      case Outlook::kIdenticallyZero:
        json_.number(-1);
        return;
      case Outlook::kFailsNow:
        json_.number(-2);
        return;
      case Outlook::kFails:
      case Outlook::kLater:
        json_.begin_array();
        write_double(json_, u);
        if (certificate.outlook == Outlook::kLater) json_.number(0);
        json_.end_array();
        return;
    }
  }

  void write_shown(const std::vector<ObjectId>& ids) {
    json_.begin_array();
    for (const ObjectId id : ids) json_.number(std::uint64_t{things_.shown(index_, id)});
    json_.end_array();
  }

  void write_place(std::uint64_t place) {
    if (place == ProofGroup::kNoPlace) {
      json_.null();
    } else {
      json_.number(place);
    }
  }

  void write_group(const RecordedGroup& group) {
    const ProofGroup& state = group.state;
    json_.begin_array().number(std::uint64_t{group.group}).string(state.kind);
    write_shown(state.about);
    json_.string(state.text);
    write_place(state.place);
    write_place(state.parent);
    json_.number(std::uint64_t{state.branch}).begin_array();
    for (const ProofMark& mark : state.marks) write_mark(mark);
    json_.end_array().end_array();
  }

  void write_mark(const ProofMark& mark) {
    json_.begin_array().string(shape_name(mark.shape)).string(mark.name);
    switch (mark.shape) {
      case ProofMark::Shape::kChain:
        write_shown(mark.objects);
        break;
      case ProofMark::Shape::kJoin:
      case ProofMark::Shape::kThrough:
        for (const PolygonFeature& feature : mark.features) write_part(json_, feature);
        break;
      case ProofMark::Shape::kLine:
        json_.number(std::uint64_t{things_.shown(index_, mark.objects.at(0))});
        json_.number(int{mark.body});
        break;
      case ProofMark::Shape::kOutline:
        json_.number(int{mark.body});
        write_outline(json_, mark, scale_);
        break;
    }
    json_.end_array();
  }

  formats::JsonWriter& json_;
  const std::size_t index_;
  const ShownThings& things_;
  const double start_, span_;
  const Rational& scale_;
};

// A quotient in doubles; null where the divisor is zero.
void write_quotient(formats::JsonWriter& json, const Rational& value, const Rational& by,
                    const Rational& scale) {
  if (by.is_zero()) {
    json.null();
  } else {
    write_double(json, (value / by / scale).to_double());
  }
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

void ShownThings::write(formats::JsonWriter& json, const Rational& scale) const {
  json.key("things").begin_array();
  for (const RecordedThing* thing : things_) {
    json.begin_array().string(thing->name);
    const std::vector<Rational>& c = thing->coordinates;
    if (c.size() == 3) {
      const Rational size = std::max(lab::absolute(c[0]), lab::absolute(c[1]));
      json.begin_array();
      for (std::size_t i = 0; i < 3; ++i) {
        write_quotient(json, c[i], size, i < 2 ? Rational(1) : scale);
      }
      for (std::size_t i = 0; i < 2; ++i) write_quotient(json, c[i], c[2], scale);
      json.end_array();
    } else if (c.size() == 1 && !thing->feature) {
      json.begin_array();
      write_quotient(json, c[0], Rational(1), scale);
      json.end_array();
    } else {
      json.number(0);
    }
    if (thing->feature) {
      write_part(json, *thing->feature);
    } else {
      json.number(0);
    }
    json.end_array();
  }
  json.end_array();
}

void write_proofs(formats::JsonWriter& json, const RecordedRun& run, std::size_t index,
                  const ShownThings& things, const Rational& span, const Rational& scale) {
  write_forms(json, run);
  write_claims(json, run, index, things);
  json.key("proofs").begin_array();
  ProofWriter writer(json, run, index, things, span, scale);
  for (const RecordedStructure& structure : run.structures) writer.write(structure.proof);
  json.end_array();
}

}  // namespace kinex::view
