#include "ui/circular/circular_job.h"

#include <utility>

namespace feedscope::ui {

void CircularJob::test(std::vector<CircularRequest> requests, Setup setup, Deliver deliver) {
  start(
      [requests = std::move(requests), setup = std::move(setup)](JobControl& control) {
        CircularResult result;
        for (const CircularRequest& request : requests) {
          Progress part(control.progress, 1 / static_cast<double>(requests.size()));
          result.tests.push_back(run_circular_test(request, setup, &part));
        }
        return result;
      },
      std::move(deliver));
}

void CircularJob::evaluate(std::shared_ptr<const ShownRun> run, Deliver deliver) {
  start(
      [run = std::move(run)](JobControl& control) {
        CircularResult result;
        result.circles = program_circles(run->run, &control.progress);
        result.tests = std::exchange(result.circles->tests, {});
        return result;
      },
      std::move(deliver));
}

}  // namespace feedscope::ui
