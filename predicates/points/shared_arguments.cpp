// SPDX-License-Identifier: GPL-3.0-or-later
#include "predicates/points/shared_arguments.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kinex {
namespace {

using Pattern = std::vector<std::uint8_t>;

std::string name_of(std::string_view whole, const Pattern& pattern) {
  std::string name = std::string(whole) + "/";
  for (const std::uint8_t place : pattern) name += static_cast<char>('0' + place);
  return name;
}

class SharedArguments final : public Predicate {
 public:
  SharedArguments(std::shared_ptr<const Predicate> whole, Pattern pattern)
      : whole_(std::move(whole)),
        pattern_(std::move(pattern)),
        arity_(1 + *std::max_element(pattern_.begin(), pattern_.end())),
        name_(name_of(whole_->name(), pattern_)) {
    if (whole_->alternates_in_halves()) {
      Pattern exchanged = pattern_;
      std::rotate(exchanged.begin(),
                  exchanged.begin() + static_cast<std::ptrdiff_t>(exchanged.size() / 2),
                  exchanged.end());
      if (exchanged != pattern_) opposite_ = name_of(whole_->name(), exchanged);
    }
    describe();
  }

  std::string_view name() const override { return name_; }
  std::string_view opposite() const override { return opposite_; }
  int arity() const override { return arity_; }
  int dimension() const override { return whole_->dimension(); }
  int degree(int d) const override { return whole_->degree(d); }
  int alternating() const override { return 0; }
  bool has_unit() const override { return whole_->has_unit(); }
  bool negates(const Predicate& other) const override {
    const auto* same = dynamic_cast<const SharedArguments*>(&other);
    if (same == nullptr || pattern_ != same->pattern_) return Predicate::negates(other);
    return whole_->negates(*same->whole_);
  }
  int homogeneity() const override { return whole_->homogeneity(); }
  double reach_error(int d) const override { return whole_->reach_error(d); }
  bool shifts(int d) const override { return whole_->shifts(d); }
  ClaimForm form() const override {
    ClaimForm form = whole_->form();
    if (!form.says.empty()) form.says = says_;
    form.roles = roles_;
    form.places = pattern_;
    return form;
  }

  void narrow(int d, const MotionView<std::int64_t>* points, Int128* out) const override {
    whole_->narrow(d, spread(points).data(), out);
  }
  bool narrow_fits(int d, const double* magnitude, double unit) const override {
    return whole_->narrow_fits(d, magnitude, unit);
  }
  void ball(int d, const MotionView<Ball>* points, double shift, Ball* out) const override {
    whole_->ball(d, spread(points).data(), shift, out);
  }
  void plain(int d, const MotionView<double>* points, double shift, double* out) const override {
    whole_->plain(d, spread(points).data(), shift, out);
  }
  void plain_with_reach(int d, const MotionView<double>* points, double shift, double* out,
                        double* reach) const override {
    whole_->plain_with_reach(d, spread(points).data(), shift, out, reach);
  }
  void multiprecision(int d, const MotionView<MpFloat>* points, MpFloat* out) const override {
    whole_->multiprecision(d, spread(points).data(), out);
  }
  Polynomial exact(int d, const MotionView<Integer>* points) const override {
    return whole_->exact(d, spread(points).data());
  }
  std::vector<Rational> rational(int d, const MotionView<Rational>* points) const override {
    return whole_->rational(d, spread(points).data());
  }

 private:
  // The arguments of the whole, and the unit.
  template <class R>
  std::array<MotionView<R>, kMaxViews> spread(const MotionView<R>* points) const {
    std::array<MotionView<R>, kMaxViews> all{};
    for (std::size_t i = 0; i < pattern_.size(); ++i) all[i] = points[pattern_[i]];
    if (has_unit()) all[pattern_.size()] = points[arity_];
    return all;
  }

  // An object has the role of the first argument that it is.
  void describe() {
    const ClaimForm form = whole_->form();
    for (int object = 0; object < arity_ && !form.roles.empty(); ++object) {
      const auto first = std::find(pattern_.begin(), pattern_.end(), object);
      roles_.push_back(form.roles[static_cast<std::size_t>(first - pattern_.begin())]);
    }
    for (std::size_t i = 0; i < form.says.size(); ++i) {
      says_ += form.says[i];
      if (form.says[i] != '{' || i + 1 == form.says.size()) continue;
      const auto argument = static_cast<std::size_t>(form.says[++i] - '0');
      says_ += static_cast<char>('0' + pattern_[argument]);
    }
  }

  std::shared_ptr<const Predicate> whole_;
  Pattern pattern_;
  int arity_;
  std::string name_, opposite_, says_;
  std::vector<ArgumentRole> roles_;
};

}  // namespace

std::shared_ptr<const Predicate> make_shared_arguments(std::shared_ptr<const Predicate> whole,
                                                       std::span<const std::uint8_t> pattern) {
  Pattern numbers(pattern.begin(), pattern.end()), sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  bool fits = !sorted.empty() && sorted.front() == 0 && sorted.back() < kMaxArity &&
              sorted.size() == static_cast<std::size_t>(whole->arity());
  for (std::size_t i = 1; i < sorted.size(); ++i) fits = fits && sorted[i] <= sorted[i - 1] + 1;
  if (!fits) throw std::invalid_argument("the pattern of shared arguments leaves out an object");
  return std::make_shared<SharedArguments>(std::move(whole), std::move(numbers));
}

}  // namespace kinex
