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

/// A trace beside a run, with what its pictures need, made off the GUI thread.
struct ShownTrace {
  std::shared_ptr<const Trace> trace;
  std::shared_ptr<const ShownRun> run;
  TraceOnProgram found;
  Agreement agreement;
  TraceMotion motion;
  TraceAlignment alignment;
  std::shared_ptr<const SampledPath> samples;  ///< of the first pass, as the 3D view draws it
};

/// Of the `number`th trace, from 0: unlike those of the first runs.
QColor trace_colour(std::size_t number);

/// Throws InputError if the trace is nowhere on the path of the run's program, and Cancelled.
std::shared_ptr<const ShownTrace> lay_beside(std::shared_ptr<const Trace> trace,
                                             std::shared_ptr<const ShownRun> run,
                                             Progress* progress = nullptr);

/// What there is of a trace.
enum class TraceStatus {
  waiting,   ///< to be read, or for the current run to be simulated
  compared,  ///< with the current run
  cancelled,
  failed
};

/// The traces of the program, each laid beside the current run: read once, or where the file has no times for
/// each servo period of a machine, and compared again with every other run. One at a time, on another thread.
class TraceList : public QObject {
  Q_OBJECT

 public:
  explicit TraceList(QObject* parent = nullptr);

  const std::vector<TraceItem>& items() const { return items_; }
  /// Behind the others. `columns`: as TraceItem::columns; throws InputError if it cannot be read.
  void add(const std::filesystem::path& file, const std::string& columns = {});
  void remove(std::size_t row);
  /// These instead of the present ones; they get ids of their own. Columns that cannot be read become the
  /// failure of their trace.
  void replace(std::vector<TraceItem> items);
  /// Without any more.
  void clear();
  void rename(std::size_t row, const QString& name);
  void set_colour(std::size_t row, const QColor& colour);
  void set_visible(std::size_t row, bool visible);
  /// Reads the file again, in another way. Throws as add().
  void set_columns(std::size_t row, const std::string& columns);
  /// The run that the traces are compared with; null: none is simulated.
  void set_run(std::shared_ptr<const ShownRun> run);

  /// Beside the current run; null until that is done.
  std::shared_ptr<const ShownTrace> result(std::size_t row) const;
  /// What was read; null until then.
  std::shared_ptr<const Trace> trace(std::size_t row) const;
  TraceStatus status(std::size_t row) const;
  /// Why a trace has failed; empty for every other one.
  QString failure(std::size_t row) const;
  bool busy() const { return job_.busy(); }
  double fraction() const { return job_.fraction(); }
  /// Gives up all that is not compared yet.
  void cancel();
  /// A trace that was given up, once more.
  void resume(std::size_t row);

 signals:
  /// Traces have come or gone.
  void list_changed();
  /// Name, colour, visibility, status or result of a trace.
  void changed(std::size_t row);
  /// While busy, some times a second; and once when it is not any more.
  void progressed();
  /// `message` for the user: a trace could not be read or compared.
  void failed(const QString& message);
  /// A trace has been compared for the first time since its file was read.
  void compared_first(std::size_t row);

 private:
  /// What is known of a trace, by its id.
  struct State {
    std::shared_ptr<const Trace> trace;
    std::shared_ptr<const ShownTrace> shown;
    bool given_up = false;
    QString failure = {};
    bool was_compared = false;  ///< with this run or one before
    QString told = {};          ///< the failure that the user has been told
    double machine_period = 0;  ///< TraceColumns::machine_period that it was read with
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
  int under_way_ = 0;  ///< id of the trace that is worked on; 0: none
  Job<Result> job_;
};

}  // namespace feedscope::ui
