#include "core/base/parallel.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <vector>

#include "core/base/happens_before.h"

namespace feedscope {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> errors(count);
  HappensBefore begin;
  HappensBefore end;
  begin.before();
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        begin.after();
        try {
          work(i);
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

void in_parallel(std::initializer_list<std::function<void()>> tasks) {
  in_parallel(tasks.size(), [&](std::size_t i) { tasks.begin()[i](); });
}

}  // namespace feedscope
