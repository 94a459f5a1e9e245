#include "ui/workbench/trace_list.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/analysis/agreement/feed_share.h"
#include "core/analysis/agreement/held_stretches.h"
#include "core/analysis/agreement/servo_period.h"
#include "core/base/error.h"
#include "core/trace/read_trace.h"
#include "ui/language/in_language.h"
#include "ui/shared/paths.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

/// Colours that runs use last.
constexpr std::array<std::size_t, 4> colour_numbers{5, 7, 6, 4};

/// Whether the rate does not depend on the machine.
bool has_rate_of_its_own(const Trace& trace) {
  return trace.clock == TraceClock::times || trace.clock == TraceClock::option;
}

std::shared_ptr<const Trace> read(const std::filesystem::path& file, const std::string& columns,
                                  double machine_period, Progress* progress) {
  TraceColumns asked = columns.empty() ? TraceColumns() : parse_trace_columns(columns);
  asked.machine_period = machine_period;
  return std::make_shared<const Trace>(read_trace(file, asked, progress));
}

}  // namespace

QColor trace_colour(std::size_t number) {
  return run_colour(colour_numbers[number % colour_numbers.size()]);
}

std::shared_ptr<const ShownTrace> lay_beside(std::shared_ptr<const Trace> trace,
                                             std::shared_ptr<const ShownRun> run, Progress* progress) {
  constexpr double step = 1e-3;  // [s]
  auto shown = std::make_shared<ShownTrace>();
  const Run& simulated = run->run;
  const SeenAxes seen{trace->has(0), trace->has(1), trace->has(2)};
  const ProgrammedCourse course(*simulated.path, seen);
  shown->found = find_on_program(*trace, course, deviation_of(*simulated.trajectory, course, step, progress),
                                 simulated.input.program->source.get(), progress);
  shown->agreement = agreement_of(shown->found, course, simulated, progress);
  add_held_remarks(shown->found, course, shown->agreement.simulated);
  add_feed_remark(shown->found, shown->agreement, course, *simulated.path);
  shown->motion = TraceMotion(shown->found.record, seen, shown->found.noise, trace->period,
                              RecordedErrors(*trace, shown->found.pose), progress);
  shown->alignment = TraceAlignment(shown->found, shown->agreement);
  shown->samples = std::make_shared<const SampledPath>(
      sample_recorded(shown->found, course, *simulated.path, default_max_points, progress));
  shown->trace = std::move(trace);
  shown->run = std::move(run);
  return shown;
}

TraceList::TraceList(QObject* parent) : QObject(parent) {
  connect(&job_, &JobBase::progressed, this, [this] { emit progressed(); });
}

void TraceList::add(const std::filesystem::path& file, const std::string& columns) {
  if (!columns.empty()) {
    parse_trace_columns(columns);
  }
  items_.push_back({next_id_++, file, columns, to_qstring(file.filename()), free_colour(), true});
  emit list_changed();
  work_on();
}

void TraceList::remove(std::size_t row) {
  const int id = items_[row].id;
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(row));
  states_.erase(id);
  if (under_way_ == id) {
    job_.cancel();
  }
  emit list_changed();
}

void TraceList::replace(std::vector<TraceItem> items) {
  clear();
  if (items.empty()) {
    return;
  }
  items_ = std::move(items);
  for (TraceItem& item : items_) {
    item.id = next_id_++;
  }
  emit list_changed();
  work_on();
}

void TraceList::clear() {
  if (items_.empty()) {
    return;
  }
  items_.clear();
  states_.clear();
  job_.cancel();
  emit list_changed();
}

void TraceList::rename(std::size_t row, const QString& name) {
  items_[row].name = name.trimmed().isEmpty() ? to_qstring(items_[row].file.filename()) : name.trimmed();
  emit changed(row);
}

void TraceList::set_colour(std::size_t row, const QColor& colour) {
  items_[row].colour = colour;
  emit changed(row);
}

void TraceList::set_visible(std::size_t row, bool visible) {
  items_[row].visible = visible;
  emit changed(row);
}

void TraceList::set_columns(std::size_t row, const std::string& columns) {
  if (!columns.empty()) {
    parse_trace_columns(columns);
  }
  items_[row].columns = columns;
  states_.erase(items_[row].id);
  if (under_way_ == items_[row].id) {
    job_.cancel();
  }
  emit changed(row);
  work_on();
}

void TraceList::set_run(std::shared_ptr<const ShownRun> run) {
  if (run == run_) {
    return;
  }
  run_ = std::move(run);
  for (auto& [id, state] : states_) {
    state.shown = nullptr;
    state.given_up = false;
    state.failure.clear();
  }
  const auto worked_on = states_.find(under_way_);
  if (worked_on != states_.end() && worked_on->second.trace != nullptr) {
    job_.cancel();  // it compares with the previous run
  }
  for (std::size_t row = 0; row < items_.size(); ++row) {
    emit changed(row);
  }
  work_on();
}

