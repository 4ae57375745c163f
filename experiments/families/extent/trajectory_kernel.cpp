// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/families/extent/trajectory_kernel.h"

#include <algorithm>
#include <utility>

#include "core/numbers/show_text.h"
#include "experiments/formats/counted.h"
#include "predicates/points/unit_directions.h"
#include "structures/registry.h"

namespace kinex::families {
namespace {

struct DualPoint {
  Rational slope, height;
  ObjectId object;
};

// One chain of a dual hull, by slope, and the times at which its edges are level: the upper one is
// the largest key, the lower one the smallest.
class Chain {
 public:
  // `sorted`: by slope, then height. `side`: 1 for the upper one, -1 for the lower one.
  Chain(const std::vector<DualPoint>& sorted, int side) {
    for (const DualPoint& c : sorted) {
      if (!vertices_.empty() && vertices_.back().slope == c.slope) {
        if (side < 0) continue;  // the lowest of one slope comes first
        vertices_.pop_back();
      }
      while (vertices_.size() >= 2) {
        if (side * turn(vertices_[vertices_.size() - 2], vertices_.back(), c) < 0) break;
        vertices_.pop_back();
      }
      vertices_.push_back(c);
    }
    if (side < 0) std::reverse(vertices_.begin(), vertices_.end());
    for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) {
      const DualPoint &a = vertices_[i], &b = vertices_[i + 1];
      times_.push_back(-(b.height - a.height) / (b.slope - a.slope));
    }
  }

  const std::vector<DualPoint>& vertices() const { return vertices_; }
  const std::vector<Rational>& times() const { return times_; }  // ascending
  // The extreme vertex at t.
  const DualPoint& at(const Rational& t) const {
    const auto place = std::lower_bound(times_.begin(), times_.end(), t);
    return vertices_[static_cast<std::size_t>(place - times_.begin())];
  }

 private:
  static int turn(const DualPoint& a, const DualPoint& b, const DualPoint& c) {
    return ((b.slope - a.slope) * (c.height - a.height) -
            (b.height - a.height) * (c.slope - a.slope))
        .sign();
  }

  std::vector<DualPoint> vertices_;
  std::vector<Rational> times_;
};

struct DualExtents {
  explicit DualExtents(std::vector<DualPoint> points) {
    std::sort(points.begin(), points.end(), [](const DualPoint& a, const DualPoint& b) {
      if (a.slope != b.slope) return a.slope < b.slope;
      return a.height != b.height ? a.height < b.height : a.object < b.object;
    });
    const auto same = [](const DualPoint& a, const DualPoint& b) {
      return a.slope == b.slope && a.height == b.height;
    };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    chains = {Chain(points, 1), Chain(points, -1)};
  }
  Rational extent(const Rational& t) const {
    const DualPoint &high = chains[0].at(t), &low = chains[1].at(t);
    return (high.slope - low.slope) * t + high.height - low.height;
  }
  std::vector<Chain> chains;  // upper, lower
};

// Between the times at which an edge of either hull is level both extents are linear in t, and
// their ratio is monotonous. Beyond all of them it tends to 1: the ends of both chains are chosen.
void choose(const std::vector<DualPoint>& points, const Rational& least, std::vector<bool>& kept) {
  const DualExtents all(points);
  std::vector<DualPoint> chosen;
  const auto take = [&](const DualPoint& p) {
    kept[p.object] = true;
    chosen.push_back(p);
  };
  for (const Chain& chain : all.chains) {
    take(chain.vertices().front());
    take(chain.vertices().back());
  }
  for (;;) {
    const DualExtents some(chosen);
    const Rational* worst = nullptr;
    Rational ratio = least;
    for (const DualExtents* extents : {&all, &some}) {
      for (const Chain& chain : extents->chains) {
        for (const Rational& t : chain.times()) {
          const Rational whole = all.extent(t);
          if (whole.is_zero()) continue;
          const Rational here = some.extent(t) / whole;
          if (!(here < ratio)) continue;
          ratio = here;
          worst = &t;
        }
      }
    }
    if (worst == nullptr) return;
    for (const Chain& chain : all.chains) take(chain.at(*worst));
  }
}

// The least k with (1 - error/2)^2 k^2 >= (1 - error)^2 (k^2 + 1).
int directions_for(const Rational& error) {
  const Rational half = Rational(1) - error / Rational(2), whole = Rational(1) - error;
  int k = 1;
  while (half * half * Rational(k) * Rational(k) <
         whole * whole * (Rational(k) * Rational(k) + Rational(1))) {
    ++k;
  }
  return k;
}

// The objects that requests name: in keys, in "of", and as queries (the first one by default).
void for_each_object(std::vector<Request>& requests, const auto& visit) {
  for (Request& request : requests) {
    if (request.key.kind == Key::Kind::kSquaredDistance) visit(request.key.object);
    for (ObjectId& object : request.of.objects) visit(object);
    const StructureInfo* const info = find_structure_info(request.structure);
    if (info != nullptr && info->query) {
      if (request.query == kNoObject) request.query = 0;
      visit(request.query);
      if (request.query == 0) request.query = kNoObject;
    }
    for_each_object(request.over, visit);
  }
}

bool compares_places(const Request& request) {
  const StructureInfo* const info = find_structure_info(request.structure);
  return info != nullptr && info->colours && request.colours.empty();
}

}  // namespace

