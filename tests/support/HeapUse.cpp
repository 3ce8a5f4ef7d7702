#include "HeapUse.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

thread_local bslnav::test::HeapUse use;

void* take(std::size_t size) noexcept {
  void* const memory = std::malloc(size ? size : 1);
  ++use.allocations;
  ++use.blocks;
  use.bytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}

void giveBack(void* memory) noexcept {
  if (memory) --use.blocks;
  use.bytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

// Not inlined, or GCC takes malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* const memory = take(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return take(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { giveBack(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { giveBack(memory); }
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
  giveBack(memory);
}

namespace bslnav::test {

HeapUse heapUse() { return use; }

}  // namespace bslnav::test
