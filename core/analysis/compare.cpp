#include "core/analysis/compare.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace feedscope {
namespace {

/// Works on several runs at once; the thread that calls watches over them.
class Comparison {
 public:
  Comparison(const LoadedProgram& program, const std::vector<Setup>& setups)
      : program_(program), setups_(setups), jobs_(setups.size()) {}

  std::vector<ComparedRun> run(Progress* progress) {
    std::vector<std::jthread> workers;
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < std::min(processors, jobs_.size()); ++i) {
      workers.emplace_back([this] { work(); });
    }
    try {
      watch(progress);
    } catch (...) {
      for (Job& job : jobs_) {
        job.progress.cancel();
      }
      throw;
    }
    return results();
  }

 private:
  struct Job {
    Progress progress;
    ComparedRun result;
    std::exception_ptr error;
  };

  void work() {
    for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
      Job& job = jobs_[i];
      try {
        job.progress.report(0);
        const Run run = simulate_run(program_, setups_[i], &job.progress);
        job.result = {run.setup, run.summary, run.trajectory->path_length(), run.trajectory->blends().size(),
                      run.simulate_time};
        job.progress.report(1);
      } catch (...) {
        job.error = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      ++done_;
      changed_.notify_one();
    }
  }

  void watch(Progress* progress) {
    constexpr auto glance = std::chrono::milliseconds(50);
    if (progress != nullptr) {
      progress->report(0);
    }
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, glance, [this] { return done_ == jobs_.size(); })) {
      if (progress != nullptr) {
        double sum = 0;
        for (const Job& job : jobs_) {
          sum += job.progress.fraction();
        }
        progress->report(sum / static_cast<double>(jobs_.size()));
      }
    }
  }

  std::vector<ComparedRun> results() {
    std::vector<ComparedRun> runs;
    for (Job& job : jobs_) {
      if (job.error) {
        std::rethrow_exception(job.error);
      }
      runs.push_back(std::move(job.result));
    }
    return runs;
  }

  const LoadedProgram& program_;
  const std::vector<Setup>& setups_;
  std::vector<Job> jobs_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t done_ = 0;  ///< guarded by mutex_
};

}  // namespace

std::vector<Setup> setups_to_compare(const std::vector<std::string>& machines,
                                     const std::vector<std::string>& models,
                                     const std::vector<double>& tolerances) {
  std::vector<std::string> model_ids = models;
  if (model_ids.empty()) {
    for (const ControlModel* model : all_models()) {
      model_ids.push_back(model->info().id);
    }
  }
  std::vector<Setup> setups;
  for (const std::string& machine : machines.empty() ? std::vector<std::string>{""} : machines) {
    for (const std::string& model : model_ids) {
      const auto add = [&](std::optional<double> tolerance) -> const Setup& {
        return setups.emplace_back(make_setup({machine, model, tolerance, {}}));
      };
      if (tolerances.empty()) {
        add(std::nullopt);
      }
      for (const double tolerance : tolerances) {
        if (!add(tolerance).settings.has("contour_tolerance_mm")) {
          break;
        }
      }
    }
  }
  return setups;
}

std::vector<ComparedRun> compare_runs(const LoadedProgram& program, const std::vector<Setup>& setups,
                                      Progress* progress) {
  return Comparison(program, setups).run(progress);
}

}  // namespace feedscope
