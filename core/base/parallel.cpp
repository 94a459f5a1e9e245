#include "core/base/parallel.h"

#include <tbb/parallel_for.h>

#include <exception>
#include <vector>

namespace feedscope {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> errors(count);
  tbb::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t i) {
        try {
          work(i);
        } catch (...) {
          errors[i] = std::current_exception();
        }
      },
      tbb::simple_partitioner());
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
