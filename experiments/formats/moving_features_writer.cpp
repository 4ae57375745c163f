// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/moving_features_writer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "experiments/formats/feature_members.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/iso_time.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/plane.h"
#include "experiments/formats/scene_writer.h"
#include "experiments/formats/weights.h"

namespace kinex::formats {

namespace {

constexpr int kMostDigits = 60;   // after the point, of numbers that are written exactly
constexpr int kTimeDigits = 12;   // of other times
constexpr int kPlaceDigits = 15;  // of other places
constexpr std::int64_t kMostSamples = std::int64_t{1} << 20;  // of one piece
constexpr double kRoundedUp = 1.00001;  // for an error that is written in 6 digits

Rational unit_of(int digits) { return *Rational::parse("1e-" + std::to_string(digits)); }

Rational magnitude(const Rational& value) { return value.sign() < 0 ? -value : value; }

// A part of a motion, within the scene's time.
struct Span {
  Rational from, to;
  const Trajectory* trajectory;
};

// A number as it is written, and whether it is exact.
struct Written {
  std::string text;
  Rational value;
  bool exact;
};

Written written(const Rational& value, int digits) {
  if (std::optional<std::string> text = finite_decimal(value, kMostDigits)) {
    return {*std::move(text), value, true};
  }
  std::string text = decimal(value, digits);
  Rational rounded = *Rational::parse(text);
  return {std::move(text), std::move(rounded), false};
}

// A bound on |the derivative| on [from, to] of one axis; `order` 1 or 2.
Rational derivative_bound(const std::vector<Rational>& coefficients, const Span& span, int order) {
  const Rational reach = std::max(magnitude(span.from), magnitude(span.to));
  Rational sum, power = 1;
  for (std::size_t k = static_cast<std::size_t>(order); k < coefficients.size(); ++k) {
    const auto degree = static_cast<std::int64_t>(k);
    sum +=
        magnitude(coefficients[k]) * power * Rational(order == 1 ? degree : degree * (degree - 1));
    power *= reach;
  }
  return sum;
}

class Writer {
 public:
  Writer(const Scene& scene, const std::string& file, const MovingFeaturesForm& form)
      : scene_(scene), file_(file), form_(form), json_(text_) {
    if (scene.objects.empty()) {
      throw InputError(file, "/objects", "no objects, and a file needs one", "write one");
    }
    if (!scene.end && !form.until) {
      throw InputError(file, "/time", "the scene has no end, and a file needs one", "give --until");
    }
    if (scene.extents == Extents::kRadius || scene.extents == Extents::kHalfExtents) {
      throw InputError(file, "/objects", "discs or boxes, whose extents such a file cannot hold",
                       "leave \"radius\" and \"half_extents\" out to write the centres");
    }
    if (scene.has_lines()) {
      throw InputError(file, "/objects", "lines, which such a file cannot hold",
                       "leave \"line\": true out to write the points (a, b)");
    }
    end_ = form.until ? *form.until : *scene.end;
    axes_ = scene.has_bodies() ? 2 : scene.dimension;
  }

  WrittenFeatures write() {
    json_.begin_object().key("type").string("FeatureCollection");
    json_.key("crs").begin_object().key("type").string("Name").key("properties").begin_object();
    json_.key("name").string(kScenePlane).end_object().end_object();
    json_.key("trs").begin_object().key("type").string("Name").key("properties").begin_object();
    json_.key("name").string("urn:ogc:data:time:iso8601").end_object().end_object();
    write_own();
    json_.line(1).key("features").begin_array();
    for (const SceneObject& object : scene_.objects) write_object(object);
    json_.end_array().end_object();
    text_ += '\n';
    result_.text = std::move(text_);
    return std::move(result_);
  }

 private:
  void write_own() {
    json_.line(1).key("kinex").begin_object().key("scene").string(scene_.name);
    write_words(json_, form_.words);
    json_.key("time_zero").string(date(form_.time_zero));
    json_.key("start").quoted(scene_.start).key("end").quoted(end_);
    json_.key("dimension").number(scene_.dimension);
    write_choices(json_, scene_);
    json_.key("maintain").begin_array();
    for (const Request& request : scene_.maintain) json_.raw(request_json(request, scene_));
    json_.end_array();
    write_queries(json_, scene_);
    json_.end_object();
  }

  std::string date(const Rational& seconds) const {
    if (has_iso_text(seconds)) return iso_text(seconds);
    throw InputError(file_, "/time", "it reaches beyond the years 1 to 9999 as dates in seconds",
                     "give another --time-zero, or a shorter --until");
  }

  bool is_seen(const MotionPiece& piece) const {
    return !(piece.from && *piece.from >= end_) && !(piece.to && *piece.to <= scene_.start);
  }

  std::vector<Span> spans_of(const Motion& motion) const {
    std::vector<Span> spans;
    for (const MotionPiece& piece : motion.pieces) {
      Rational from = piece.from && *piece.from > scene_.start ? *piece.from : scene_.start;
      Rational to = piece.to && *piece.to < end_ ? *piece.to : end_;
      if (from < to) spans.push_back({std::move(from), std::move(to), &piece.trajectory});
    }
    return spans;
  }

