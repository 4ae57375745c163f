// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/moving_features.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "experiments/formats/counted.h"
#include "experiments/formats/csv_fields.h"
#include "experiments/formats/feature_geometry.h"
#include "experiments/formats/feature_members.h"
#include "experiments/formats/iso_time.h"
#include "experiments/formats/json_defect.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/scene_parts.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/weights.h"

namespace kinex::formats {

namespace {

using Kind = JsonValue::Kind;

// A feature of the file, or the fixes of all features of one id.
struct Track {
  std::string id;
  std::size_t line = 0;
  std::string place;  // JSON path
  FeatureGeometry geometry;
  bool of_fixes = false;
  std::vector<std::string> places;  // of the fixes, JSON paths
  FeatureMembers members;
};

// A moving geometry that stands alone.
bool is_geometry(std::string_view type) {
  return type == "MovingPoint" || type == "MovingGeomPoint" || type == "MovingPolygon" ||
         type == "MovingGeometryCollection";
}

constexpr const char* kOnlyId = "1";  // of such a geometry without one

class Reader {
 public:
  Reader(std::string_view text, const std::string& file, const MovingFeaturesOptions& options)
      : text_(text),
        file_(file),
        options_(options),
        reading_{scale_, options.plane, file, options.linear, {}} {
    if (!options_.common.columns.empty()) check_columns();
    if (options_.common.heading) {
      throw InputError(options_.common.heading->compass ? "--bearing" : "--heading", "",
                       "it is for tables", "leave it out");
    }
  }

  ImportReport read() {
    const JsonDocument document = parse_json(text_, file_);
    const JsonSource source{file_, text_};
    const JsonNode root(*document, source);
    if (!root.is(Kind::kObject))
      root.refuse("a Feature or a FeatureCollection", "write {\"type\": ..}");
    const std::optional<JsonNode> form = root.find("kinex");
    if (form && form->is(Kind::kNumber)) {
      throw InputError(file_, "/kinex", "it is a scene already",
                       "use it as it is, or give a table or features");
    }
    const std::string type(root.member("type").string());
    if (type == "FeatureCollection" || type == "MovingFeatureCollection") {
      const JsonNode features = root.member("features");
      features.require_array();
      const std::optional<JsonNode> crs = root.find("crs");
      for (std::size_t i = 0; i < features.size(); ++i) read_feature(features.at(i), crs);
    } else if (type == "Feature" || type == "MovingFeature") {
      read_feature(root, std::nullopt);
    } else if (is_geometry(type)) {
      read_geometry(root);
    } else {
      root.member("type").refuse("a kind of file that can be read",
                                 "write Feature, FeatureCollection or MovingPoint");
    }
    if (tracks_.empty()) root.fail("there are no features", "write one for each object");
    const std::optional<JsonNode> own = root.find("kinex");
    make_scene(own);
    return std::move(report_);
  }

 private:
  // Names of properties make sense for ids and times alone.
  void check_columns() const {
    for (const NamedColumn& one : options_.common.columns) {
      if (one.meaning == "id" || one.meaning == "t") {
        if (property_for(one.meaning) != &one.column) {
          throw InputError("--column", "", one.meaning + " is named twice",
                           "name one property for it");
        }
        continue;
      }
      throw InputError("--column", "",
                       one.meaning + "=" + one.column + ": places are not in properties here",
                       "name the properties for id and t");
    }
  }

  const std::string* property_for(const std::string& meaning) const {
    for (const NamedColumn& one : options_.common.columns) {
      if (one.meaning == meaning) return &one.column;
    }
    return nullptr;
  }

  // A string, or a number as it is written.
  static std::string word(const JsonNode& node) {
    if (node.is(Kind::kNumber)) return std::string(node.value().text());
    return std::string(node.string());
  }

  std::string id_of(const JsonNode& feature, const std::optional<JsonNode>& properties) const {
    const std::string* const name = property_for("id");
    if (name != nullptr) {
      const auto value = properties ? properties->find(*name) : std::nullopt;
      if (!value)
        feature.fail("there is no property " + show_text(*name),
                     "name that of the ids with --column id=NAME");
      return word(*value);
    }
    if (const auto id = feature.find("id")) return word(*id);
    if (const auto id = properties ? properties->find("id") : std::nullopt) return word(*id);
    feature.fail("the feature has no id",
                 "give it an \"id\", or name a property: --column id=NAME");
  }

