#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/contract/contract.h"

namespace feedscope::contract {
namespace {

struct Options {
  std::uint64_t programs = 10000;
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::string model;
  std::string out = "contract-findings";
  std::size_t max_reports = 3;  ///< of one promise of one model
};

/// A long run: numbered programs taken one by one by all threads.
class LongRun {
 public:
  explicit LongRun(const Options& options) : options_(options), next_(options.first) {
    for (const ControlModel* model : all_models()) {
      if (options.model.empty() || model->info().id == find_model(options.model).info().id) {
        models_.push_back(model->info().id);
      }
    }
  }

  /// Number of programs that break a promise.
  std::uint64_t run() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < options_.threads; ++i) {
      threads.emplace_back([this] { work(); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    fmt::print("{} programs, {} break a promise\n", options_.programs, broken_.load());
    for (const auto& [promise, count] : counts_) {
      fmt::print("  {:6}  {}\n", count, promise);
    }
    return broken_;
  }

 private:
  void work() {
    for (;;) {
      const std::uint64_t number = next_++;
      if (number >= options_.first + options_.programs) {
        return;
      }
      const Case example = random_case(models_[number % models_.size()], options_.seed, number);
      const std::vector<Finding> findings = check_case(example);
      broken_ += findings.empty() ? 0 : 1;
      for (const Finding& finding : findings) {
        note(example, finding, number);
      }
      const std::uint64_t done = number - options_.first + 1;
      constexpr std::uint64_t every = 1000;
      if (done % every == 0) {
        fmt::print(stderr, "\r{} of {}, {} broken ", done, options_.programs, broken_.load());
      }
    }
  }

  void note(const Case& example, const Finding& finding, std::uint64_t number) {
    {
      const std::lock_guard lock(mutex_);
      if (++counts_[example.model + " " + finding.check] > options_.max_reports) {
        return;
      }
    }
    const Case small = smallest(example, finding.check);
    const Result again = finding_of(check_case(small), finding.check);
    const std::string name = fmt::format("{}-{}-{}", example.model, finding.check, number);
    const std::lock_guard lock(mutex_);
    fmt::print("\n{}", report(small, again.value_or(finding), options_.out, name));
    std::fflush(stdout);
  }

  Options options_;
  std::vector<std::string> models_;
  std::atomic<std::uint64_t> next_;
  std::mutex mutex_;
  std::atomic<std::uint64_t> broken_ = 0;
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace
}  // namespace feedscope::contract

int main(int argc, char** argv) {
  feedscope::contract::Options options;
  CLI::App app{"Check what control models promise on many random programs"};
  app.add_option("--programs", options.programs, "How many programs, one model each in turn");
  app.add_option("--first", options.first, "Number of the first program");
  app.add_option("--seed", options.seed, "Another seed makes other programs");
  app.add_option("--threads", options.threads, "How many at a time")->check(CLI::PositiveNumber);
  app.add_option("--model", options.model, "Only this model");
  app.add_option("--out", options.out, "Folder for programs and machine files that break a promise");
  app.add_option("--reports", options.max_reports, "How many broken programs of each promise to write");
  CLI11_PARSE(app, argc, argv);
  return feedscope::contract::LongRun(options).run() == 0 ? 0 : 1;
}