  bool goes_on(const Span& before, const Span& after) const {
    if (before.to != after.from) return false;
    for (int axis = 0; axis < axes_; ++axis) {
      if (before.trajectory->position(axis, after.from) !=
          after.trajectory->position(axis, after.from))
        return false;
    }
    return true;
  }

  void write_object(const SceneObject& object) {
    const std::vector<Span> spans = spans_of(object.motion);
    if (spans.empty()) return leave_out(object);
    exact_ = true;
    error_ = Rational();
    const std::vector<Vertex2> polygon = turned_polygon(object, spans);
    std::vector<std::vector<Span>> runs;
    for (const Span& span : spans) {
      if (runs.empty() || !goes_on(runs.back().back(), span)) runs.emplace_back();
      runs.back().push_back(span);
    }
    json_.line(2).begin_object().key("type").string("Feature").key("id").string(object.id);
    json_.key("temporalGeometry");
    if (runs.size() > 1) {
      json_.begin_object()
          .key("type")
          .string("MovingGeometryCollection")
          .key("prisms")
          .begin_array();
    }
    for (const std::vector<Span>& run : runs) write_run(run, polygon);
    if (runs.size() > 1) json_.end_array().end_object();
    json_.key("properties").begin_object().key("kinex").begin_object();
    if (exact_) {
      json_.key("exact").boolean(true);
    } else {
      json_.key("error_at_most").real(error_.upper_double() * kRoundedUp);
      ++result_.inexact;
      result_.error = std::max(result_.error, error_);
    }
    write_members(json_, members_of(object, spans));
    json_.end_object().end_object().end_object();
  }

  // An object that is there at other times only.
  void leave_out(const SceneObject& object) {
    if (!form_.until) {
      throw InputError(file_, "",
                       show_text(object.id) +
                           " is there at other times than the scene's only, "
                           "which such a file cannot hold",
                       "leave it out, or change \"time\"");
    }
    ++result_.absent;
  }

  FeatureMembers members_of(const SceneObject& object, const std::vector<Span>& spans) const {
    FeatureMembers members;
    members.colour = object.colour;
    members.ends = object.ends;
    if (scene_.extents == Extents::kWeight) members.weight = weight_of(object);
    if (!exact_) return members;
    if (!object.polygon.empty()) note_frame(object, spans, members);
    Motion found, wanted;
    for (const Span& span : spans) {
      Trajectory places = *span.trajectory;
      places.coordinates.resize(static_cast<std::size_t>(axes_));
      found.pieces.push_back({span.from, span.to, std::move(places)});
    }
    for (const MotionPiece& piece : object.motion.pieces) {
      if (is_seen(piece)) wanted.pieces.push_back({piece.from, piece.to, {}});
    }
    join_pieces(found);
    open_ends(found, scene_.start, end_);
    std::optional<Rational>& last = wanted.pieces.back().to;
    if (form_.until && last && *last > end_) last = found.pieces.back().to;
    note_pieces(found, wanted, members);
    return members;
  }

  // The frame, if it is not that of the places: turned, or with its origin at no vertex.
  void note_frame(const SceneObject& object, const std::vector<Span>& spans,
                  FeatureMembers& members) const {
    for (const Span& span : spans) {
      const auto& axes = span.trajectory->coordinates;
      members.rotors.push_back({axes[2][0], axes[3][0]});
    }
    const auto& all = members.rotors;
    if (std::all_of(all.begin(), all.end(), [&](const auto& one) { return one == all[0]; })) {
      members.rotors.resize(1);
    }
    const bool turns = members.rotors.size() > 1 || members.rotors[0][0] != Rational(1) ||
                       !members.rotors[0][1].is_zero();
    const Vertex2& first = object.polygon[0];
    if (turns || !first[0].is_zero() || !first[1].is_zero()) members.polygon = object.polygon;
    if (!turns) members.rotors.clear();
  }

  // nullopt: 0.
  std::optional<Rational> weight_of(const SceneObject& object) const {
    const auto weight = common_weight(object, scene_);
    if (!weight || weight->size() > 1) {
      throw InputError(file_, "",
                       "the weight of " + show_text(object.id) +
                           " changes, which such a file cannot hold",
                       "export scenes with constant weights, or without weights");
    }
    if ((*weight)[0].is_zero()) return std::nullopt;
    return (*weight)[0];
  }

  // The polygon of a body in its orientation, which must be one for all time; empty for a point.
  std::vector<Vertex2> turned_polygon(const SceneObject& object, const std::vector<Span>& spans) {
    if (object.polygon.empty()) return {};
    const std::vector<std::vector<Rational>>& first = spans.front().trajectory->coordinates;
    const Rational p = first[2][0], q = first[3][0];
    for (const Span& span : spans) {
      const std::vector<std::vector<Rational>>& axes = span.trajectory->coordinates;
      if (axes[2].size() == 1 && axes[3].size() == 1 && axes[2][0] * q == axes[3][0] * p) continue;
      throw InputError(
          file_, "",
          "the body " + show_text(object.id) + " turns, which no MovingPolygon does exactly",
          "export scenes of points, or of bodies that do not turn");
    }
    std::vector<Vertex2> polygon;
    for (const Vertex2& v : turned(object.polygon, p, q)) {
      Written x = written(v[0], kPlaceDigits);
      Written y = written(v[1], kPlaceDigits);
      if (!x.exact || !y.exact) lose(unit_of(kPlaceDigits));
      polygon.push_back({std::move(x.value), std::move(y.value)});
    }
    return polygon;
  }

