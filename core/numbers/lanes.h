// SPDX-License-Identifier: GPL-3.0-or-later
// Lanes: four doubles side by side. One formula is evaluated for four sets of numbers at once.
//
// Every lane holds bit for bit what doubles would give: sums, products, comparisons and choices are
// those of IEEE 754 for each lane. Nothing is contracted: -ffp-contract=off, and the target "avx2"
// has no fused multiplication. So code over Lanes may be compiled for any machine. On the oldest
// ones of the architecture an operation is two instructions of two lanes; with AVX2 it is one.
//
// KINEX_FOR_AVX2 compiles a function for AVX2 and inlines everything that it calls ("flatten"). The
// function may be called only if best_vectors() is kAvx2.
#ifndef KINEX_CORE_NUMBERS_LANES_H
#define KINEX_CORE_NUMBERS_LANES_H

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// Lanes are never passed between functions that are compiled for different machines: all functions
// on them are inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#if defined(__x86_64__)
#define KINEX_FOR_AVX2 __attribute__((flatten, target("avx2")))
#else
#define KINEX_FOR_AVX2 __attribute__((flatten))
#endif

namespace kinex {

inline constexpr std::size_t kLanes = 4;  // numbers side by side

// The vector instructions that a function is compiled for.
enum class Vectors : std::uint8_t { kBase, kAvx2 };
// The best instructions that this machine has.
Vectors best_vectors();

// A lane is all ones if it is chosen, and zero otherwise.
struct LaneMask {
  typedef std::int64_t Vector __attribute__((vector_size(32)));
  Vector v;
  bool operator[](std::size_t lane) const { return v[lane] != 0; }
  [[gnu::always_inline]] friend LaneMask operator&(const LaneMask& a, const LaneMask& b) {
    return {a.v & b.v};
  }
  [[gnu::always_inline]] friend LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return {a.v | b.v};
  }
  [[gnu::always_inline]] friend LaneMask operator~(const LaneMask& a) { return {~a.v}; }
};

struct Lanes {
  typedef double Vector __attribute__((vector_size(32)));
  Vector v;

  Lanes() = default;
  [[gnu::always_inline]] explicit Lanes(const Vector& lanes) : v(lanes) {}
  // The same number in every lane.
  [[gnu::always_inline]] Lanes(double x) : v{x, x, x, x} {}  // NOLINT: numbers of the ring
  [[gnu::always_inline]] Lanes(double a, double b, double c, double d) : v{a, b, c, d} {}
  double operator[](std::size_t lane) const { return v[lane]; }

  [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes(a.v + b.v);
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes(a.v - b.v);
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return Lanes(-a.v); }
  [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes(a.v * b.v);
  }
  [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return Lanes(a.v / b.v);
  }
  [[gnu::always_inline]] Lanes& operator+=(const Lanes& b) {
    v += b.v;
    return *this;
  }
  [[gnu::always_inline]] Lanes& operator*=(const Lanes& b) {
    v *= b.v;
    return *this;
  }
  [[gnu::always_inline]] friend LaneMask operator>(const Lanes& a, const Lanes& b) {
    return {(LaneMask::Vector)(a.v > b.v)};
  }
  [[gnu::always_inline]] friend LaneMask operator<(const Lanes& a, const Lanes& b) {
    return {(LaneMask::Vector)(a.v < b.v)};
  }
  [[gnu::always_inline]] friend LaneMask operator==(const Lanes& a, const Lanes& b) {
    return {(LaneMask::Vector)(a.v == b.v)};
  }
  [[gnu::always_inline]] friend LaneMask operator>=(const Lanes& a, const Lanes& b) {
    return {(LaneMask::Vector)(a.v >= b.v)};
  }
  [[gnu::always_inline]] friend LaneMask operator<=(const Lanes& a, const Lanes& b) {
    return {(LaneMask::Vector)(a.v <= b.v)};
  }
};

