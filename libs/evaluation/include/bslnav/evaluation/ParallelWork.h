#pragma once

#include <cstddef>
#include <functional>

namespace bslnav {

/** How work in many pieces is watched; both functions may be empty. Neither is ever called from two
 * threads at once. */
struct WorkWatch {
  std::function<bool()> goOn;  ///< asked before each piece begins; false: no more pieces begin
  std::function<void(std::size_t done, std::size_t total)>
      progress;  ///< after each piece, in order
};

/** Does work(0) to work(count - 1), each once, on several threads, and begins them in this order.
 *
 * When it is stopped, the pieces that were begun are finished.
 *  @param jobs threads; 0 for one a core
 *  @returns how many pieces were done: always the first ones. What a piece throws comes out of here
 */
std::size_t doInParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                         const WorkWatch& watch = {});

}  // namespace bslnav
