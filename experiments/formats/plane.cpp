// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/plane.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "experiments/formats/angles.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/iso_time.h"

namespace kinex::formats {

namespace {

constexpr unsigned long kFactorBits = 30;
constexpr const char* kRemedy =
    "project the file, or give --local LON,LAT (metres around a place), or --planar (they are "
    "planar all the same)";

// Names of geographic systems, upper-case. Others are taken as projected.
bool is_geographic(std::string name) {
  for (char& c : name) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  constexpr std::array<std::string_view, 8> kParts{"CRS84",  "CRS83", "CRS27",       "WGS84",
                                                   "WGS 84", "4326",  "EPSG/0/4979", "EPSG::4979"};
  if (name.find("UTM") != std::string::npos) return false;  // "WGS 84 / UTM zone 33N"
  constexpr std::array<std::string_view, 3> kEnds{":4979", ":4269", ":4258"};
  return std::any_of(kParts.begin(), kParts.end(),
                     [&](std::string_view part) { return name.find(part) != std::string::npos; }) ||
         std::any_of(kEnds.begin(), kEnds.end(),
                     [&](std::string_view end) { return name.ends_with(end); });
}

// {"type": "Name", "properties": {"name": NAME}}, or a link: its address; or NAME itself.
std::string name_of(const JsonNode& crs) {
  if (crs.is(JsonValue::Kind::kNull)) return "";
  if (crs.is(JsonValue::Kind::kString)) return std::string(crs.string());
  if (!crs.is(JsonValue::Kind::kObject)) {
    crs.refuse("a coordinate reference system",
               "write {\"type\": \"Name\", \"properties\": {\"name\": ..}}");
  }
  const std::optional<JsonNode> properties = crs.find("properties");
  if (!properties) crs.fail("\"properties\" is missing", "add it, with the \"name\" of the system");
  if (properties->is(JsonValue::Kind::kString)) return std::string(properties->string());
  for (const char* member : {"name", "href"}) {
    if (const auto name = properties->find(member)) return std::string(name->string());
  }
  properties->fail("neither \"name\" nor \"href\" is there", "add the name of the system");
}

}  // namespace

Plane Plane::as_they_are() {
  Plane plane;
  plane.form_ = Form::kAsTheyAre;
  return plane;
}

Plane Plane::around(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto longitude = Rational::parse(std::string_view(text).substr(0, comma));
  const auto latitude = comma == std::string::npos
                            ? std::nullopt
                            : Rational::parse(std::string_view(text).substr(comma + 1));
  if (!longitude || !latitude || *longitude < Rational(-180) || *longitude > Rational(180) ||
      *latitude < Rational(-89) || *latitude > Rational(89)) {
    throw InputError("--local", "", show_text(text) + " is no place",
                     "write LON,LAT in degrees, as 13.4,52.5; LAT from -89 to 89");
  }
  Plane plane;
  plane.form_ = Form::kAround;
  plane.longitude_ = *longitude;
  plane.latitude_ = *latitude;
  const Rational radian = approximate_pi() / Rational(180);
  const Rational radius = *Rational::parse("6371008.8");
  const Rational angle = latitude->sign() < 0 ? -*latitude : *latitude;
  plane.north_ = rounded(radius * radian, kFactorBits);
  plane.east_ = rounded(radius * radian * approximate_cos_sin(angle * radian).cos, kFactorBits);
  return plane;
}

void Plane::check(const std::optional<JsonNode>& crs, const JsonNode& node) const {
  if (form_ == Form::kAsTheyAre) return;
  const std::string name = crs ? name_of(*crs) : "";
  const bool geographic = name.empty() || is_geographic(name);
  if (form_ == Form::kAsNamed && geographic) {
    node.fail(name.empty()
                  ? "no \"crs\" is named, so the coordinates are degrees, which are not planar"
                  : "coordinates in " + show_text(name) + " are degrees, which are not planar",
              kRemedy);
  }
  if (form_ == Form::kAround && !geographic) {
    node.fail("--local is for degrees, the coordinates are in " + show_text(name),
              "leave --local out");
  }
}

void Plane::project(std::vector<Rational>& position) const {
  if (form_ != Form::kAround) return;
  position[0] = (position[0] - longitude_) * east_;
  position[1] = (position[1] - latitude_) * north_;
}

std::string Plane::text() const {
  if (form_ != Form::kAround) return "";
  const auto degrees = [](const Rational& value) {
    return finite_decimal(value, 20).value_or(value.to_string());
  };
  return "x = " + decimal(east_, 6) + " (longitude - " + degrees(longitude_) +
         "), y = " + decimal(north_, 6) + " (latitude - " + degrees(latitude_) + "), in metres";
}

}  // namespace kinex::formats