Rational least_kernel_error() { return Rational(1) / Rational(100000); }

std::string kernel_refusal(const Scene& scene) {
  if (scene.has_bodies()) return "the objects are bodies; give a scene of points";
  if (scene.dimension != 2) {
    return "the scene has " +
           formats::counted(static_cast<std::uint64_t>(scene.dimension), "axis", "axes") +
           "; a kernel is a few points whose diameter is nearly that of all, in the plane: give a scene with 2 axes";
  }
  if (scene.has_lines())
    return "some objects are lines, which have no diameter; give a scene of points";
  if (scene.extents == Extents::kRadius || scene.extents == Extents::kHalfExtents) {
    return std::string("the objects are ") +
           (scene.extents == Extents::kRadius ? "discs" : "boxes") +
           ", and the diameter is that of points; give a scene of points";
  }
  if (std::any_of(scene.maintain.begin(), scene.maintain.end(), compares_places)) {
    return "what is maintained compares even and odd places, which change; name two colours";
  }
  for (const SceneObject& object : scene.objects) {
    const auto& pieces = object.motion.pieces;
    const auto& piece = pieces.front();
    const bool all_along = pieces.size() == 1 && (!piece.from || !(scene.start < *piece.from)) &&
                           (!piece.to || (scene.end && !(*piece.to < *scene.end)));
    if (!all_along) {
      return "object " + show_text(object.id) +
             " does not follow one motion all the time; give a scene in which all do";
    }
    if (piece.trajectory.degree() > 1) {
      return "object " + show_text(object.id) + " has a motion of degree " +
             std::to_string(piece.trajectory.degree()) + "; give a scene of linear motion";
    }
  }
  return "";
}

TrajectoryKernel trajectory_kernel(const Scene& scene, const Rational& error) {
  TrajectoryKernel kernel;
  kernel.k = directions_for(error);
  if (scene.objects.empty()) return kernel;
  std::vector<bool> kept(scene.objects.size(), false);
  for (const DirectionVector& u : unit_directions_2(kernel.k)) {
    std::vector<DualPoint> points;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
      DualPoint point{{}, {}, id};
      const Trajectory& motion = scene.objects[id].motion.pieces.front().trajectory;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::vector<Rational>& c = motion.coordinates[axis];
        if (!c.empty()) point.height += u[axis] * c[0];
        if (c.size() > 1) point.slope += u[axis] * c[1];
      }
      points.push_back(std::move(point));
    }
    choose(points, Rational(1) - error / Rational(2), kept);
  }
  for (ObjectId id = 0; id < kept.size(); ++id) {
    if (kept[id]) kernel.objects.push_back(id);
  }
  return kernel;
}

Scene only_objects(const Scene& scene, std::vector<ObjectId> objects) {
  Scene result = scene;
  for_each_object(result.maintain, [&](ObjectId object) { objects.push_back(object); });
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  result.objects.clear();
  for (const ObjectId id : objects) result.objects.push_back(scene.objects[id]);
  const auto place = [&objects](ObjectId object) {
    return static_cast<ObjectId>(std::lower_bound(objects.begin(), objects.end(), object) -
                                 objects.begin());
  };
  for_each_object(result.maintain, [&](ObjectId& object) { object = place(object); });
  return result;
}

const lab::Thinning kKernelThinning{
    least_kernel_error, kernel_refusal, [](const Scene& scene, const Rational& error) {
      const TrajectoryKernel kernel = trajectory_kernel(scene, error);
      return lab::ThinnedScene{only_objects(scene, kernel.objects),
                               "at all times their diameter is at least " +
                                   (Rational(1) - error).to_string() + " of that of all (by 2 * " +
                                   std::to_string(kernel.k) + " directions)"};
    }};

}  // namespace kinex::families
