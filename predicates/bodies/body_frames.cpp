// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/bodies/body_frames.h"

#include <utility>

namespace kinex {

ObjectId FrameConstants::point(const FramePoint& p) {
  const auto [place, is_new] = points_.try_emplace(p, kNoObject);
  if (is_new) place->second = kernel_.constant(p.to_string(), p.coordinates());
  return place->second;
}

ObjectId FrameConstants::line(const FrameLine& l) {
  const auto [place, is_new] = lines_.try_emplace(l, kNoObject);
  if (is_new) place->second = kernel_.constant(l.to_string(), l.coordinates());
  return place->second;
}

std::size_t FrameConstants::bytes() const {
  constexpr std::size_t kEach = 48 + 3 * 24;
  return points_.size() * (sizeof(FramePoint) + kEach) +
         lines_.size() * (sizeof(FrameLine) + kEach);
}

BodyFrame::BodyFrame(OuterHierarchy hierarchy, FrameConstants& constants)
    : hierarchy_(std::move(hierarchy)),
      constants_(&constants),
      lines_(hierarchy_.edges().size(), kNoObject),
      points_(hierarchy_.points().size(), kNoObject) {}

ObjectId BodyFrame::line(std::uint32_t edge) {
  ObjectId& id = lines_[edge];
  if (id == kNoObject) id = constants_->line(hierarchy_.edge(edge).line);
  return id;
}

ObjectId BodyFrame::apex(std::uint32_t node) {
  ObjectId& id = points_[hierarchy_.node(node).point];
  if (id == kNoObject) id = constants_->point(hierarchy_.node(node).apex);
  return id;
}

ObjectId BodyFrame::vertex(std::uint32_t i) {
  vertices_.resize(size(), kNoObject);
  if (vertices_[i] == kNoObject) vertices_[i] = constants_->point(hierarchy_.polygon().vertices[i]);
  return vertices_[i];
}

ObjectId BodyFrame::polygon_edge(std::uint32_t i) {
  polygon_edges_.resize(size(), kNoObject);
  ObjectId& id = polygon_edges_[i];
  if (id == kNoObject) id = constants_->line(hierarchy_.polygon().edges[i]);
  return id;
}

ObjectId BodyFrame::across(std::uint32_t edge, bool last) {
  std::vector<ObjectId>& ids = across_[last ? 1 : 0];
  ids.resize(size(), kNoObject);
  if (ids[edge] == kNoObject) {
    const FramePolygon& polygon = hierarchy_.polygon();
    // The normal turned by a quarter counter-clockwise.
    const FrameLine& line = polygon.edges[edge];
    ids[edge] = constants_->line(frame_line(Rational(-line.ny), Rational(line.nx),
                                            polygon.vertices[last ? after(edge) : edge]));
  }
  return ids[edge];
}

ObjectId BodyFrame::inner() {
  if (inner_ != kNoObject) return inner_;
  struct Place {
    Rational x, y;
  };
  std::vector<Place> places;
  for (const FramePoint& v : hierarchy_.polygon().vertices) {
    places.push_back({Rational(v.x, v.w), Rational(v.y, v.w)});
  }
  const auto longest = [&](const auto& measure) {
    std::uint32_t best = 0;
    Rational most = measure(0);
    for (std::uint32_t i = 1; i < size(); ++i) {
      Rational value = measure(i);
      if (value > most) {
        most = std::move(value);
        best = i;
      }
    }
    return best;
  };
  const std::uint32_t edge = longest([&](std::uint32_t i) {
    const Rational x = places[after(i)].x - places[i].x, y = places[after(i)].y - places[i].y;
    return x * x + y * y;
  });
  const Place &p = places[edge], &q = places[after(edge)];
  const Place& r = places[longest([&](std::uint32_t i) {
    return (q.x - p.x) * (places[i].y - p.y) - (q.y - p.y) * (places[i].x - p.x);
  })];
  const Rational third(Integer(1), Integer(3));
  return inner_ =
             constants_->point(frame_point((p.x + q.x + r.x) * third, (p.y + q.y + r.y) * third));
}

std::size_t BodyFrame::bytes() const {
  return hierarchy_.bytes() +
         (lines_.capacity() + points_.capacity() + vertices_.capacity() +
          polygon_edges_.capacity() + across_[0].capacity() + across_[1].capacity()) *
             sizeof(ObjectId);
}

BodyFrames::BodyFrames(Kernel& kernel, const Scene& scene, CutPolicy policy)
    : scene_(scene),
      policy_(policy),
      constants_(kernel),
      of_body_(scene.objects.size(), std::array<BodyFrame*, 2>{nullptr, nullptr}),
      different_(ByPolygon{&scene}),
      places_of_body_(scene.objects.size(), nullptr) {}

BodyFrame& BodyFrames::frame(ObjectId body, bool negated) {
  BodyFrame*& known = of_body_[body][negated ? 1 : 0];
  if (known != nullptr) return *known;
  const ObjectId like = different_.try_emplace(body).first->first;
  if (like != body) return *(known = &frame(like, negated));
  FramePolygon polygon = frame_polygon(scene_.objects[body].polygon, negated);
  auto [place, is_new] = by_polygon_.try_emplace(polygon.vertices);
  if (is_new) {
    place->second =
        std::make_unique<BodyFrame>(OuterHierarchy(std::move(polygon), policy_), constants_);
  }
  known = place->second.get();
  return *known;
}

std::uint32_t BodyFrames::place(ObjectId body, bool negated, std::uint32_t i) const {
  Places*& known = places_of_body_[body];
  if (known == nullptr) known = &different_.try_emplace(body).first->second;
  std::vector<std::uint32_t>& places = (*known)[negated ? 1 : 0];
  if (places.empty()) find_places(body, negated, places);
  return places[i];
}

void BodyFrames::find_places(ObjectId body, bool negated,
                             std::vector<std::uint32_t>& places) const {
  std::map<FramePoint, std::uint32_t> of_point;
  std::uint32_t next = 0;
  for (const Vertex2& v : scene_.objects[body].polygon) {
    of_point.try_emplace(negated ? frame_point(-v[0], -v[1]) : frame_point(v[0], v[1]), next++);
  }
  const auto look_up = [&](const std::vector<FramePoint>& vertices) {
    for (const FramePoint& p : vertices) places.push_back(of_point.at(p));
  };
  // The polygon of a frame takes longer to make than all places to find.
  if (const BodyFrame* frame = of_body_[body][negated ? 1 : 0]; frame != nullptr) {
    look_up(frame->hierarchy().polygon().vertices);
  } else {
    look_up(frame_polygon(scene_.objects[body].polygon, negated).vertices);
  }
}

std::size_t BodyFrames::bytes() const {
  std::size_t total = constants_.bytes() + of_body_.capacity() * sizeof(of_body_[0]) +
                      places_of_body_.capacity() * sizeof(places_of_body_[0]);
  for (const auto& [body, places] : different_) {
    total += sizeof(places) + 48;
    for (const auto& list : places) total += list.capacity() * sizeof(std::uint32_t);
  }
  for (const auto& [vertices, frame] : by_polygon_) {
    total += frame->bytes() + vertices.capacity() * sizeof(FramePoint);
  }
  return total;
}

}  // namespace kinex