  std::size_t line_of(const JsonNode& node) const {
    return position_in(text_, node.value().offset()).line;
  }

  // The place of a new track; of an old one if both are of fixes.
  Track& track(const std::string& id, const JsonNode& feature, bool of_fixes) {
    check_csv_id(id, file_, feature.path());
    const auto [at, is_new] = numbers_.emplace(id, tracks_.size());
    if (is_new) {
      tracks_.push_back({id, line_of(feature), feature.path(), {}, of_fixes, {}, {}});
    } else if (!of_fixes || !tracks_[at->second].of_fixes) {
      feature.fail("the id " + show_text(id) + " is that of " + tracks_[at->second].place + " too",
                   "give one of them another id; several prisms of one object are a "
                   "MovingGeometryCollection");
    }
    return tracks_[at->second];
  }

  void read_geometry(const JsonNode& node) {
    const auto id = property_for("id") == nullptr ? node.find("id") : std::nullopt;
    ++report_.rows;
    FeatureGeometry geometry = read_temporal_geometry(node, std::nullopt, reading_);
    track(id ? word(*id) : kOnlyId, node, false).geometry = std::move(geometry);
  }

  void read_feature(const JsonNode& feature, const std::optional<JsonNode>& outer) {
    if (!feature.is(Kind::kObject))
      feature.refuse("a feature", "write {\"type\": \"Feature\", ..}");
    const std::optional<JsonNode> own = feature.find("crs");
    const std::optional<JsonNode> crs = own ? own : outer;
    std::optional<JsonNode> properties = feature.find("properties");
    if (properties && !properties->is(Kind::kObject)) properties.reset();  // null
    const std::string id = id_of(feature, properties);
    ++report_.rows;
    const std::optional<JsonNode> moving = feature.find("temporalGeometry");
    if (moving && !moving->is(Kind::kNull)) {
      FeatureGeometry geometry = read_temporal_geometry(*moving, crs, reading_);
      Track& one = track(id, feature, false);
      one.geometry = std::move(geometry);
      const auto members = properties ? properties->find("kinex") : std::nullopt;
      if (members) one.members = read_members(*members, file_);
      return;
    }
    const JsonNode geometry = feature.member("geometry");
    if (!geometry.is(Kind::kObject))
      geometry.fail("the feature has no place", "give it a geometry, or leave it out");
    options_.plane.check(crs, feature);
    const JsonNode type = geometry.member("type");
    const std::string* const name = property_for("t");
    const std::string times_name = name != nullptr            ? *name
                                   : type.string() == "Point" ? "t"
                                                              : "datetimes";
    const std::optional<JsonNode> times = properties ? properties->find(times_name) : std::nullopt;
    if (type.string() != "Point" && type.string() != "LineString") {
      type.refuse("a geometry that moves", "give points, line strings or a \"temporalGeometry\"");
    }
    if (!times) {
      feature.fail("there is no property " + show_text(times_name) + ", the times of a " +
                       std::string(type.string()),
                   "name that of the times with --column t=NAME");
    }
    if (type.string() == "LineString") {
      FeatureGeometry line = read_trajectory(geometry, *times, reading_);
      track(id, feature, false).geometry = std::move(line);
    } else {
      read_fix(id, feature, geometry, *times);
    }
  }

  void read_fix(const std::string& id, const JsonNode& feature, const JsonNode& geometry,
                const JsonNode& time) {
    const std::string text = word(time);
    Fix fix{scale_.read(text, file_, time.path(), show_text(text)),
            read_position(geometry.member("coordinates"), reading_),
            {}};
    Track& one = track(id, feature, true);
    if (one.geometry.runs.empty()) one.geometry.runs.emplace_back();
    one.geometry.runs.front().fixes.push_back(std::move(fix));
    one.places.push_back(feature.path());
  }

  // Fixes of several features: in order of time, each once.
  void sort_fixes(Track& track) {
    std::vector<std::pair<Fix, std::string>> fixes;
    std::vector<Fix>& all = track.geometry.runs.front().fixes;
    for (std::size_t i = 0; i < all.size(); ++i)
      fixes.emplace_back(std::move(all[i]), track.places[i]);
    std::stable_sort(fixes.begin(), fixes.end(),
                     [](const auto& a, const auto& b) { return a.first.t < b.first.t; });
    all.clear();
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      if (i > 0 && fixes[i].first.t == all.back().t) {
        if (fixes[i].first.position != all.back().position) {
          throw InputError(file_, fixes[i].second,
                           show_text(track.id) + " is at another place at the same time in " +
                               fixes[i - 1].second,
                           "remove one of the two features");
        }
        ++report_.repeated_fixes;
        continue;
      }
      all.push_back(std::move(fixes[i].first));
    }
  }

