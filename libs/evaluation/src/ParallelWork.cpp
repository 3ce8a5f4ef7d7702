#include <bslnav/evaluation/ParallelWork.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace bslnav {

std::size_t doInParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                         const WorkWatch& watch) {
  using tbb::filter_mode;
  std::size_t begun = 0, done = 0;
  const auto begin = [&](tbb::flow_control& control) {
    if (begun < count && (!watch.goOn || watch.goOn())) return begun++;
    control.stop();
    return begun;
  };
  const auto run = [&work](std::size_t i) {
    work(i);
    return i;
  };
  const auto end = [&](std::size_t) {
    ++done;
    if (watch.progress) watch.progress(done, count);
  };
  tbb::task_arena arena(jobs > 0 ? jobs : tbb::task_arena::automatic);
  // What is finished early waits for its turn; with some more pieces than threads nobody waits.
  const std::size_t inFlight = 4 * static_cast<std::size_t>(arena.max_concurrency());
  arena.execute([&] {
    tbb::parallel_pipeline(
        inFlight, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin) &
                      tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, run) &
                      tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, end));
  });
  return done;
}

}  // namespace bslnav
