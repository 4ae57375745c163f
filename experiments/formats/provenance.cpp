// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/provenance.h"

#include "experiments/formats/utf8.h"

namespace kinex::formats {

void write_provenance(JsonWriter& json, const Provenance& provenance) {
  json.begin_object().key("commit").string(provenance.commit);
  json.key("dirty").boolean(provenance.dirty).key("compiler").string(provenance.compiler);
  json.key("flags").string(provenance.flags).key("libraries").string(provenance.libraries);
  json.key("cpu")
      .string(provenance.cpu)
      .key("command")
      .string(utf8_or_shown(provenance.command))
      .end_object();
}

Provenance read_provenance(const JsonNode& node) {
  node.require_object({"commit", "dirty", "compiler", "flags", "libraries", "cpu", "command"});
  Provenance provenance;
  provenance.commit = node.member("commit").string();
  provenance.dirty = node.member("dirty").boolean();
  provenance.compiler = node.member("compiler").string();
  provenance.flags = node.member("flags").string();
  provenance.libraries = node.member("libraries").string();
  provenance.cpu = node.member("cpu").string();
  provenance.command = node.member("command").string();
  return provenance;
}

}  // namespace kinex::formats
