#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/run/tolerance_in_force.h"
#include "ui/workbench/setup_state.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// One of several runs of the program.
struct RunItem {
  int id = 0;    ///< never reused for another run
  QString name;  ///< given by the user; empty: run_title() derives one from the setup
  QColor colour;
  bool visible = true;  ///< drawn with the current run
  SetupState setup;

  bool operator==(const RunItem&) const = default;
};

enum class RunStatus { waiting, simulated, cancelled, failed };

/// Default colours of runs, by their number: distinct for every kind of colour vision.
QColor run_colour(std::size_t number);
/// "A" for the first row, "Z" for the 26th, then "A1": short name of a run.
QString run_letter(std::size_t row);
/// Dash patterns of runs, in line widths, distinct in grey print; empty: solid.
QList<qreal> run_dashes(std::size_t number);

/// The name of a run, or else model, tolerance in force and changes: "essid, 0.05 mm, X Jerk 20 m/s³"; of
/// more than two changes their number. `feed_controls`: LoadedProgram::feed_controls. `left_out`: a setting
/// that is omitted, including the tolerance in force if it is the contour tolerance.
QString run_title(const RunItem& item, std::span<const PathControl> feed_controls,
                  std::string_view left_out = {});

/// The titles of runs that appear together: unnamed ones begin with the machine if the machines differ; "(2)"
/// follows the second of equal titles.
QStringList run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls);

/// Titles that distinguish the runs: as run_titles(), without the common parts of unnamed runs: "0.02 mm" for
/// runs that differ in nothing else. A run without parts of its own has its values of what others change.
QStringList short_run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls);

/// `names`, with "(2)" after the second of equal names, "(3)" after the third.
QStringList numbered(QStringList names);

/// The runs of one program and the current one, which is edited, played and shown in full. There is always at
/// least one. Changes of runs can be undone; results are not part of that and are discarded with their run. A
/// result always belongs to the current setup of its run, or there is none.
class RunList : public QObject {
  Q_OBJECT

 public:
  explicit RunList(Setup first, QObject* parent = nullptr);

  const std::vector<RunItem>& items() const { return items_; }
  std::size_t current() const { return current_; }
  const RunItem& current_item() const { return items_[current_]; }
  /// Row of a run; size of the list if it no longer exists.
  std::size_t row_of(int id) const;
  void select(std::size_t row);

  /// Adds a copy below, which becomes the current run.
  void duplicate(std::size_t row);
  /// As duplicate(), with another setup and a name; empty: named by its differences.
  void duplicate_as(std::size_t row, const SetupState& setup, const QString& name = {});
  /// The last run remains.
  void remove(std::size_t row);
  void move(std::size_t row, std::size_t to);
  void rename(std::size_t row, const QString& name);
  void set_colour(std::size_t row, const QColor& colour);
  void set_visible(std::size_t row, bool visible);
  /// `text` names the change in the history. Does nothing if nothing changes.
  void set_setup(std::size_t row, const SetupState& setup, const QString& text);
  /// Sets the setups of all runs, in order, in one step.
  void set_setups(const std::vector<SetupState>& setups, const QString& text);
  /// Engagement of the program's tools in all runs.
  const LoadSetup& load() const { return load_; }
  void set_load(const LoadSetup& load, const QString& text);
  /// Sets the load without a step in the history: the previous one does not fit the program.
  void use_load(const LoadSetup& load) { apply({items_, current_, load}); }
  /// The setup for simulating a run: with all edits, and load().
  Setup setup(const RunItem& item) const;
  /// Replaces all runs; clears the history.
  void replace(std::vector<RunItem> items, std::size_t current, const LoadSetup& load = {});
  QUndoStack& history() { return history_; }
  /// Largest contour error of a run that may be chosen [mm]; none: unlimited.
  const std::optional<double>& error_bound() const { return error_bound_; }
  void set_error_bound(const std::optional<double>& bound);

  /// Path control of the program, which may set its own tolerances: LoadedProgram::feed_controls.
  void set_feed_controls(std::vector<PathControl> controls);
  /// As run_titles().
  QString title(const RunItem& item) const;
  /// As short_run_titles(), preceded by the run's letter, as in pictures and tables: "B 0.02 mm"; the title
  /// only for a single run.
  QString lettered_title(std::size_t row) const;
  const std::vector<PathControl>& feed_controls() const { return feed_controls_; }
  /// None if the model follows none.
  std::optional<ToleranceInForce> tolerance(const RunItem& item) const;

  /// Result of the run's current setup; null until that is simulated.
  std::shared_ptr<const ShownRun> result(std::size_t row) const;
  /// Drawable part of the run: result(), or set_drawn() before its summary is known.
  std::shared_ptr<const ShownRun> drawn(std::size_t row) const;
  /// The last result of a run of this program, with any setup; null without one.
  std::shared_ptr<const ShownRun> last_result(std::size_t row) const;
  RunStatus status(std::size_t row) const;
  /// Reason why a run failed; empty for others.
  QString failure(std::size_t row) const;
  /// Does nothing for a run that no longer exists.
  void set_result(int id, std::shared_ptr<const ShownRun> result);
  /// Sets the drawable part of the run being simulated, until it has a result or is given up.
  void set_drawn(int id, std::shared_ptr<const ShownRun> drawn);
  /// The run's current setup is not simulated: cancelled, or failed with a message for the user.
  void give_up(int id, const QString& failure = {});
  /// Puts a run that was given up in the queue again.
  void resume(std::size_t row);
  /// For another program: all results are invalid, and no run is given up.
  void clear_results();

 signals:
  /// Runs were added, removed or moved.
  void list_changed();
  /// Title, colour, visibility or setup of a run has changed.
  void item_changed(std::size_t row);
  void setup_changed(std::size_t row, const feedscope::ui::SetupState& before);
  /// The engagement of the tools has changed.
  void load_changed();
  void current_changed();
  void error_bound_changed();
  void result_changed(std::size_t row);
  /// A run was given up, or waits again.
  void status_changed(std::size_t row);

 private:
  struct Snapshot {
    std::vector<RunItem> items;
    std::size_t current = 0;
    LoadSetup load;
  };
  class Change;

  void push(Snapshot after, const QString& text);
  void apply(const Snapshot& snapshot);
  void check_results(const Snapshot& before);
  QColor free_colour() const;

  std::vector<RunItem> items_;
  std::size_t current_ = 0;
  LoadSetup load_;
  int next_id_ = 1;
  struct Result {
    std::shared_ptr<const ShownRun> shown;
    bool holds;  ///< whether it is of the run's current setup
  };
  std::map<int, Result> results_;  ///< the last of each run
  struct Drawn {
    int id = 0;
    std::shared_ptr<const ShownRun> shown;  ///< null: nothing is drawn before its result
  };
  Drawn drawn_;
  std::map<int, QString> given_up_;    ///< reason by the id of the run; empty: cancelled
  std::optional<double> error_bound_;  ///< [mm]
  std::vector<PathControl> feed_controls_;
  QStringList titles_;  ///< of the items
  QUndoStack history_;
};

}  // namespace feedscope::ui
