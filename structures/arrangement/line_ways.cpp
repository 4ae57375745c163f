// SPDX-License-Identifier: GPL-3.0-or-later
#include "structures/arrangement/line_ways.h"

#include <algorithm>
#include <string>
#include <utility>

#include "predicates/predicates.h"

namespace kinex {

LineWays::LineWays(Kernel& kernel, StructureId id, CuttingCells& cells, std::size_t objects)
    : kernel_(&kernel),
      cells_(&cells),
      slope_(kernel.bind(make_coordinate_order(0))),
      height_(kernel.bind(make_coordinate_order(1))),
      orientation_(kernel.bind(make_orientation_2())),
      order_(kernel.bind(make_slope_order_2())),
      slots_(kernel, id, "ways"),
      ways_(objects) {}

// ---- corners

int LineWays::slope_order(ObjectId l, ObjectId m) const {
  const Sign sign = kernel_->sign_after({slope_, {l, m}});
  return sign == Sign::kPositive ? 1 : sign == Sign::kNegative ? -1 : 0;
}

LineWays::Corner LineWays::corner(const std::array<ObjectId, 2>& crossing, bool right,
                                  ObjectId on) {
  if (crossing[0] == kNoObject) return {right ? At::kRightEnd : At::kLeftEnd, crossing, on};
  return {At::kCrossing, crossing, on};
}

// At the crossing of lines a and b, of ascending slopes, line g is above h by
// ((a_b - a_a) (b_g - b_h) - (b_b - b_a) (a_g - a_h)) / (a_b - a_a), where h may be a.
Query LineWays::claim(const Step& step, const Corner& corner, bool above) const {
  const ObjectId g = step.line, h = corner.on;
  if (corner.at != At::kCrossing) {
    const int steeper = slope_order(h, g);
    if (steeper == 0) return above ? Query(height_, {h, g}) : Query(height_, {g, h});
    return above == (corner.at == At::kRightEnd) ? Query(slope_, {h, g}) : Query(slope_, {g, h});
  }
  auto [a, b] = corner.crossing;
  if (step.lines->side(a, b) < 0) std::swap(a, b);
  if (h == a || h == b)
    return above ? Query(orientation_, {a, b, g}) : Query(orientation_, {b, a, g});
  return above ? Query(order_, {a, b, h, g}) : Query(order_, {a, b, g, h});
}

// If a is raised the crossing goes to the right on b, and g gains by its slope beyond that of h, or of b.
bool LineWays::is_tied_above(const Step& step, const Corner& corner) const {
  const ObjectId g = step.line, h = corner.on;
  if (corner.at != At::kCrossing) return g < h;
  auto [a, b] = corner.crossing;
  if (step.lines->side(a, b) < 0) std::swap(a, b);
  const bool itself = h == a || h == b;
  std::array<std::pair<ObjectId, int>, 4> parts{{{g, 1},
                                                 {itself ? kNoObject : h, -1},
                                                 {a, slope_order(itself ? b : h, g)},
                                                 {b, -slope_order(itself ? a : h, g)}}};
  std::sort(parts.begin(), parts.end());
  for (const auto& [id, sign] : parts) {
    if (sign != 0) return sign > 0;
  }
  return false;
}

bool LineWays::is_above(const Step& step, const Corner& corner) const {
  const Sign sign = kernel_->sign_after(claim(step, corner, true));
  return sign == Sign::kPositive || (sign == Sign::kZero && is_tied_above(step, corner));
}

void LineWays::prove(Step& step, const Corner& corner, bool above) const {
  step.claims.push_back(claim(step, corner, above));
}

// ---- a way

// Far to the left the first of the slopes is the highest line.
LineWays::Cell LineWays::begin(Step& step, const std::vector<ObjectId>& slopes) const {
  const std::array<ObjectId, 2> none{kNoObject, kNoObject};
  std::size_t low = 0, high = slopes.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (is_above(step, corner(none, false, slopes[middle]))) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const ObjectId ceiling = low == 0 ? kNoObject : slopes[low - 1];
  const ObjectId floor = low == slopes.size() ? kNoObject : slopes[low];
  if (ceiling != kNoObject) prove(step, corner(none, false, ceiling), false);
  if (floor != kNoObject) prove(step, corner(none, false, floor), true);
  return cells_->find([&](const CuttingCells::Trapezoid& t) {
    return t.left[0] == kNoObject && t.floor == floor && t.ceiling == ceiling;
  });
}

// The cell on the other side of a sample line that is passed upwards or downwards.
LineWays::Cell LineWays::behind(Step& step, ObjectId line, bool up) const {
  const Cell cell = cells_->find([&](const CuttingCells::Trapezoid& t) {
    return (up ? t.floor : t.ceiling) == line &&
           (t.left[0] == kNoObject || is_above(step, corner(t.left, false, line)) != up) &&
           (t.right[0] == kNoObject || is_above(step, corner(t.right, true, line)) == up);
  });
  if (cell == CuttingCells::kNone) return cell;
  const CuttingCells::Trapezoid& t = cells_->trapezoid(cell);
  if (t.left[0] != kNoObject) prove(step, corner(t.left, false, line), !up);
  return cell;
}

// `ends`: it goes on without end to the right.
LineWays::Cell LineWays::next(Step& step, Cell cell, bool& ends) const {
  const CuttingCells::Trapezoid& t = cells_->trapezoid(cell);
  ends = false;
  for (const bool up : {true, false}) {
    const ObjectId line = up ? t.ceiling : t.floor;
    if (line == kNoObject) continue;
    const Corner right = corner(t.right, true, line);
    if (is_above(step, right) != up) continue;
    prove(step, right, up);
    return behind(step, line, up);
  }
  for (const bool up : {true, false}) {
    const ObjectId line = up ? t.ceiling : t.floor;
    if (line != kNoObject) prove(step, corner(t.right, true, line), !up);
  }
  ends = t.right[0] == kNoObject;
  return ends ? CuttingCells::kNone : cells_->behind(cell);
}

bool LineWays::lead(ObjectId line, const std::vector<ObjectId>& slopes,
                    const CrossingLists& lines) {
  Step step{line, &lines, {}, {}};
  bool ends = false;
  for (Cell cell = begin(step, slopes); !ends; cell = next(step, cell, ends)) {
    if (cell == CuttingCells::kNone || step.cells.size() == cells_->size()) {
      forget(line);
      return false;
    }
    step.cells.push_back(cell);
  }
  keep(line, std::move(step));
  return true;
}

// Claims at the beginning and at the end of the way that are the same keep their certificates.
void LineWays::keep(ObjectId line, Step&& step) {
  Way& way = ways_[line];
  std::vector<Claim> fresh;
  for (const Query& query : step.claims) fresh.push_back({query});
  const std::size_t most = std::min(fresh.size(), way.claims.size());
  std::size_t front = 0, back = 0;
  const auto take = [](Claim& to, Claim& from) {
    if (to.query != from.query || from.certificate == kNoCertificate) return false;
    to.certificate = std::exchange(from.certificate, kNoCertificate);
    return true;
  };
  while (front < most && take(fresh[front], way.claims[front])) ++front;
  while (front + back < most &&
         take(fresh[fresh.size() - 1 - back], way.claims[way.claims.size() - 1 - back])) {
    ++back;
  }
  for (std::size_t i = front; i < way.claims.size(); ++i) slots_.drop(way.claims[i].certificate);
  for (Claim& claim : fresh) {
    if (claim.certificate == kNoCertificate) slots_.set(claim.certificate, claim.query, line);
  }
  way.claims = std::move(fresh);
  leave_cells(line);
  way.cells = std::move(step.cells);
  for (const Cell cell : way.cells) cells_->add_line(cell, line);
}

void LineWays::leave_cells(ObjectId line) {
  for (const Cell cell : ways_[line].cells) cells_->remove_line(cell, line);
  ways_[line].cells.clear();
}

void LineWays::forget(ObjectId line) {
  leave_cells(line);
  for (Claim& claim : ways_[line].claims) slots_.drop(claim.certificate);
  ways_[line].claims.clear();
}

ObjectId LineWays::failed(CertificateId c) {
  const ObjectId line = slots_.failed(c);
  for (Claim& claim : ways_[line].claims) {
    if (claim.certificate == c) slots_.drop(claim.certificate);
  }
  return line;
}

// ---- for others

void LineWays::visit_proof(ProofVisitor& visitor) const {
  ProofGroup group;
  group.kind = "way of a line";
  for (ObjectId line = 0; line < ways_.size(); ++line) {
    if (ways_[line].claims.empty()) continue;
    group.about = {line};
    group.text = "through " + std::to_string(ways_[line].cells.size()) + " trapezoids";
    visitor.group(group);
    for (const Claim& claim : ways_[line].claims) {
      if (claim.certificate != kNoCertificate) visitor.certificate(claim.certificate, "corner");
    }
  }
}

void LineWays::check(ObjectId line, AuditReport& report) const {
  const Way& way = ways_[line];
  const auto where = [line] { return " of line " + std::to_string(line); };
  report.check(!way.cells.empty(), [&] { return "a missing way" + where(); });
  for (const Claim& claim : way.claims) {
    report.check(slots_.holds(claim.certificate, claim.query, line),
                 [&] { return "a wrong certificate" + where(); });
  }
  for (std::size_t i = 0; i < way.cells.size(); ++i) {
    const CuttingCells::Trapezoid& t = cells_->trapezoid(way.cells[i]);
    report.check(cells_->is_crossed(way.cells[i], line),
                 [&] { return "a trapezoid that does not know a line" + where(); });
    report.check(
        (t.left[0] == kNoObject || i > 0) && (t.right[0] == kNoObject || i + 1 < way.cells.size()),
        [&] { return "a way with an end" + where(); });
    if (i == 0) continue;
    const CuttingCells::Trapezoid& s = cells_->trapezoid(way.cells[i - 1]);
    const bool wall = cells_->behind(way.cells[i - 1]) == way.cells[i];
    report.check(wall || (s.ceiling != kNoObject && s.ceiling == t.floor) ||
                     (s.floor != kNoObject && s.floor == t.ceiling),
                 [&] { return "a step between two trapezoids that do not touch" + where(); });
  }
}

std::size_t LineWays::bytes() const {
  std::size_t result = ways_.capacity() * sizeof(Way);
  for (const Way& way : ways_) {
    result += way.cells.capacity() * sizeof(Cell) + way.claims.capacity() * sizeof(Claim);
  }
  return result;
}

}  // namespace kinex
