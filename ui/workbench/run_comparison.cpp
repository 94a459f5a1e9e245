#include "ui/models/run_comparison.h"

#include <QtConcurrentRun>
#include <algorithm>
#include <new>

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
  poll_.setInterval(std::chrono::milliseconds(50));
  connect(&poll_, &QTimer::timeout, this, &RunComparison::watch);
}

RunComparison::~RunComparison() {
  for (const auto& pair : pairs_) {
    stop(*pair);
  }
}

/// What is under way holds all that it reads, and is not waited for.
void RunComparison::stop(Pair& pair) {
  pair.watcher->disconnect(this);
  pair.progress->cancel();
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
  constexpr std::size_t kept = 4;  // two views and what they showed before
  if (pairs_.size() == kept) {
    stop(*pairs_.front());
    pairs_.erase(pairs_.begin());
  }
  pairs_.push_back(std::make_unique<Pair>());
  pairs_.back()->run = run;
  pairs_.back()->reference = other;
  pairs_.back()->progress = std::make_shared<Progress>();
  start(*pairs_.back());
  return nullptr;
}

void RunComparison::start(Pair& pair) {
  pair.watcher = std::make_unique<QFutureWatcher<Samples>>();
  connect(pair.watcher.get(), &QFutureWatcher<Samples>::finished, this, [this, &pair] {
    pair.samples = pair.watcher->result();
    pair.done = true;
    watch();
    emit ready();
  });
  poll_.start();
  pair.watcher->setFuture(
      QtConcurrent::run([run = pair.run->run.trajectory, reference = pair.reference->run.trajectory,
                         drawn = pair.reference->samples, progress = pair.progress]() -> Samples {
        try {
          return std::make_shared<const SampledPath>(
              sample_compared(*run, *reference, drawn->times, progress.get()));
        } catch (const Cancelled&) {
          return nullptr;
        } catch (const std::bad_alloc&) {
          return nullptr;  // the path stays uncoloured
        } catch (const std::invalid_argument&) {
          return nullptr;  // one of them does not move
        }
      }));
}

bool RunComparison::busy() const {
  return std::ranges::any_of(pairs_, [](const auto& pair) { return !pair->done; });
}

double RunComparison::progress() const {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& pair : pairs_) {
    sum += pair->done ? 0 : pair->progress->fraction();
    count += pair->done ? 0 : 1;
  }
  return count == 0 ? 1 : sum / static_cast<double>(count);
}

void RunComparison::cancel() {
  if (!busy()) {
    return;
  }
  std::erase_if(pairs_, [&](const auto& pair) {
    if (!pair->done) {
      stop(*pair);
    }
    return !pair->done;
  });
  watch();
  emit cancelled();
}

void RunComparison::watch() {
  if (!busy()) {
    poll_.stop();
  }
  emit progressed();
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
  std::erase_if(pairs_, [&](const auto& pair) {
    const bool remove = gone(pair->run) || gone(pair->reference);
    if (remove) {
      stop(*pair);
    }
    return remove;
  });
  watch();
}

}  // namespace feedscope::ui
