// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/face_walls.h"

#include <algorithm>
#include <string>

#include "predicates/predicates.h"
#include "structures/parts/sort_unique.h"
#include "structures/parts/ties.h"

namespace kinex {
namespace {

FaceWalls::Side other(FaceWalls::Side side) {
  return side == FaceWalls::kUp ? FaceWalls::kDown : FaceWalls::kUp;
}

}  // namespace

FaceWalls::FaceWalls(Kernel& kernel, StructureId id, const CrossingLists& crossings)
    : kernel_(&kernel),
      crossings_(&crossings),
      order_(kernel.bind(make_slope_order_2())),
      slots_(kernel, id, "walls") {
  const std::size_t lines = numbers().count();
  ends_.assign(2 * lines * lines, kAbsent);
  before_ = ends_;
  certificates_.assign(ends_.size(), kNoCertificate);
  nexts_.resize(ends_.size());
  marks_.resize(2 * lines * (lines + 1));
}

// ---- faces

bool FaceWalls::crosses(ObjectId l, ObjectId m) const {
  return l != m && crossings_->side(l, m) != 0;
}

// By slope from right to left is the order far to the right, from above, but of parallel lines the
// first one is the higher one there, too.
std::vector<FaceWalls::Far> FaceWalls::far_right(std::span<const ObjectId> slopes) const {
  std::vector<ObjectId> order;
  for (std::size_t end = slopes.size(); end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && crossings_->side(slopes[begin - 1], slopes[begin]) == 0) --begin;
    for (std::size_t i = begin; i < end; ++i) order.push_back(slopes[i]);
    end = begin;
  }
  std::vector<Far> far(numbers().count());
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    far[numbers()[order[i]]].below = order[i + 1];
    far[numbers()[order[i + 1]]].above = order[i];
  }
  return far;
}

// At a crossing to the right a face goes on above a steeper line, or below one that is less steep;
// to the left the reverse. Otherwise the two chains meet there.
bool FaceWalls::walk(const Edge& start, Side side, Chain& chain) const {
  const int up = side == kUp ? 1 : -1;
  const std::size_t most = crossings_->lines().size();
  chain = {};
  for (Edge edge = start;;) {
    chain.edges.push_back(edge);
    if (chain.edges.size() > most) return false;
    if (edge == first_edge(edge.line)) break;
    const ObjectId next = crossings_->order(edge.line)[edge.place];
    if (crossings_->side(edge.line, next) * up > 0) {
      chain.left = edge_after(next, edge.line);
      break;
    }
    edge = edge_before(next, edge.line);
  }
  std::reverse(chain.edges.begin(), chain.edges.end());
  for (Edge edge = start;;) {
    if (edge == last_edge(edge.line)) break;
    const ObjectId next = crossings_->order(edge.line)[edge.place + 1];
    if (crossings_->side(edge.line, next) * up < 0) {
      chain.right = edge_before(next, edge.line);
      break;
    }
    edge = edge_after(next, edge.line);
    chain.edges.push_back(edge);
    if (chain.edges.size() > most) return false;
  }
  return true;
}

bool FaceWalls::face_at(const Edge& edge, Side side, std::span<const Far> far, Face& face) const {
  Chain& own = face.chains[side];
  Chain& opposite = face.chains[other(side)];
  opposite = {};
  if (!walk(edge, side, own)) return false;
  std::optional<Edge> there = own.right ? own.right : own.left;
  if (!there) {
    const Far& next = far[numbers()[own.edges.back().line]];
    const ObjectId line = side == kUp ? next.above : next.below;
    if (line == kNoObject) return true;
    there = last_edge(line);
  }
  if (!walk(*there, other(side), opposite)) return false;
  const auto meet = [](const std::optional<Edge>& end, const Edge& last,
                       const std::optional<Edge>& opposite_end, const Edge& opposite_last) {
    if (!end) return !opposite_end;
    return opposite_end && *end == opposite_last && *opposite_end == last;
  };
  // A line is not both above and below a face.
  const auto is_opposite = [&opposite](const Edge& e) {
    return std::any_of(opposite.edges.begin(), opposite.edges.end(),
                       [&e](const Edge& other) { return other.line == e.line; });
  };
  if (!kernel_->is_exact() && std::any_of(own.edges.begin(), own.edges.end(), is_opposite))
    return false;
  return meet(own.left, own.edges.front(), opposite.left, opposite.edges.front()) &&
         meet(own.right, own.edges.back(), opposite.right, opposite.edges.back());
}

