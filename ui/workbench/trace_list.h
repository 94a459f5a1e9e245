#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "core/analysis/agreement/trace_alignment.h"
#include "core/analysis/agreement/trace_motion.h"
#include "ui/shared/job.h"
#include "ui/workbench/shown_run.h"
#include "ui/workbench/trace_item.h"

namespace feedscope::ui {

/// A trace matched to a run, with the data of its pictures, made outside the GUI thread.
struct ShownTrace {
  std::shared_ptr<const Trace> trace;
  std::shared_ptr<const ShownRun> run;
  TraceOnProgram found;
  Agreement agreement;
  TraceMotion motion;
  TraceAlignment alignment;
  std::shared_ptr<const SampledPath> samples;  ///< of the first pass, for the 3D view
};

/// Colour of trace `number`, from 0: different from those of the first runs.
QColor trace_colour(std::size_t number);

/// Matches a trace to a run. Throws InputError if it is nowhere on the path of the run's program, and
/// Cancelled.
std::shared_ptr<const ShownTrace> lay_beside(std::shared_ptr<const Trace> trace,
                                             std::shared_ptr<const ShownRun> run,
                                             Progress* progress = nullptr);

enum class TraceStatus {
  waiting,   ///< for reading, or for the current run's simulation
  compared,  ///< with the current run
  cancelled,
  failed
};

/// The traces of the program, each matched to the current run. Read once, or if the file has no times for
/// each servo period of a machine; compared again with every other run. One at a time, on another thread.
class TraceList : public QObject {
  Q_OBJECT

 public:
  explicit TraceList(QObject* parent = nullptr);

  const std::vector<TraceItem>& items() const { return items_; }
  /// Appends a trace. `columns`: as TraceItem::columns; throws InputError for an invalid specification.
  void add(const std::filesystem::path& file, const std::string& columns = {});
  void remove(std::size_t row);
  /// Replaces all traces and assigns new ids. Invalid columns become the failure of their trace.
  void replace(std::vector<TraceItem> items);
  /// Removes all traces.
  void clear();
  void rename(std::size_t row, const QString& name);
  void set_colour(std::size_t row, const QColor& colour);
  void set_visible(std::size_t row, bool visible);
  /// Reads the file again with other columns. Throws as add().
  void set_columns(std::size_t row, const std::string& columns);
  /// The run to compare the traces with; null: none is simulated.
  void set_run(std::shared_ptr<const ShownRun> run);

  /// The trace matched to the current run; null until that is done.
  std::shared_ptr<const ShownTrace> result(std::size_t row) const;
  /// The trace as read; null until then.
  std::shared_ptr<const Trace> trace(std::size_t row) const;
  TraceStatus status(std::size_t row) const;
  /// Reason why a trace failed; empty for others.
  QString failure(std::size_t row) const;
  bool busy() const { return job_.busy(); }
  double fraction() const { return job_.fraction(); }
  /// Gives up all pending comparisons.
  void cancel();
  /// Resumes a trace that was given up.
  void resume(std::size_t row);

 signals:
  /// Traces were added or removed.
  void list_changed();
  /// Name, colour, visibility, status or result of a trace has changed.
  void changed(std::size_t row);
  /// Emitted some times a second while busy, and once afterwards.
  void progressed();
  /// `message` for the user: a trace could not be read or compared.
  void failed(const QString& message);
  /// A trace has been compared for the first time since its file was read.
  void compared_first(std::size_t row);

 private:
  /// State of a trace, by its id.
  struct State {
    std::shared_ptr<const Trace> trace;
    std::shared_ptr<const ShownTrace> shown;
    bool given_up = false;
    QString failure = {};
    bool was_compared = false;  ///< with this run or a previous one
    QString told = {};          ///< failure already reported to the user
    double machine_period = 0;  ///< TraceColumns::machine_period used for reading it
  };
  using Result = State;

  std::size_t row_of(int id) const;
  void work_on();
  void take(int id, const JobOutcome<Result>& outcome);
  QColor free_colour() const;

  std::vector<TraceItem> items_;
  std::map<int, State> states_;
  std::shared_ptr<const ShownRun> run_;
  int next_id_ = 1;
  int under_way_ = 0;  ///< id of the trace in progress; 0: none
  Job<Result> job_;
};

}  // namespace feedscope::ui