  void lose(const Rational& error) {
    exact_ = false;
    error_ += error;
  }

  // The times of straight lines that are near enough to a piece, its end excluded. `bend`: how far they are.
  std::vector<Rational> sample_times(const Span& span, Rational& bend) const {
    Rational most;
    for (int axis = 0; axis < axes_; ++axis) {
      most = std::max(
          most,
          derivative_bound(span.trajectory->coordinates[static_cast<std::size_t>(axis)], span, 2));
    }
    // Lines over steps of length h are within h^2 most / 8.
    const Rational length = span.to - span.from;
    std::int64_t count = 1;
    const auto error = [&] {
      return length * length * most / Rational(8 * count) / Rational(count);
    };
    while (error() > form_.tolerance) {
      count *= 2;
      if (count <= kMostSamples) continue;
      throw InputError("--tolerance", "",
                       "a piece would take more than " + std::to_string(kMostSamples) + " samples",
                       "give a larger one");
    }
    bend = std::max(bend, error());
    std::vector<Rational> times;
    for (std::int64_t i = 0; i < count; ++i)
      times.push_back(span.from + length * Rational(i) / Rational(count));
    return times;
  }

  void write_run(const std::vector<Span>& run, const std::vector<Vertex2>& polygon) {
    struct Sample {
      Rational t;
      const Trajectory* trajectory;
    };
    std::vector<Sample> samples;
    Rational bend, speed;
    for (const Span& span : run) {
      for (Rational& t : sample_times(span, bend))
        samples.push_back({std::move(t), span.trajectory});
      for (int axis = 0; axis < axes_; ++axis) {
        speed = std::max(
            speed, derivative_bound(span.trajectory->coordinates[static_cast<std::size_t>(axis)],
                                    span, 1));
      }
    }
    samples.push_back({run.back().to, run.back().trajectory});
    json_.begin_object().key("type").string(polygon.empty() ? "MovingPoint" : "MovingPolygon");
    json_.key("datetimes").begin_array();
    bool exact_times = true, exact_places = true;
    std::optional<Rational> last;
    for (const Sample& sample : samples) {
      const Written t = written(form_.time_zero + sample.t, kTimeDigits);
      exact_times = exact_times && t.exact;
      if (last && t.value <= *last) {
        throw InputError(
            file_, "",
            "a piece of a motion is shorter than 1e-" + std::to_string(kTimeDigits) + " seconds",
            "leave it out");
      }
      last = t.value;
      json_.string(date(t.value));
    }
    json_.end_array().key("coordinates").begin_array();
    for (const Sample& sample : samples)
      write_place(*sample.trajectory, sample.t, polygon, exact_places);
    json_.end_array().key("interpolation").string("Linear").end_object();
    // Errors of the prisms of one object are not summed, but those of one kind and another are.
    Rational error = bend;
    if (!exact_times) error += speed * unit_of(kTimeDigits);
    if (!exact_places) error += unit_of(kPlaceDigits);
    if (bend.is_zero() && exact_times && exact_places) return;
    exact_ = false;
    error_ = std::max(error_, error);
  }

  // A position, or a polygon around it.
  void write_place(const Trajectory& trajectory, const Rational& t,
                   const std::vector<Vertex2>& polygon, bool& exact) {
    std::vector<Written> place;
    for (int axis = 0; axis < axes_; ++axis) {
      place.push_back(written(trajectory.position(axis, t), kPlaceDigits));
      exact = exact && place.back().exact;
    }
    json_.begin_array();
    if (polygon.empty()) {
      for (const Written& x : place) json_.raw(x.text);
      if (axes_ == 1) json_.raw("0");
    } else {
      json_.begin_array();
      for (std::size_t i = 0; i <= polygon.size(); ++i) {
        const Vertex2& v = polygon[i % polygon.size()];
        json_.begin_array();
        for (std::size_t axis = 0; axis < 2; ++axis)
          json_.raw(*finite_decimal(place[axis].value + v[axis]));
        json_.end_array();
      }
      json_.end_array();
    }
    json_.end_array();
  }

  const Scene& scene_;
  const std::string& file_;
  const MovingFeaturesForm& form_;
  Rational end_;
  int axes_;
  bool exact_ = true;  // of the present object, as the next
  Rational error_;
  std::string text_;
  JsonWriter json_;
  WrittenFeatures result_;
};

}  // namespace

WrittenFeatures write_moving_features(const Scene& scene, const std::string& file,
                                      const MovingFeaturesForm& form) {
  return Writer(scene, file, form).write();
}

}  // namespace kinex::formats
