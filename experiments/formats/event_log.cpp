// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/event_log.h"

#include <array>
#include <charconv>
#include <optional>

#include "core/numbers/number_text.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/run_outcome.h"
#include "experiments/formats/scene_writer.h"
#include "structures/plan.h"
#include "structures/registry.h"

namespace kinex::formats {

namespace {

std::string quoted(std::string_view text) {
  std::string result;
  append_json_string(result, text);
  return result;
}

void append_word(std::string& text, std::uint64_t value) {
  std::array<char, 24> buffer;
  text.append(buffer.data(),
              std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

template <class Number>
void append_quoted(std::string& text, const Number& number) {
  text += '"';
  append(text, number);
  text += '"';
}

// "time" of a record, its slowest part: hence the text is put together here.
void set_instant_json(std::string& text, const InstantName& name) {
  text = '{';
  if (name.exact && name.detail == InstantDetail::kName) {
    text += "\"polynomial\": [";
    bool first = true;
    for (const Integer& c : name.polynomial.coefficients()) {
      if (!first) text += ", ";
      first = false;
      append_quoted(text, c);
    }
    text += "], \"root\": ";
    append_word(text, static_cast<std::uint64_t>(name.root));
    text += ", ";
  }
  if (name.exact) {
    text += "\"interval\": [";
    const std::size_t begin = text.size();
    append_quoted(text, name.lower);
    const std::size_t size = text.size() - begin;
    text += ", ";
    if (name.is_rational()) {
      text.append(text, begin, size);
    } else {
      append_quoted(text, name.upper);
    }
    text += "], ";
  }
  text += "\"decimal\": \"";
  text += name.decimal;
  text += "\"}";
}

// The request of the structure with this label; nullopt for one outside the scene's plan.
std::optional<Request> request_of(const DigestedStructure& structure, const Scene& scene) {
  for (PlannedStructure& planned : plan_structures(scene)) {
    if (planned.request.label == structure.label) return std::move(planned.request);
  }
  return std::nullopt;
}

}  // namespace

std::string build_name() { return "kinex " KINEX_VERSION; }

std::string_view detail_name(InstantDetail detail) {
  switch (detail) {
    case InstantDetail::kName:
      return "names";
    case InstantDetail::kInterval:
      return "intervals";
    case InstantDetail::kNone:
      return "none";
  }
  return "";
}

EventLog::EventLog(const Simulator& simulator, std::string_view scene_hash, OutputFile* file,
                   InstantDetail instants, const std::optional<Provenance>& provenance)
    : simulator_(simulator),
      file_(file),
      structures_(digested_structures(simulator)),
      digest_(simulator),
      instants_(instants) {
  digest_.hold();
  for (const DigestedStructure& structure : structures_) {
    const StructureInfo* info = find_structure_info(structure.structure);
    const std::optional<Request> request = request_of(structure, simulator.scene());
    widths_.push_back(info == nullptr ? 0 : width_of(*info, request.value_or(Request{})));
  }
  if (file_ == nullptr) return;
  for (const DigestedStructure& structure : structures_) {
    std::vector<std::string>& heads = heads_.emplace_back();
    for (const std::string& kind : structure.kinds) {
      heads.push_back(", \"structure\": " + quoted(structure.label) +
                      ", \"kind\": " + quoted(kind) + ", \"ids\": ");
    }
  }
  for (const SceneObject& object : simulator.scene().objects) names_.push_back(quoted(object.id));
  write_header(scene_hash, provenance);
}

void EventLog::write_header(std::string_view scene_hash,
                            const std::optional<Provenance>& provenance) {
  const Arithmetic& arithmetic = simulator_.arithmetic();
  const Scene& scene = simulator_.scene();
  JsonWriter json(line_);
  json.begin_object().key("format").string(kLogFormat).key("version").number(kLogVersion);
  json.key("scene").string(scene.name).key("scene_hash").string(scene_hash);
  json.key("arithmetic").string(arithmetic.name()).key("exact").boolean(arithmetic.is_exact());
  json.key("instants").string(detail_name(instants_)).key("build").string(build_name());
  json.key("structures").begin_array();
  for (const DigestedStructure& structure : structures_) {
    json.begin_object().key("label").string(structure.label);
    json.key("structure").string(structure.structure);
    if (const std::optional<Request> request = request_of(structure, scene)) {
      const StructureInfo* info = find_structure_info(structure.structure);
      if (info != nullptr && info->uses_key) json.key("key").raw(key_json(request->key, scene));
      const std::string options = options_json(*request, scene);
      if (!options.empty()) json.key("options").raw(options);
    }
    json.key("kinds").begin_array();
    for (const std::string& kind : structure.kinds) json.string(kind);
    json.end_array().end_object();
  }
  json.end_array().key("objects").begin_array();
  for (const SceneObject& object : scene.objects) json.string(object.id);
  json.end_array();
  if (provenance) write_provenance(json.key("provenance"), *provenance);
  json.end_object();
  write_line();
}

void EventLog::write_line() {
  line_ += '\n';
  seal_.add(line_);
  file_->write(line_);
}

void EventLog::event(const Event& event, Arithmetic& arithmetic) {
  ++records_;
  if (event.external) ++external_;
  digest_.add(event, simulator_);
  if (file_ != nullptr) append_record(event, arithmetic);
}

// As a JSON string.
void EventLog::append_name(ObjectId id) {
  if (id < names_.size()) {
    pending_ += names_[id];
  } else {
    append_json_string(pending_, simulator_.object_name(id));
  }
}

void EventLog::append_ids(std::span<const ObjectId> ids) {
  pending_ += '[';
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i != 0) pending_ += ", ";
    append_name(ids[i]);
  }
  pending_ += ']';
}

// Tuples as lists, everything else as ids.
void EventLog::append_side(std::span<const ObjectId> ids, StructureId structure) {
  const std::size_t width = widths_[structure];
  if (width == 0) return append_ids(ids);
  pending_ += '[';
  for (std::size_t i = 0; i + width <= ids.size(); i += width) {
    if (i != 0) pending_ += ", ";
    append_ids(ids.subspan(i, width));
  }
  pending_ += ']';
}

// Nearly all of a log's text: parts that are the same in many records are prepared.
void EventLog::append_record(const Event& event, Arithmetic& arithmetic) {
  pending_ += "{\"seq\": ";
  append_word(pending_, records_);
  pending_ += heads_[event.structure][event.kind];
  append_ids({event.ids.data(), event.count});
  const Query& certificate = event.certificate;
  if (certificate.arity == 0) {
    pending_ += ", \"certificate\": null";
  } else {
    pending_ += ", \"certificate\": {\"predicate\": ";
    append_json_string(pending_, arithmetic.predicate(certificate.predicate).name());
    pending_ += ", \"ids\": ";
    append_ids({certificate.ids.data(), certificate.arity});
    pending_ += '}';
  }
  pending_ += event.external ? ", \"external\": true" : ", \"external\": false";
  if (!event.reason.empty()) {
    pending_ += ", \"reason\": ";
    append_json_string(pending_, event.reason);
  }
  if (event.has_difference()) {
    pending_ += ", \"gone\": ";
    append_side(event.gone, event.structure);
    pending_ += ", \"came\": ";
    append_side(event.came, event.structure);
  }
  if (instants_ != InstantDetail::kNone) {
    pending_ += ", \"time\": ";
    append_instant(arithmetic);
  }
  pending_ += "}\n";
}

void EventLog::instant_ended() {
  if (records_ == settled_records_) return;
  settled_records_ = records_;
  settled_external_ = external_;
  digest_.settle();
  if (file_ == nullptr) return;
  seal_.add(pending_);
  file_->write(pending_);
  pending_.clear();
}

void EventLog::instant_abandoned() {
  records_ = settled_records_;
  external_ = settled_external_;
  digest_.take_back();
  pending_.clear();
}

void EventLog::append_instant(Arithmetic& arithmetic) {
  const InstantName& name = arithmetic.name_now(instants_);
  if (name.number == 0 || name.number != instant_number_) {
    set_instant_json(instant_, name);
    instant_number_ = name.number;
  }
  pending_ += instant_;
}

// "corrupt", if there is a corrupt structure.
void EventLog::write_corrupt(JsonWriter& json) const {
  bool some = false;
  for (StructureId id = 0; id < simulator_.structures(); ++id) {
    if (!simulator_.ledger(id).corrupt) continue;
    if (!some) json.key("corrupt").begin_object();
    some = true;
    json.key(simulator_.label(id)).string(simulator_.ledger(id).corruption);
  }
  if (some) json.end_object();
}

void EventLog::finish(RunStatus status) {
  instant_ended();
  if (file_ == nullptr) return;
  line_.clear();
  JsonWriter json(line_);
  json.begin_object().key("end").string(status_name(status)).key("reached");
  if (status == RunStatus::kDone && !simulator_.scene().end) {
    json.null();
  } else {
    json.string(simulator_.reached().to_string());
  }
  json.key("records").number(records_).key("external").number(external_);
  write_corrupt(json);
  json.key("digest").string(digest()).key("seal");
  seal_.add(line_ + '"');
  json.string(seal_.hex()).end_object();
  line_ += '\n';
  file_->write(line_);
  file_->commit();
}

}  // namespace kinex::formats
