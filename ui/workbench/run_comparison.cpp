#include "ui/workbench/run_comparison.h"

#include <algorithm>
#include <stdexcept>

#include "ui/scene/path/compare_sampled.h"

namespace feedscope::ui {
namespace {

using Samples = std::shared_ptr<const SampledPath>;

}  // namespace

std::optional<std::size_t> reference_row(std::size_t count, std::size_t row,
                                         std::optional<std::size_t> chosen,
                                         std::optional<std::size_t> beside) {
  for (const auto& wanted : {chosen, beside}) {
    if (wanted && *wanted < count && *wanted != row) {
      return wanted;
    }
  }
  return count < 2 ? std::nullopt : std::optional<std::size_t>(row == 0 ? 1 : 0);
}

RunComparison::RunComparison(const RunList& runs, QObject* parent) : QObject(parent), runs_(runs) {
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&runs_, signal, this, &RunComparison::forget_gone_results);
  }
  connect(&runs_, &RunList::result_changed, this, &RunComparison::forget_gone_results);
}

void RunComparison::choose(int id) {
  if (id != chosen_) {
    chosen_ = id;
    emit reference_changed();
  }
}

int RunComparison::chosen() const {
  return runs_.row_of(chosen_) < runs_.items().size() ? chosen_ : 0;
}

void RunComparison::set_beside(int id) {
  if (id != beside_) {
    beside_ = id;
    emit reference_changed();
  }
}

std::optional<std::size_t> RunComparison::reference_of(std::size_t row) const {
  const std::size_t beside = runs_.row_of(beside_);
  return reference_row(runs_.items().size(), row, runs_.row_of(chosen_),
                       row == beside ? runs_.current() : beside);
}

Samples RunComparison::samples(std::size_t row) {
  const auto reference = reference_of(row);
  const auto run = runs_.result(row);
  const auto other = reference ? runs_.result(*reference) : nullptr;
  if (run == nullptr || other == nullptr) {
    return nullptr;
  }
  const auto found = std::ranges::find_if(
      pairs_, [&](const auto& pair) { return pair->run == run && pair->reference == other; });
  if (found != pairs_.end()) {
    return (*found)->samples;
  }
  constexpr std::size_t kept = 4;  // two views and their previous contents
  if (pairs_.size() == kept) {
    pairs_.erase(pairs_.begin());
  }
  pairs_.push_back(std::make_unique<Pair>());
  pairs_.back()->run = run;
  pairs_.back()->reference = other;
  start(*pairs_.back());
  return nullptr;
}

void RunComparison::start(Pair& pair) {
  connect(&pair.job, &JobBase::progressed, this, &RunComparison::progressed);
  pair.job.start(
      [run = pair.run->run.trajectory, sources = pair.run->run.sources,
       reference = pair.reference->run.trajectory, sampled = pair.run->samples,
       drawn = pair.reference->samples](JobControl& control) -> Samples {
        try {
          return std::make_shared<const SampledPath>(
              compare_sampled(*sampled, run, *reference, drawn->times, &control.progress, sources));
        } catch (const std::invalid_argument&) {
          return nullptr;  // one of them does not move
        }
      },
      [this, &pair](const JobOutcome<Samples>& outcome) {
        pair.samples = outcome.result.value_or(nullptr);  // none: the path remains uncoloured
        emit progressed();
        emit ready();
      });
}

bool RunComparison::busy() const {
  return std::ranges::any_of(pairs_, [](const auto& pair) { return pair->job.busy(); });
}

double RunComparison::progress() const {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& pair : pairs_) {
    if (pair->job.busy()) {
      sum += pair->job.fraction();
      ++count;
    }
  }
  return count == 0 ? 1 : sum / static_cast<double>(count);
}

void RunComparison::cancel() {
  if (!busy()) {
    return;
  }
  std::erase_if(pairs_, [](const auto& pair) { return pair->job.busy(); });
  emit progressed();
  emit cancelled();
}

void RunComparison::forget_gone_results() {
  const auto gone = [&](const std::shared_ptr<const ShownRun>& result) {
    for (std::size_t row = 0; row < runs_.items().size(); ++row) {
      if (runs_.result(row) == result) {
        return false;
      }
    }
    return true;
  };
  std::erase_if(pairs_, [&](const auto& pair) { return gone(pair->run) || gone(pair->reference); });
  emit progressed();
}

}  // namespace feedscope::ui
