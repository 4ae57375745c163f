// SPDX-License-Identifier: GPL-3.0-or-later
// ReplayedOrders: an attribute of the shape kOrders that is an arrangement of lines, changed by its
// events alone. For every line and two that it crosses it keeps which one comes first.
//
// A triple changes that for each of its lines, a parallel for each of its lines and the other one,
// against all that the line crosses; the order of several events is of no importance.
#ifndef KINEX_TESTS_STRUCTURES_REPLAYED_ORDERS_H
#define KINEX_TESTS_STRUCTURES_REPLAYED_ORDERS_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/engine/structure.h"

namespace kinex::test {

class ReplayedOrders {
 public:
  ReplayedOrders() = default;
  explicit ReplayedOrders(const Attribute& attribute) {
    const std::size_t n = width_of_orders(attribute);
    const auto begin = attribute.ids.begin();
    for (std::size_t i = 0; i < attribute.ids.size(); i += n) {
      const auto first = begin + static_cast<std::ptrdiff_t>(i);
      rows_.emplace_back(first, first + static_cast<std::ptrdiff_t>(n));
    }
    if (n == 0) return;
    ids_ = rows_[0];
    std::sort(ids_.begin(), ids_.end());
    const std::size_t most = ids_.back() + std::size_t{1};
    for (const Ids& row : rows_) {
      before_.emplace_back(most, std::vector<bool>(most));
      for (auto a = row.begin(); a != row.end(); ++a) {
        for (auto b = a + 1; b != row.end(); ++b) before_.back()[*a][*b] = true;
      }
    }
  }

  // The defect of the event; empty: none.
  std::string apply(std::string_view kind, const Event& event) {
    const ObjectId a = event.ids[0], b = event.ids[1], c = event.ids[2];
    for (std::size_t i = 0; i < event.count; ++i) {
      if (!std::binary_search(ids_.begin(), ids_.end(), event.ids[i])) return "no such line";
    }
    if (kind == "triple") {
      if (!(a < b && b < c)) return "a triple that does not ascend";
      exchange(row_of(a), b, c);
      exchange(row_of(b), a, c);
      exchange(row_of(c), a, b);
    } else if (kind == "parallel" || kind == "equal") {
      if (!(a < b)) return "a pair that does not ascend";
      if (is_parallel(a, b) != (kind == "equal")) return "parallels of another kind";
      exchange(0, a, b);
      if (kind == "equal") return "";
      pass(a, b);
      pass(b, a);
    } else {
      return "an external event of another kind";
    }
    return "";
  }
  Attribute attribute() const {
    Attribute result{Attribute::Shape::kOrders, {}};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Relation& before = before_[i];
      const auto ahead = [&](ObjectId id) {
        return std::count_if(ids_.begin(), ids_.end(), [&](ObjectId x) { return before[x][id]; });
      };
      Ids row = ids_;
      std::stable_sort(row.begin(), row.end(),
                       [&](ObjectId x, ObjectId y) { return ahead(x) < ahead(y); });
      result.ids.insert(result.ids.end(), row.begin(), row.end());
    }
    return result;
  }

 private:
  using Ids = std::vector<ObjectId>;
  using Relation = std::vector<std::vector<bool>>;

  std::size_t row_of(ObjectId id) const {
    return 1 + static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) -
                                        ids_.begin());
  }
  // Identically: it comes before the line on the line itself.
  bool is_parallel(ObjectId line, ObjectId other) const { return before_[row_of(line)][other][line]; }
  void exchange(std::size_t row, ObjectId a, ObjectId b) {
    if (row > 0) {
      const ObjectId line = ids_[row - 1];
      if (is_parallel(line, a) || is_parallel(line, b)) return;  // they do not both cross it
    }
    Relation& before = before_[row];
    before[a][b].flip();
    before[b][a].flip();
  }
  void pass(ObjectId line, ObjectId other) {
    for (const ObjectId k : ids_) {
      if (k != line && k != other) exchange(row_of(line), k, other);
    }
  }

  std::vector<Ids> rows_;  // at the beginning
  Ids ids_;                // ascending
  std::vector<Relation> before_;  // by row, id and id
};

}  // namespace kinex::test

#endif
