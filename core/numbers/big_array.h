// SPDX-License-Identifier: GPL-3.0-or-later
// BigArray: a vector whose memory lies in huge pages once it is large.
//
// A run visits certificates, motions and triangles in an order unrelated to their addresses. With
// pages of 4 KiB nearly every visit of a large array then misses the translation lookaside buffer.
// Large arrays therefore request pages of 2 MiB from the operating system; if it grants none, they
// lie in ordinary pages. Small arrays come from the ordinary allocator.
#ifndef KINEX_CORE_NUMBERS_BIG_ARRAY_H
#define KINEX_CORE_NUMBERS_BIG_ARRAY_H

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace kinex {

namespace huge_pages {

inline constexpr std::size_t kPage = std::size_t{1} << 21;  // the bytes of a huge page
// Arrays of fewer bytes come from the ordinary allocator.
inline constexpr std::size_t kLeast = 2 * kPage;

// Whole pages for at least `bytes`. Throws std::bad_alloc.
void* allocate(std::size_t bytes);
void release(void* memory) noexcept;  // gives back what allocate() gave

}  // namespace huge_pages

template <class T>  // large arrays in huge pages
class HugePageAllocator {
 public:
  using value_type = T;

  HugePageAllocator() = default;
  template <class Other>
  HugePageAllocator(const HugePageAllocator<Other>&) {}

  T* allocate(std::size_t count) {
    if (!is_large(count)) return std::allocator<T>().allocate(count);
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(huge_pages::allocate(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    if (!is_large(count)) return std::allocator<T>().deallocate(memory, count);
    huge_pages::release(memory);
  }
  friend bool operator==(HugePageAllocator, HugePageAllocator) { return true; }

 private:
  static bool is_large(std::size_t count) { return count >= huge_pages::kLeast / sizeof(T); }
};

template <class T>  // a vector in huge pages once it is large
using BigArray = std::vector<T, HugePageAllocator<T>>;

}  // namespace kinex

#endif
