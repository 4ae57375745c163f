// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers/big_array.h"

#include <sys/mman.h>

#include <cstdlib>

namespace kinex::huge_pages {

void* allocate(std::size_t bytes) {
  const std::size_t size = (bytes + kPage - 1) / kPage * kPage;
  void* const memory = std::aligned_alloc(kPage, size);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  ::madvise(memory, size, MADV_HUGEPAGE);  // a wish: whether it is granted does not matter
#endif
  return memory;
}

void release(void* memory) noexcept { std::free(memory); }

}  // namespace kinex::huge_pages