  // The motion of a track; one without a piece for a track of single fixes.
  Motion motion_of(Track& track, const Rational& zero, bool body) {
    Motion motion;
    const Fix* last = nullptr;
    for (FeatureRun& run : track.geometry.runs) {
      for (Fix& fix : run.fixes) fix.t -= zero;
      // Where one run ends and the next begins elsewhere at the same time, the object jumps.
      const Fix& first = run.fixes.front();
      if (last != nullptr && last->t == first.t && last->position != first.position)
        report_.scene.jumps = true;
      if (run.step) {
        append_steps(motion, run.fixes, body);
        for (std::size_t i = 1; i + 1 < run.fixes.size(); ++i) {
          if (run.fixes[i].position != run.fixes[i - 1].position) report_.scene.jumps = true;
        }
      } else {
        append_linear(motion, run.fixes, body);
      }
      if (!run.fixes.empty()) last = &run.fixes.back();
    }
    return motion;
  }

  void make_scene(const std::optional<JsonNode>& own) {
    Scene& scene = report_.scene;
    scene.dimension = reading_.dimension.value_or(2);
    scene.overlapping_starts = options_.common.overlapping_starts;
    const Rational zero = settle(own);
    const bool polygons = std::any_of(tracks_.begin(), tracks_.end(), [](const Track& track) {
      return !track.geometry.polygon.empty();
    });
    const bool body = polygons || options_.common.polygons;
    if (polygons && options_.common.polygons) {
      throw InputError("--polygons", "", "the features have polygons of their own", "leave it out");
    }
    if (!body) refuse_overlapping_points(scene);
    bool assumed = false, weighted = false;
    std::vector<const FeatureMembers*> members;  // of the scene's objects
    std::optional<Rational> first, last;
    std::unordered_map<std::string, std::size_t> lines;
    PolygonTable table{file_, {}, {}};
    for (Track& track : tracks_) {
      if (track.of_fixes) sort_fixes(track);
      assumed = assumed || track.geometry.assumed_linear;
      Motion motion = motion_of(track, zero, body);
      const Rational& begin = track.geometry.runs.front().fixes.front().t;
      const Rational& end = track.geometry.runs.back().fixes.back().t;
      if (!first || begin < *first) first = begin;
      if (!last || *last < end) last = end;
      if (motion.pieces.empty()) {
        report_.single_fixes.push_back(show_text(track.id) + " (line " +
                                       std::to_string(track.line) + ")");
        continue;
      }
      lines.emplace(track.id, track.line);
      restore_frame(track.members, track.geometry.polygon, motion);
      if (!track.geometry.polygon.empty()) {
        table.number.emplace(track.id, table.entries.size());
        table.entries.push_back({track.id, track.line, track.geometry.polygon});
      }
      if (track.members.weight && !body) {
        append_weight(motion, {*track.members.weight});
        weighted = true;
      }
      scene.objects.push_back({track.id, std::move(motion)});
      if (!body) scene.objects.back().colour = track.members.colour;
      if (!body) scene.objects.back().ends = track.members.ends;
      members.push_back(&track.members);
    }
    if (scene.objects.empty())
      throw InputError(file_, "", "no object has two times: " + some_of(report_.single_fixes),
                       "write at least two of one id");
    set_time(own, *first, *last);
    for (std::size_t i = 0; i < members.size(); ++i) {
      restore_object(*members[i], scene.objects[i].motion);
    }
    for (const std::string& row : options_.common.fixed) add_fixed(scene, row, body);
    if (weighted) complete_weights(scene);
    if (assumed) report_.notes.push_back("no interpolation is named, Linear is assumed");
    if (const std::string plane = options_.plane.text(); !plane.empty())
      report_.notes.push_back(plane);
    restore(own);
    check_edges();
    if (body) make_bodies(scene, polygons ? table : *options_.common.polygons, {file_, lines});
    if (options_.maintain) restore_maintain(own);
    restore_queries(own);
  }

  void restore_object(const FeatureMembers& members, Motion& motion) const {
    const Scene& scene = report_.scene;
    if (!options_.common.start_time && !options_.common.end_time) {
      restore_pieces(members, scene.start, *scene.end, shift_, motion);
    }
    restore_rotors(members, motion);
  }

