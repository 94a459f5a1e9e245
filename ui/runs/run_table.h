#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "core/analysis/run/source_figures.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/trace_list.h"

namespace feedscope::ui {

/// The runs as a table of results: a row for each run, the current one bold. The check box shows or hides a
/// run; name and colour can be edited.
///
/// Below them the traces of the program: the time of the control, and its deviation from the path.
///
/// The run to take is marked: recommended().
class RunTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// Columns of figures of drives and cutting load follow if any run has them.
  enum Column { name, machine, model, tolerance, cycle_time, difference, mean_feed, contour_error, columns };

  /// `runs` outlives this.
  explicit RunTable(RunList& runs, QObject* parent = nullptr);

  /// Adds rows for these below the runs; `traces` outlives this.
  void set_traces(TraceList& traces);
  /// Index of the trace in a row; none: a run.
  std::optional<std::size_t> trace_of(int row) const;

  /// Rows of the fastest runs with a result within the bound (fastest_runs); none if none keeps it or is
  /// possible.
  std::vector<std::size_t> fastest() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(std::size_t row, int column) const;
  QString figure(std::size_t row, int column) const;
  QString explanation(std::size_t row) const;
  void append_slower_tolerance(std::size_t row, QStringList& lines) const;
  const Summary* summary(std::size_t row) const;
  /// Whether the control refuses so much of the program that there is no cycle time; false without a result.
  bool refused(std::size_t row) const;
  /// Whether the program exceeds the machine's reach; false without a result.
  bool out_of_reach(std::size_t row) const;
  /// Whether there is a result that control and machine can run.
  bool counts(std::size_t row) const;
  std::size_t lines_not_run(std::size_t row) const;
  bool keeps_bound(const Summary& summary) const;
  QVariant trace_data(std::size_t trace, int column, int role) const;
  QString trace_text(std::size_t trace, int column) const;
  QString trace_explanation(std::size_t trace) const;
  void reset();
  void follow_figures();
  void changed(std::size_t row);
  void all_changed();

  RunList& runs_;
  TraceList* traces_ = nullptr;
  std::optional<std::size_t> taken_;          ///< row of the run to take, if there are others
  const SourceFigure* error_ = nullptr;       ///< actual error, if any run has one: in `contour_error`
  std::vector<const SourceFigure*> figures_;  ///< after `columns`
};

}  // namespace feedscope::ui
