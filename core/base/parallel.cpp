#include "core/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <vector>

#include "core/base/happens_before.h"
#include "core/base/progress.h"

namespace feedscope {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> errors(count);
  std::atomic<bool> cancelled{false};
  HappensBefore begin;
  HappensBefore end;
  begin.before();
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        begin.after();
        try {
          if (!cancelled.load(std::memory_order_relaxed)) {
            work(i);
          }
        } catch (const Cancelled&) {
          errors[i] = std::current_exception();
          cancelled.store(true, std::memory_order_relaxed);
        } catch (...) {
          errors[i] = std::current_exception();
        }
        end.before();
      },
      tbb::simple_partitioner());
  end.after();
  for (const std::exception_ptr& error : errors) {
    if (error) {
      std::rethrow_exception(error);
    }
  }
}

namespace {

/// Marks at the end of a scope, also after an exception, that all of it happened before the rest.
class DoneBefore {
 public:
  explicit DoneBefore(HappensBefore& place) : place_(place) {}
  DoneBefore(const DoneBefore&) = delete;
  DoneBefore& operator=(const DoneBefore&) = delete;
  ~DoneBefore() { place_.before(); }

 private:
  HappensBefore& place_;
};

}  // namespace

void in_order(std::size_t count, const std::function<std::function<void()>(std::size_t)>& make) {
  std::vector<std::function<void()>> made(count);
  std::size_t next = 0;
  HappensBefore handed_over;
  const auto number = tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                          [&](tbb::flow_control& flow) -> std::size_t {
                                                            if (next == count) {
                                                              flow.stop();
                                                              return 0;
                                                            }
                                                            handed_over.before();
                                                            return next++;
                                                          });
  const auto work = tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel,
                                                               [&](std::size_t i) -> std::size_t {
                                                                 handed_over.after();
                                                                 const DoneBefore done(handed_over);
                                                                 made[i] = make(i);
                                                                 return i;
                                                               });
  const auto take =
      tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, [&](std::size_t i) {
        handed_over.after();
        const DoneBefore done(handed_over);
        made[i]();
        made[i] = nullptr;
      });
  const auto ahead = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
  try {
    // Isolated: a thread that waits here must not start other work of the caller.
    tbb::this_task_arena::isolate([&] { tbb::parallel_pipeline(ahead, number & work & take); });
  } catch (...) {
    handed_over.after();
    throw;
  }
  handed_over.after();
}

void in_parallel(std::initializer_list<std::function<void()>> tasks) {
  in_parallel(tasks.size(), [&](std::size_t i) { tasks.begin()[i](); });
}

}  // namespace feedscope