  static std::optional<JsonNode> member(const std::optional<JsonNode>& own, const char* name) {
    if (!own || !own->is(Kind::kObject)) return std::nullopt;
    return own->find(name);
  }

  Rational settle(const std::optional<JsonNode>& own) {
    std::optional<OptionTime> zero = options_.common.time_zero;
    const std::optional<JsonNode> stored = member(own, "time_zero");
    if (!zero && stored) zero = {file_ + ": /kinex/time_zero", std::string(stored->string())};
    const Rational result = scale_.settle(zero);
    std::string problem;
    if (const auto date = stored ? parse_iso_time(stored->string(), problem) : std::nullopt) {
      shift_ = date->seconds - result;
    }
    report_.time_zero = scale_.zero_text();
    return result;
  }

  void set_time(const std::optional<JsonNode>& own, const Rational& first, const Rational& last) {
    Scene& scene = report_.scene;
    const ImportOptions& common = options_.common;
    const std::optional<JsonNode> start = member(own, "start"), end = member(own, "end");
    scene.start = common.start_time ? scale_.read(*common.start_time)
                  : start           ? start->rational() + shift_
                                    : first;
    scene.end = common.end_time ? scale_.read(*common.end_time)
                : end           ? end->rational() + shift_
                                : last;
    check_time(scene, file_, report_.notes);
    // What is there for the whole time has no ends of its own.
    for (SceneObject& object : scene.objects) open_ends(object.motion, scene.start, *scene.end);
  }

  // What kinex has written beside the standard's members.
  void restore(const std::optional<JsonNode>& own) {
    Scene& scene = report_.scene;
    if (const auto name = member(own, "scene")) {
      scene.name = name->string();
      report_.is_named = true;
    }
    if (own && own->is(Kind::kObject)) report_.words = read_words(*own);
    if (const auto jumps = member(own, "jumps")) scene.jumps = scene.jumps || jumps->boolean();
    if (const auto starts = member(own, "overlapping_starts")) {
      read_overlapping_starts(*starts, scene);
    }
    const auto dimension = member(own, "dimension");
    if (!dimension || dimension->integer(1, kMaxDimension) != 1 || scene.dimension != 2) return;
    for (SceneObject& object : scene.objects) {
      for (MotionPiece& piece : object.motion.pieces) {
        if (piece.trajectory.coordinates[1] != std::vector<Rational>{0}) {
          dimension->fail("one axis, but there are places with y other than 0",
                          "remove it, or write 2");
        }
        piece.trajectory.coordinates.erase(piece.trajectory.coordinates.begin() + 1);
      }
    }
    scene.dimension = 1;
  }

  // When the objects are as they will be.
  void restore_maintain(const std::optional<JsonNode>& own) {
    Scene& scene = report_.scene;
    const auto entries = member(own, "maintain");
    if (!entries) return;
    read_maintain(*entries, scene);
    report_.maintains = true;
  }

  // For structures of --maintain, too.
  void restore_queries(const std::optional<JsonNode>& own) {
    Scene& scene = report_.scene;
    const auto queries = member(own, "queries");
    if (!queries) return;
    scene.start -= shift_;
    *scene.end -= shift_;
    read_queries(*queries, scene, file_);
    scene.start += shift_;
    *scene.end += shift_;
    for (BoxQuery& query : scene.queries) query.at += shift_;
  }

  // Edges of a graph are points of one axis.
  void check_edges() const {
    const bool edges = std::any_of(tracks_.begin(), tracks_.end(),
                                   [](const Track& track) { return !track.members.ends.empty(); });
    if (!edges || report_.scene.dimension == 1) return;
    throw InputError(file_, "/kinex/dimension",
                     "edges of a graph with places of more than one axis",
                     "write 1, or remove the \"ends\"");
  }

  std::string_view text_;
  const std::string& file_;
  const MovingFeaturesOptions& options_;
  TimeScale scale_;
  Rational shift_;  // of times in the file's own members
  FeatureReading reading_;
  std::vector<Track> tracks_;
  std::unordered_map<std::string, std::size_t> numbers_;
  ImportReport report_;
};

}  // namespace

bool looks_like_json(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

ImportReport import_moving_features(std::string_view text, const std::string& file,
                                    const MovingFeaturesOptions& options) {
  return Reader(text, file, options).read();
}

}  // namespace kinex::formats