FaceWalls::Wall FaceWalls::wall_at(const Face& face, Side side, std::size_t i) const {
  const std::vector<Edge>& edges = face.chains[side].edges;
  const auto [l, m] = std::minmax(edges[i].line, edges[i + 1].line);
  return {l, m, side};
}

// ---- claims

// For lines l and m of ascending slopes the crossing is at x = -(b_m - b_l) / (a_m - a_l): compared
// after multiplication by both denominators.
Query FaceWalls::claim(const Wall& first, const Wall& second) const {
  const auto by_slope = [this](const Wall& wall) {
    return crossings_->side(wall.l, wall.m) > 0 ? std::pair(wall.l, wall.m)
                                                : std::pair(wall.m, wall.l);
  };
  const auto [a, b] = by_slope(first);
  const auto [c, d] = by_slope(second);
  return {order_, {c, d, a, b}};
}

// A line that is raised takes its crossing with a less steep one to the left.
bool FaceWalls::goes_first(const Wall& first, const Wall& second) const {
  const bool own = std::min(first.l, first.m) < std::min(second.l, second.m);
  const Wall& moves = own ? first : second;
  const bool to_the_left = crossings_->side(moves.l, moves.m) < 0;  // l is the smallest id
  return own == to_the_left;
}

bool FaceWalls::is_before(const Wall& first, const Wall& second) const {
  const Sign sign = kernel_->sign_after(claim(first, second));
  return sign == Sign::kPositive || (sign == Sign::kZero && goes_first(first, second));
}

// ---- cutting a face

void FaceWalls::set_end(const Wall& wall, ObjectId end) {
  if (ends_[at(wall)] == end) return;
  ends_[at(wall)] = end;
  changed_.push_back(wall);
}

void FaceWalls::link(const Wall& wall, const Wall& next) {
  const std::size_t place = at(wall);
  nexts_[place] = static_cast<std::uint32_t>(at(next));
  slots_.renew(certificates_[place], claim(wall, next), static_cast<std::uint32_t>(place));
}

void FaceWalls::cut(const Face& face) {
  std::array<std::size_t, 2> done{0, 0};
  std::array<std::size_t, 2> count;
  for (const Side side : {kUp, kDown}) {
    const std::size_t edges = face.chains[side].edges.size();
    count[side] = edges == 0 ? 0 : edges - 1;
  }
  std::optional<Wall> last;
  while (done[kUp] < count[kUp] || done[kDown] < count[kDown]) {
    Side side = done[kUp] < count[kUp] ? kUp : kDown;
    if (side == kUp && done[kDown] < count[kDown] &&
        !is_before(wall_at(face, kUp, done[kUp]), wall_at(face, kDown, done[kDown]))) {
      side = kDown;
    }
    const Wall wall = wall_at(face, side, done[side]++);
    const std::vector<Edge>& opposite = face.chains[other(side)].edges;
    set_end(wall, opposite.empty() ? kNoObject : opposite[done[other(side)]].line);
    if (last && last->side != side) {
      link(*last, wall);
    } else if (last) {
      slots_.drop(certificates_[at(*last)]);
    }
    last = wall;
  }
  if (last) slots_.drop(certificates_[at(*last)]);
}

bool FaceWalls::settle_at(const Edge& edge, Side side, std::span<const Far> far) {
  if (mark(edge, side) == round_) return true;
  Face face;
  if (!face_at(edge, side, far, face)) return false;
  for (const Side one : {kUp, kDown}) {
    for (const Edge& e : face.chains[one].edges) mark(e, one) = round_;
  }
  cut(face);
  return true;
}

bool FaceWalls::settle_along(ObjectId line, std::span<const Far> far) {
  for (Edge edge = first_edge(line); edge.place <= last_edge(line).place; ++edge.place) {
    for (const Side side : {kUp, kDown}) {
      if (!settle_at(edge, side, far)) return false;
    }
  }
  return true;
}

