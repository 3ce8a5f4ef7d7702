#pragma once

namespace bslnav::test {

/** What the calling thread has taken from the heap so far; linking this replaces operator new and
 * delete. */
struct HeapUse {
  long allocations = 0;  ///< ever
  long blocks = 0;       ///< not given back
  long bytes = 0;        ///< of those blocks
};
HeapUse heapUse();

}  // namespace bslnav::test
