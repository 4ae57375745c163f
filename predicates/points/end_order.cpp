// SPDX-License-Identifier: GPL-3.0-or-later
// end_order(a, b) = (x_b +- h_b) - (x_a +- h_a), and half_width(a) = h_a.
// Degree 1 in the coordinates, d in t. Identities: predicates/points/extent_predicates.h.
#include <array>
#include <string_view>

#include "core/arithmetic/predicate_formula.h"
#include "predicates/points/extent_predicates.h"

namespace kinex {
namespace {

template <EndClaim claim>
struct EndOrder {
  static constexpr bool kSameEnds = claim == EndClaim::kLowerEnds || claim == EndClaim::kUpperEnds;
  static constexpr int kArity = 2;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = kSameEnds ? 2 : 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 2> kOrdered{{{"before"}, {"after"}}};
  static constexpr std::array<ArgumentRole, 2> kEnds{{{"lower end"}, {"upper end"}}};

  EndAxes axes;

  static std::string_view name_of(EndClaim which, int axis) {
    static constexpr std::array<std::array<std::string_view, 3>, 4> kNames{
        {{"lower_ends_x", "lower_ends_y", "lower_ends_z"},
         {"upper_ends_x", "upper_ends_y", "upper_ends_z"},
         {"meeting_x", "meeting_y", "meeting_z"},
         {"apart_x", "apart_y", "apart_z"}}};
    return kNames[static_cast<std::size_t>(which)][static_cast<std::size_t>(axis)];
  }
  std::string_view name() const { return name_of(claim, axes.axis); }
  int dimension() const { return axes.extent + 1; }
  int first_by_value() const { return axes.dimension; }
  ClaimForm form() const {
    ClaimForm form{ClaimFigure::kOrder, claim == EndClaim::kApart ? -1 : 1,
                   kSameEnds ? kOrdered : kEnds, says(), {}};
    form.direction.resize(static_cast<std::size_t>(axes.axis) + 1);
    form.direction.back() = Integer(1);
    return form;
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto a = p(0, axes.axis), b = p(1, axes.axis);
    const auto r = p(0, axes.extent), s = p(1, axes.extent);
    if constexpr (claim == EndClaim::kLowerEnds) return widen((b - a) + (r - s));
    if constexpr (claim == EndClaim::kUpperEnds) return widen((b - a) + (s - r));
    if constexpr (claim == EndClaim::kMeeting) return widen((b - a) + (r + s));
    if constexpr (claim == EndClaim::kApart) return widen((a - b) - (r + s));
  }

 private:
  static constexpr std::string_view says() {
    switch (claim) {
      case EndClaim::kLowerEnds: return "the lower end of {0} is not beyond that of {1}";
      case EndClaim::kUpperEnds: return "the upper end of {0} is not beyond that of {1}";
      case EndClaim::kMeeting: return "the lower end of {0} is not beyond the upper end of {1}";
      case EndClaim::kApart: return "the upper end of {1} is not beyond the lower end of {0}";
    }
    return {};
  }
};

template <EndClaim claim>
class EndPredicate final : public FormulaPredicate<EndOrder<claim>> {
 public:
  explicit EndPredicate(const EndAxes& axes)
      : FormulaPredicate<EndOrder<claim>>(EndOrder<claim>{axes}), axis_(axes.axis) {}
  std::string_view opposite() const override {
    if constexpr (claim == EndClaim::kMeeting) return EndOrder<claim>::name_of(EndClaim::kApart, axis_);
    if constexpr (claim == EndClaim::kApart) return EndOrder<claim>::name_of(EndClaim::kMeeting, axis_);
    return {};
  }

 private:
  int axis_;
};

template <bool kNegated>
struct HalfWidth {
  static constexpr int kArity = 1;
  static constexpr int kDegree = 1;
  static constexpr int kAlternating = 0;
  static constexpr int kReference = 0;
  static constexpr bool kOnlyToReference = true;
  static constexpr std::array<ArgumentRole, 1> kRoles{{{"box"}}};

  EndAxes axes;

  std::string_view name() const {
    return name_of(kNegated, axes.axis);
  }
  static std::string_view name_of(bool negated, int axis) {
    static constexpr std::array<std::array<std::string_view, 3>, 2> kNames{
        {{"half_width_x", "half_width_y", "half_width_z"},
         {"no_width_x", "no_width_y", "no_width_z"}}};
    return kNames[negated ? 1 : 0][static_cast<std::size_t>(axis)];
  }
  int dimension() const { return axes.extent + 1; }
  int first_by_value() const { return axes.dimension; }
  ClaimForm form() const {
    return {ClaimFigure::kNone, 1, kRoles,
            kNegated ? "the upper end of {0} is not beyond its lower end"
                     : "the lower end of {0} is not beyond its upper end",
            {}};
  }

  template <class Points>
  auto value(const Points& p) const {
    const auto half = p(0, axes.extent);
    if constexpr (kNegated) return widen((half - half) - half);
    if constexpr (!kNegated) return widen(half);
  }
};

template <bool kNegated>
class WidthPredicate final : public FormulaPredicate<HalfWidth<kNegated>> {
 public:
  explicit WidthPredicate(const EndAxes& axes)
      : FormulaPredicate<HalfWidth<kNegated>>(HalfWidth<kNegated>{axes}), axis_(axes.axis) {}
  std::string_view opposite() const override {
    return HalfWidth<kNegated>::name_of(!kNegated, axis_);
  }

 private:
  int axis_;
};

}  // namespace

std::shared_ptr<const Predicate> make_end_order(EndClaim claim, const EndAxes& axes) {
  switch (claim) {
    case EndClaim::kLowerEnds: return std::make_shared<EndPredicate<EndClaim::kLowerEnds>>(axes);
    case EndClaim::kUpperEnds: return std::make_shared<EndPredicate<EndClaim::kUpperEnds>>(axes);
    case EndClaim::kMeeting: return std::make_shared<EndPredicate<EndClaim::kMeeting>>(axes);
    case EndClaim::kApart: break;
  }
  return std::make_shared<EndPredicate<EndClaim::kApart>>(axes);
}

std::shared_ptr<const Predicate> make_half_width(const EndAxes& axes) {
  return std::make_shared<WidthPredicate<false>>(axes);
}
std::shared_ptr<const Predicate> make_no_width(const EndAxes& axes) {
  return std::make_shared<WidthPredicate<true>>(axes);
}

}  // namespace kinex