// Lines that have gone, and crossings that are no longer there, are in no face.
bool FaceWalls::settle_note(const Note& note, std::span<const Far> far) {
  const std::vector<ObjectId>& lines = crossings_->lines();
  for (const ObjectId line : {note.l, note.m}) {
    if (!std::binary_search(lines.begin(), lines.end(), line)) return true;
  }
  switch (note.what) {
    case What::kLine:
      return settle_along(note.l, far);
    case What::kEnds:
      for (const Side side : {kUp, kDown}) {
        if (!settle_at(first_edge(note.l), side, far)) return false;
        if (!settle_at(last_edge(note.l), side, far)) return false;
      }
      return true;
    case What::kCrossing:
      if (!crosses(note.l, note.m)) return true;
      for (const Side side : {kUp, kDown}) {
        if (!settle_at(edge_before(note.l, note.m), side, far)) return false;
        if (!settle_at(edge_after(note.l, note.m), side, far)) return false;
      }
      return true;
    case What::kWall:
      // Above it to the left is the line of the smaller slope, below it the other one.
      if (!crosses(note.l, note.m)) return true;
      const bool first = (crossings_->side(note.l, note.m) > 0) == (note.side == kUp);
      return settle_at(first ? edge_before(note.l, note.m) : edge_before(note.m, note.l), note.side,
                       far);
  }
  return true;
}

// ---- what the owner reports

std::array<ObjectId, 4> FaceWalls::failed(CertificateId c) {
  const std::size_t place = slots_.failed(c);
  const Wall first = wall_of(place), second = wall_of(nexts_[place]);
  slots_.drop(certificates_[place]);
  for (const Wall& wall : {first, second}) {
    notes_.push_back({wall.l, wall.m, What::kWall, wall.side});
  }
  return {first.l, first.m, second.l, second.m};
}

void FaceWalls::motions_changed(std::span<const ObjectId> objects) {
  each_tie(*kernel_, slots_.structure(), objects, [this](CertificateId c) {
    if (!slots_.owns(c)) return;
    const Wall wall = wall_of(kernel_->tag(c));
    notes_.push_back({wall.l, wall.m, What::kWall, wall.side});
  });
}

bool FaceWalls::settle(std::span<const ObjectId> slopes) {
  if (is_settled()) return true;
  ++round_;
  const std::vector<Far> far = far_right(slopes);
  const std::vector<Note> notes = std::exchange(notes_, {});
  if (!std::exchange(all_, false)) {
    return std::all_of(notes.begin(), notes.end(),
                       [&](const Note& note) { return settle_note(note, far); });
  }
  std::vector<bool> is_there(numbers().count());
  for (const ObjectId line : crossings_->lines()) is_there[numbers()[line]] = true;
  each(false, [&](const Wall& wall, ObjectId) {
    if (is_there[numbers()[wall.l]] && is_there[numbers()[wall.m]] && crosses(wall.l, wall.m))
      return;
    slots_.drop(certificates_[at(wall)]);
    set_end(wall, kAbsent);
  });
  for (const ObjectId line : crossings_->lines()) {
    if (!settle_along(line, far)) return false;
  }
  return true;
}

void FaceWalls::drop_proof() {
  each(false, [this](const Wall& wall, ObjectId) { slots_.drop(certificates_[at(wall)]); });
}

void FaceWalls::clear() {
  drop_proof();
  each(false, [this](const Wall& wall, ObjectId) { set_end(wall, kAbsent); });
  notes_.clear();
  all_ = false;
}

const std::vector<FaceWalls::Wall>& FaceWalls::changed() {
  sort_unique(changed_);
  return changed_;
}

void FaceWalls::forget() {
  for (const Wall& wall : changed_) before_[at(wall)] = ends_[at(wall)];
  changed_.clear();
}

// ---- for others