// |a|, exactly.
[[gnu::always_inline]] inline Lanes magnitude_of(const Lanes& a) {
  constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;
  const LaneMask::Vector keep{kAllButSign, kAllButSign, kAllButSign, kAllButSign};
  return Lanes((Lanes::Vector)((LaneMask::Vector)a.v & keep));
}
inline double magnitude_of(double a) { return __builtin_fabs(a); }

// b if it is larger than a, else a (also if one of them is NaN).
[[gnu::always_inline]] inline Lanes larger(const Lanes& a, const Lanes& b) {
  return Lanes(b.v > a.v ? b.v : a.v);
}
inline double larger(double a, double b) { return b > a ? b : a; }

// a where `mask` is chosen, else b.
[[gnu::always_inline]] inline Lanes choose(const LaneMask& mask, const Lanes& a, const Lanes& b) {
  return Lanes(mask.v ? a.v : b.v);
}

// Bit j: lane j is chosen.
[[gnu::always_inline]] inline std::uint32_t bits_of(const LaneMask& mask) {
#if defined(__SSE2__)
  const auto low = _mm_movemask_pd((__m128d)__builtin_shufflevector(mask.v, mask.v, 0, 1));
  const auto high = _mm_movemask_pd((__m128d)__builtin_shufflevector(mask.v, mask.v, 2, 3));
  return static_cast<std::uint32_t>(low | high << 2);
#else
  return (mask[0] ? 1u : 0u) | (mask[1] ? 2u : 0u) | (mask[2] ? 4u : 0u) | (mask[3] ? 8u : 0u);
#endif
}
// The lanes of such bits.
[[gnu::always_inline]] inline LaneMask mask_of(std::uint32_t bits) {
  const auto all = static_cast<std::int64_t>(bits);
  const LaneMask::Vector place{1, 2, 4, 8};
  return {(LaneMask::Vector)((LaneMask::Vector{all, all, all, all} & place) == place)};
}
// Of every lane, rounded to nearest.
[[gnu::always_inline]] inline Lanes square_root_of(const Lanes& a) {
#if defined(__SSE2__)
  typedef double Half __attribute__((vector_size(16)));
  const auto low = (Half)_mm_sqrt_pd((__m128d)__builtin_shufflevector(a.v, a.v, 0, 1));
  const auto high = (Half)_mm_sqrt_pd((__m128d)__builtin_shufflevector(a.v, a.v, 2, 3));
  return Lanes(__builtin_shufflevector(low, high, 0, 1, 2, 3));
#else
  return Lanes(__builtin_sqrt(a.v[0]), __builtin_sqrt(a.v[1]), __builtin_sqrt(a.v[2]),
               __builtin_sqrt(a.v[3]));
#endif
}

// Transposes four rows of four numbers: out[k][j] = rows[j][k].
[[gnu::always_inline]] inline void transpose(const Lanes::Vector* rows, Lanes* out) {
  const Lanes::Vector ab02 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
  const Lanes::Vector ab13 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
  const Lanes::Vector cd02 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
  const Lanes::Vector cd13 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  out[0] = Lanes(__builtin_shufflevector(ab02, cd02, 0, 1, 4, 5));
  out[1] = Lanes(__builtin_shufflevector(ab13, cd13, 0, 1, 4, 5));
  out[2] = Lanes(__builtin_shufflevector(ab02, cd02, 2, 3, 6, 7));
  out[3] = Lanes(__builtin_shufflevector(ab13, cd13, 2, 3, 6, 7));
}

// The same of rows in memory: out[k] = (a[k], b[k], c[k], d[k]). No alignment is needed.
[[gnu::always_inline]] inline void transpose(const double* a, const double* b, const double* c,
                                             const double* d, Lanes* out) {
  Lanes::Vector rows[kLanes];
  __builtin_memcpy(&rows[0], a, sizeof(Lanes));
  __builtin_memcpy(&rows[1], b, sizeof(Lanes));
  __builtin_memcpy(&rows[2], c, sizeof(Lanes));
  __builtin_memcpy(&rows[3], d, sizeof(Lanes));
  transpose(rows, out);
}

}  // namespace kinex

#endif