std::shared_ptr<const ShownTrace> TraceList::result(std::size_t row) const {
  const auto found = states_.find(items_[row].id);
  return found == states_.end() ? nullptr : found->second.shown;
}

std::shared_ptr<const Trace> TraceList::trace(std::size_t row) const {
  const auto found = states_.find(items_[row].id);
  return found == states_.end() ? nullptr : found->second.trace;
}

TraceStatus TraceList::status(std::size_t row) const {
  const auto found = states_.find(items_[row].id);
  if (found == states_.end()) {
    return TraceStatus::waiting;
  }
  const State& state = found->second;
  return state.shown != nullptr     ? TraceStatus::compared
         : !state.failure.isEmpty() ? TraceStatus::failed
         : state.given_up           ? TraceStatus::cancelled
                                    : TraceStatus::waiting;
}

QString TraceList::failure(std::size_t row) const {
  const auto found = states_.find(items_[row].id);
  return found == states_.end() ? QString() : found->second.failure;
}

void TraceList::cancel() {
  if (!busy()) {
    return;
  }
  job_.cancel();
  for (std::size_t row = 0; row < items_.size(); ++row) {
    if (status(row) == TraceStatus::waiting) {
      states_[items_[row].id].given_up = true;
      emit changed(row);
    }
  }
}

void TraceList::resume(std::size_t row) {
  State& state = states_[items_[row].id];
  state.given_up = false;
  state.failure.clear();
  emit changed(row);
  work_on();
}

std::size_t TraceList::row_of(int id) const {
  return static_cast<std::size_t>(std::ranges::find(items_, id, &TraceItem::id) - items_.begin());
}

QColor TraceList::free_colour() const {
  const auto used = [this](const QColor& colour) {
    return std::ranges::count(items_, colour, &TraceItem::colour);
  };
  return run_colour(*std::ranges::min_element(colour_numbers, {},
                                              [&](std::size_t number) { return used(run_colour(number)); }));
}

/// Reads traces even without a run, so that errors in their files are reported.
void TraceList::work_on() {
  if (job_.busy()) {
    return;
  }
  for (std::size_t row = 0; row < items_.size(); ++row) {
    const auto known = trace(row);
    if (status(row) != TraceStatus::waiting || (known != nullptr && run_ == nullptr)) {
      continue;
    }
    const TraceItem& item = items_[row];
    under_way_ = item.id;
    const std::string columns = item.columns;
    const double period = run_ == nullptr ? 0 : servo_period_of(run_->run.setup);
    const bool is_current =
        known != nullptr && (has_rate_of_its_own(*known) || states_[item.id].machine_period == period);
    job_.start(
        [file = item.file, columns, known = is_current ? known : nullptr, period,
         run = run_](JobControl& control) -> Result {
          Result result;
          result.machine_period = period;
          result.trace = known != nullptr ? known : read(file, columns, period, &control.progress);
          if (run != nullptr) {
            try {
              result.shown = lay_beside(result.trace, run, &control.progress);
            } catch (const InputError& error) {
              result.failure = failure_text(error);  // although it has been read
            }
          }
          return result;
        },
        [this, id = item.id, columns, run = run_](const JobOutcome<Result>& outcome) {
          JobOutcome<Result> became = outcome;
          const std::size_t at = row_of(id);
          if (at < items_.size() && items_[at].columns != columns) {
            became = {};  // read with other columns meanwhile
          } else if (run != run_ && became.result) {
            became.result->shown = nullptr;
            became.result->failure.clear();
          }
          take(id, became);
        });
    emit progressed();
    return;
  }
}

void TraceList::take(int id, const JobOutcome<Result>& outcome) {
  under_way_ = 0;
  const std::size_t row = row_of(id);
  if (row < items_.size() && !outcome.cancelled()) {
    State& state = states_[id];
    const bool was_compared = state.was_compared;
    const QString told = state.told;
    state = outcome.result.value_or(State{nullptr, nullptr, false, outcome.failure});
    state.was_compared = was_compared || state.shown != nullptr;
    state.told = state.failure;
    const bool first = !was_compared && state.was_compared;
    emit changed(row);
    if (first) {
      emit compared_first(row);
    }
    if (!state.failure.isEmpty() && state.failure != told) {  // each run is compared with it again
      emit failed(items_[row].name + QStringLiteral(": ") + state.failure);
    }
  }
  work_on();
  emit progressed();
}

}  // namespace feedscope::ui