void FaceWalls::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "walls of a face";
  each(false, [&](const Wall& wall, ObjectId) {
    const CertificateId certificate = certificates_[at(wall)];
    if (certificate == kNoCertificate) return;
    const Wall next = wall_of(nexts_[at(wall)]);
    group.about = {wall.l, wall.m, next.l, next.m};
    group.text = "the crossing of the first two is to the left of that of the others";
    visitor.group(group);
    visitor.certificate(certificate, "order");
  });
}

std::vector<FaceWalls::Wall> FaceWalls::order_of(const Face& face) const {
  const std::vector<Edge>&lower = face.chains[kUp].edges, &upper = face.chains[kDown].edges;
  const auto index = [&lower](ObjectId line) {
    const auto found =
        std::find_if(lower.begin(), lower.end(), [line](const Edge& e) { return e.line == line; });
    return static_cast<std::size_t>(found - lower.begin());
  };
  std::vector<Wall> order;
  for (std::size_t i = 0, j = 0; i + 1 < lower.size() || j + 1 < upper.size();) {
    const bool down =
        j + 1 < upper.size() && (lower.size() < 2 || index(end(wall_at(face, kDown, j))) <= i);
    if (!down && i + 1 >= lower.size()) break;
    order.push_back(down ? wall_at(face, kDown, j++) : wall_at(face, kUp, i++));
  }
  return order;
}

void FaceWalls::check_face(const Face& face, AuditReport& report) const {
  const auto name = [](const Wall& wall) {
    return (wall.side == kUp ? " from crossing " : " down from crossing ") +
           std::to_string(wall.l) + ", " + std::to_string(wall.m);
  };
  const std::vector<Wall> order = order_of(face);
  std::array<std::size_t, 2> done{0, 0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<Edge>& opposite = face.chains[other(order[i].side)].edges;
    report.check(
        end(order[i]) == (opposite.empty() ? kNoObject : opposite[done[other(order[i].side)]].line),
        [&] { return "a wall that ends on another line:" + name(order[i]); });
    ++done[order[i].side];
    const std::size_t place = at(order[i]);
    if (i + 1 == order.size() || order[i].side == order[i + 1].side) {
      report.check(certificates_[place] == kNoCertificate,
                   [&] { return "a certificate too many:" + name(order[i]); });
      continue;
    }
    report.check(slots_.holds(certificates_[place], claim(order[i], order[i + 1]),
                              static_cast<std::uint32_t>(place)) &&
                     nexts_[place] == at(order[i + 1]),
                 [&] { return "a wrong certificate:" + name(order[i]); });
    report.check(!slots_.is_tie(certificates_[place]) || goes_first(order[i], order[i + 1]),
                 [&] { return "a tie in the wrong order:" + name(order[i]); });
  }
  for (const Side side : {kUp, kDown}) {
    const std::size_t edges = face.chains[side].edges.size();
    report.check(done[side] + 1 == edges || (edges == 0 && done[side] == 0),
                 [] { return "a wall that ends nowhere"; });
  }
}

void FaceWalls::check(std::span<const ObjectId> slopes, AuditReport& report) const {
  report.check(is_settled(), [] { return "a face was not cut"; });
  std::size_t faces = 0, walls = 0, there = 0;
  const bool sound = each_face(slopes, [&](const Face& face) {
    ++faces;
    for (const Chain& chain : face.chains)
      walls += chain.edges.empty() ? 0 : chain.edges.size() - 1;
    check_face(face, report);
  });
  report.check(sound, [] { return "a face that does not close"; });
  each(false, [&there](const Wall&, ObjectId) { ++there; });
  // Raised by infinitesimals no three lines meet: n lines with k crossings have n + k + 1 faces.
  const std::size_t n = slopes.size();
  report.check(walls == there, [] { return "another number of walls than in the faces"; });
  report.check(n == 0 || faces == n + there / 2 + 1, [] { return "another number of faces"; });
}

std::size_t FaceWalls::bytes() const {
  return (ends_.capacity() + before_.capacity()) * sizeof(ObjectId) +
         certificates_.capacity() * sizeof(CertificateId) +
         (nexts_.capacity() + marks_.capacity()) * sizeof(std::uint32_t) +
         notes_.capacity() * sizeof(Note) + changed_.capacity() * sizeof(Wall);
}

}  // namespace kinex
