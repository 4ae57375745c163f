// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arithmetic/motion_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/numbers/exactly.h"

namespace kinex {
namespace {

// With more bits of common denominator no scene gains from machine integers.
constexpr std::size_t kMaxScaleBits = 60;
// Differences of two narrow numbers are still exact in doubles.
constexpr double kMaxNarrow = 0x1p52;

// n / d * 2^exponent, d > 0.
Ball enclose(const Integer& n, const Integer& d, long exponent) {
  if (n.is_zero()) return {};
  long n_exponent, d_exponent;
  // Both are truncated to 53 bits: within one unit in the last place; the quotient is rounded.
  const double a = mpz_get_d_2exp(&n_exponent, n.raw());
  const double b = mpz_get_d_2exp(&d_exponent, d.raw());
  const long scale = std::clamp(n_exponent - d_exponent + exponent, -5000L, 5000L);
  const double v = std::ldexp(a / b, static_cast<int>(scale));
  return {v, std::fabs(v) * 3 * Ball::kUnit + 0x1p-1070};
}

// The same for d = 1 where nothing overflows or underflows: the quotient is the truncated n.
Ball enclose_whole(const Integer& n, unsigned long halvings) {
  constexpr std::size_t kMostWords = 12;
  constexpr unsigned long kMostHalvings = 900;
  if (n.is_zero()) return {};
  if (mpz_size(n.raw()) > kMostWords || halvings > kMostHalvings) {
    return enclose(n, Integer(1), -static_cast<long>(halvings));
  }
  double v = mpz_get_d(n.raw());
  if (halvings > 0) v = std::ldexp(v, -static_cast<int>(halvings));
  return {v, std::fabs(v) * 3 * Ball::kUnit + 0x1p-1070};
}

// The axes of a motion that are kept.
std::span<const std::vector<Rational>> kept(const Trajectory& trajectory,
                                            const NumberModel& model) {
  const std::size_t axes = static_cast<std::size_t>(model.axes);
  return std::span(trajectory.coordinates).first(std::min(axes, trajectory.coordinates.size()));
}

bool is_zero(std::span<const std::vector<Rational>> axes) {
  for (const auto& axis : axes) {
    for (const Rational& c : axis) {
      if (!c.is_zero()) return false;
    }
  }
  return true;
}

}  // namespace

NumberModel choose_number_model(const Scene& scene, const NumberNeeds& needs) {
  NumberModel model;
  model.axes = std::max(1, needs.axes);
  model.degree = std::max(1, needs.degree);
  const std::size_t powers = static_cast<std::size_t>(model.degree) + 1;
  const auto each = [&](auto&& visit) {
    for (const SceneObject& object : scene.objects) {
      for (const MotionPiece& piece : object.motion.pieces) {
        for (const auto& axis : kept(piece.trajectory, model)) {
          for (std::size_t k = 0; k < axis.size(); ++k) {
            if (!visit(k, axis[k])) return false;
          }
        }
      }
    }
    return true;
  };
  bool narrow = model.degree <= kMaxFixedDegree && !needs.anchored;
  narrow = narrow && each([&model](std::size_t, const Rational& c) {
             if (c.is_integer()) return true;
             const Integer d = c.denominator();
             if (d.bit_length() > kMaxScaleBits) return false;
             model.scale = lcm(model.scale, d);
             return model.scale.bit_length() <= kMaxScaleBits;
           });
  if (narrow) {
    model.magnitude.assign(powers, 0.0);
    const Rational scale(model.scale);
    narrow = each([&model, &scale](std::size_t k, const Rational& c) {
      const Rational scaled = c * scale;
      const double bound =
          std::max(std::fabs(scaled.lower_double()), std::fabs(scaled.upper_double()));
      if (!(bound <= kMaxNarrow)) return false;
      if (k < model.magnitude.size()) model.magnitude[k] = std::max(model.magnitude[k], bound);
      return true;
    });
  }
  model.narrow = narrow;
  model.anchored = needs.anchored;
  if (!narrow) {
    model.scale = Integer(1);
    model.magnitude.clear();
  }
  return model;
}

MotionStore::MotionStore(const NumberModel& model, std::size_t objects)
    : model_(model),
      objects_(objects),
      stride_(static_cast<std::size_t>(model.axes) *
              static_cast<std::size_t>(model.degree + 1)) {
  unit_ball_ = enclose_whole(model_.scale, 0);
  if (model_.scale.bit_length() <= 53) unit_ball_.error = 0;
  unit_ = unit_ball_.value;
  if (model_.narrow) narrow_.assign(objects_ * stride_, 0);
  narrow_object_.assign(objects_, 0);
  if (!model_.narrow) need_balls();
}

void MotionStore::need_balls() {
  if (balls_needed_) return;
  balls_needed_ = true;
  row_.assign(objects_, 0);
  rows_ = 1;
  balls_.assign(stride_, Ball{});
  if (model_.anchored) {
    anchored_.assign(stride_, Ball{});
    anchors_.resize(objects_, std::numeric_limits<double>::infinity());
  }
  for (ObjectId i = 0; i < objects_; ++i) set_ball(i);
}

void MotionStore::make_row(ObjectId object) {
  if (row_[object] != 0) return;
  row_[object] = rows_++;
  balls_.resize(rows_ * stride_);
  if (model_.anchored) anchored_.resize(rows_ * stride_);
}

void MotionStore::set_ball(ObjectId object) {
  if (is_narrow(object)) {
    make_row(object);
    Ball* out = &balls_[row_[object] * stride_];
    const double* in = &narrow_[object * stride_];
    for (std::size_t i = 0; i < stride_; ++i) out[i] = {in[i], 0.0};
    return;
  }
  if (!is_big(object)) {
    const std::size_t row = row_[object] * stride_;
    std::fill_n(&balls_[row], stride_, Ball{});
    if (model_.anchored) std::fill_n(&anchored_[row], stride_, Ball{});
    return;
  }
  // Balls are in the model's units, like the narrow integers, so that they can be mixed.
  const BigMotion& big = big_[object];
  make_row(object);
  Ball* out = &balls_[row_[object] * stride_];
  const bool unit = model_.scale == Integer(1);
  for (std::size_t i = 0; i < stride_; ++i) {
    if (unit && big.whole) {
      out[i] = enclose_whole(big.coefficients[i], 0);
    } else if (unit) {
      out[i] = enclose(big.coefficients[i], big.denominator, 0);
    } else {
      out[i] = enclose(big.coefficients[i] * model_.scale, big.denominator, 0);
    }
  }
  if (model_.anchored) set_anchored(object);
}

void MotionStore::split_anchor(double anchor) {
  if (anchor_.value == anchor) return;
  const Rational exact = exactly(anchor);
  anchor_.value = anchor;
  anchor_.a = exact.numerator();
  anchor_.e = exact.denominator().trailing_zeros();
}

// With anchor = a / 2^e, the polynomial of degree d in u = 2^e t, times 2^(e d), has integer
// coefficients, and so has its shift by a. Requires big integers in units of 1.
void MotionStore::set_anchored(ObjectId object) {
  const BigMotion& big = big_[object];
  const double anchor = anchors_[object];
  const std::size_t row = row_[object] * stride_;
  if (std::isinf(anchor) || anchor == 0) {
    std::copy_n(&balls_[row], stride_, &anchored_[row]);
    return;
  }
  const std::size_t powers = static_cast<std::size_t>(model_.degree) + 1;
  split_anchor(anchor);
  const Integer& a = anchor_.a;
  const unsigned long e = anchor_.e;
  axis_.resize(powers);
  for (std::size_t begin = 0; begin < stride_; begin += powers) {
    std::size_t d = powers - 1;
    while (d > 0 && big.coefficients[begin + d].is_zero()) --d;
    for (std::size_t k = 0; k <= d; ++k) {
      axis_[k] = big.coefficients[begin + k];
      axis_[k] <<= e * (d - k);
    }
    for (std::size_t k = 0; k < d; ++k) {
      for (std::size_t j = d; j > k; --j) axis_[j - 1].add_product(a, axis_[j]);
    }
    for (std::size_t k = 0; k < powers; ++k) {
      Ball& out = anchored_[row + begin + k];
      if (k > d) {
        out = Ball{};
      } else if (big.whole) {
        out = enclose_whole(axis_[k], e * (d - k));
      } else {
        out = enclose(axis_[k], big.denominator, -static_cast<long>(e * (d - k)));
      }
    }
  }
}

std::optional<double> MotionStore::anchor_of(const ObjectId* ids, std::size_t count) const {
  std::optional<double> shared;
  for (std::size_t i = 0; i < count; ++i) {
    const double anchor = anchors_[ids[i]];
    if (std::isinf(anchor)) continue;
    if (shared && *shared != anchor) return std::nullopt;
    shared = anchor;
  }
  return shared;
}

void MotionStore::grow_degree(int degree) {
  const std::size_t old_powers = static_cast<std::size_t>(model_.degree) + 1;
  const std::size_t powers = static_cast<std::size_t>(degree) + 1;
  const std::size_t axes = static_cast<std::size_t>(model_.axes);
  const std::size_t stride = axes * powers;
  const auto spread = [&](const auto& from, auto& to) {
    for (std::size_t a = 0; a < axes; ++a) {
      for (std::size_t k = 0; k < old_powers; ++k) to[a * powers + k] = from[a * old_powers + k];
    }
  };
  // Above the fixed degrees nothing is narrow any more.
  big_.resize(objects_);
  for (ObjectId i = 0; i < objects_; ++i) {
    if (is_narrow(i)) {
      BigMotion big{model_.scale, std::vector<Integer>(stride_), model_.scale == Integer(1)};
      for (std::size_t k = 0; k < stride_; ++k) {
        big.coefficients[k] = Integer(static_cast<std::int64_t>(narrow_[i * stride_ + k]));
      }
      big_[i] = std::move(big);
      narrow_object_[i] = kWide;
      ++wide_;
    }
  }
  for (BigMotion& big : big_) {
    if (big.coefficients.empty()) continue;
    std::vector<Integer> wider(stride);
    spread(big.coefficients, wider);
    big.coefficients = std::move(wider);
  }
  model_.degree = degree;
  model_.narrow = false;
  stride_ = stride;
  narrow_.clear();
  narrow_.shrink_to_fit();
  balls_needed_ = false;
  need_balls();
}

void MotionStore::grow(std::size_t objects) {
  objects_ = objects;
  narrow_object_.resize(objects_, 0);
  if (model_.narrow) narrow_.resize(objects_ * stride_, 0);
  if (balls_needed_) row_.resize(objects_, 0);
  if (model_.anchored) anchors_.resize(objects_, std::numeric_limits<double>::infinity());
}

// The value times the model's scale, if that is an integer of at most 53 bits.
std::optional<double> MotionStore::scaled_integer(const Rational& value) const {
  const mpz_srcptr n = mpq_numref(value.raw()), d = mpq_denref(value.raw());
  const mpz_srcptr scale = model_.scale.raw();
  constexpr long kMost = 1L << 53;
  if (mpz_fits_slong_p(n) == 0 || mpz_fits_slong_p(d) == 0 || mpz_fits_slong_p(scale) == 0) {
    const Rational scaled = value * Rational(model_.scale);
    if (!scaled.is_integer() || !scaled.numerator().fits_int64()) return std::nullopt;
    const std::int64_t whole = scaled.numerator().to_int64();
    if (whole < -kMost || whole > kMost) return std::nullopt;
    return static_cast<double>(whole);
  }
  const long factor = mpz_get_si(scale) / mpz_get_si(d);
  if (factor * mpz_get_si(d) != mpz_get_si(scale)) return std::nullopt;
  const Int128 whole = static_cast<Int128>(mpz_get_si(n)) * factor;
  if (whole < -kMost || whole > kMost) return std::nullopt;
  return static_cast<double>(whole);
}

void MotionStore::set(ObjectId object, const Trajectory& trajectory, double anchor) {
  if (object >= objects_) grow(object + std::size_t{1});
  const int degree = trajectory.degree_of_axes(0, model_.axes);
  if (degree > model_.degree) grow_degree(degree);
  if (model_.anchored) {
    anchors_[object] = degree == 0 ? std::numeric_limits<double>::infinity() : anchor;
    if (degree > 0) {
      if (!first_anchor_) first_anchor_ = anchor;
      anchors_differ_ = anchors_differ_ || *first_anchor_ != anchor;
    }
  }
  const std::size_t powers = static_cast<std::size_t>(model_.degree) + 1;
  const std::span<const std::vector<Rational>> axes = kept(trajectory, model_);
  bool narrow = model_.narrow;
  if (narrow) {
    double* out = &narrow_[object * stride_];
    std::fill(out, out + stride_, 0.0);
    for (std::size_t a = 0; narrow && a < axes.size(); ++a) {
      const std::vector<Rational>& axis = axes[a];
      for (std::size_t k = 0; narrow && k < axis.size(); ++k) {
        if (axis[k].is_zero()) continue;
        const std::optional<double> scaled = scaled_integer(axis[k]);
        narrow = scaled && std::fabs(*scaled) <= model_.magnitude[k];
        if (narrow) out[a * powers + k] = *scaled;
      }
    }
  }
  if (narrow_object_[object] == kWide) --wide_;
  narrow_object_[object] = narrow ? kNarrow : kWide;
  if (!narrow) ++wide_;
  if (narrow || is_zero(axes)) {
    if (is_big(object)) big_[object] = BigMotion{};
  } else {
    set_big(object, axes);
  }
  if (!narrow) need_balls();
  if (balls_needed_) set_ball(object);
}

// Reuses the memory of the object's former motion.
void MotionStore::set_big(ObjectId object, std::span<const std::vector<Rational>> axes) {
  if (big_.size() < objects_) big_.resize(objects_);
  BigMotion& big = big_[object];
  big.coefficients.resize(stride_);
  big.whole = true;
  for (const auto& axis : axes) {
    for (const Rational& c : axis) big.whole = big.whole && c.is_integer();
  }
  big.denominator = Integer(1);
  if (!big.whole) {
    for (const auto& axis : axes) {
      for (const Rational& c : axis) big.denominator = lcm(big.denominator, c.denominator());
    }
  }
  const std::size_t powers = static_cast<std::size_t>(model_.degree) + 1;
  for (std::size_t i = 0; i < stride_; ++i) {
    Integer& out = big.coefficients[i];
    const std::size_t a = i / powers, k = i % powers;
    if (a >= axes.size() || k >= axes[a].size()) {
      mpz_set_ui(out.raw(), 0);
      continue;
    }
    const Rational& c = axes[a][k];
    mpz_set(out.raw(), mpq_numref(c.raw()));
    if (big.whole) continue;
    Integer factor = big.denominator;
    mpz_divexact(factor.raw(), factor.raw(), mpq_denref(c.raw()));
    out *= factor;
  }
}

Polynomial MotionStore::exact(const Predicate& predicate, const ObjectId* ids) const {
  const int arity = predicate.arity();
  Integer common(1);
  for (int i = 0; i < arity; ++i) {
    common = lcm(common, is_big(ids[i]) ? big_[ids[i]].denominator : model_.scale);
  }
  std::vector<Integer> coefficients(static_cast<std::size_t>(arity) * stride_);
  std::array<MotionView<Integer>, kMaxViews> points{};
  points[static_cast<std::size_t>(arity)] = &common;
  for (int i = 0; i < arity; ++i) {
    Integer* out = &coefficients[static_cast<std::size_t>(i) * stride_];
    points[static_cast<std::size_t>(i)] = out;
    const bool is_big = this->is_big(ids[i]);
    Integer factor = common;
    factor.divide_exactly(is_big ? big_[ids[i]].denominator : model_.scale);
    for (std::size_t k = 0; k < stride_; ++k) {
      if (is_big) {
        out[k] = big_[ids[i]].coefficients[k];
      } else if (is_narrow(ids[i])) {
        out[k] = Integer(static_cast<std::int64_t>(narrow_[ids[i] * stride_ + k]));
      }
      out[k] *= factor;
    }
  }
  return predicate.exact(model_.degree, points.data());
}

std::size_t MotionStore::bytes() const {
  std::size_t total = narrow_.capacity() * sizeof(double) + narrow_object_.capacity() +
                      (balls_.capacity() + anchored_.capacity()) * sizeof(Ball) +
                      anchors_.capacity() * sizeof(double) + row_.capacity() * sizeof(row_[0]) +
                      big_.capacity() * sizeof(BigMotion);
  for (const BigMotion& big : big_) total += big.coefficients.capacity() * (sizeof(Integer) + 16);
  return total;
}

}  // namespace kinex
