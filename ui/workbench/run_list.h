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

#include "core/analysis/tolerance_in_force.h"
#include "ui/workbench/setup_state.h"
#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// One of several runs of the program.
struct RunItem {
  int id = 0;    ///< never used again for another run
  QString name;  ///< given by the user; empty: run_title() says what it runs on
  QColor colour;
  bool visible = true;  ///< drawn beside the current run
  SetupState setup;

  bool operator==(const RunItem&) const = default;
};

/// What there is of a run that is to be simulated.
enum class RunStatus { waiting, simulated, cancelled, failed };

/// Colours of runs that nobody has coloured, by their number: told apart with every kind of colour vision.
QColor run_colour(std::size_t number);
/// "A" for the first row, "Z" for the 26th, then "A1": what a run is called where its name has no room.
QString run_letter(std::size_t row);
/// Dashes of their lines, in line widths, told apart in grey print; empty: a whole line.
QList<qreal> run_dashes(std::size_t number);

/// The name of a run, or else model, tolerance in force and what is changed: "essid, 0.05 mm, X Jerk 20
/// m/s³"; of more than two changes their number. `feed_controls`: LoadedProgram::feed_controls. `left_out`: a
/// setting that is not named, the tolerance in force too where it is the contour tolerance.
QString run_title(const RunItem& item, std::span<const PathControl> feed_controls,
                  std::string_view left_out = {});

/// The titles of runs that are shown together: the machine before those without a name where the machines
/// differ, "(2)" behind the second run of one title.
QStringList run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls);

/// What tells the runs apart: as run_titles(), without what all runs without a name have in common: "0.02 mm"
/// of runs that differ in nothing else.
QStringList short_run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls);

/// `names`, with "(2)" behind the second of one name, "(3)" behind the third.
QStringList numbered(QStringList names);

/// The runs of one program and which of them is the current one: the one that is edited, played and shown in
/// full. There is always at least one. What changes a run can be undone; results are not part of that and are
/// dropped with their run. A result is that of the setup which its run has now, or there is none.
class RunList : public QObject {
  Q_OBJECT

 public:
  explicit RunList(Setup first, QObject* parent = nullptr);

  const std::vector<RunItem>& items() const { return items_; }
  std::size_t current() const { return current_; }
  const RunItem& current_item() const { return items_[current_]; }
  /// Row of a run; size of the list if it is gone.
  std::size_t row_of(int id) const;
  void select(std::size_t row);

  /// A copy below, which becomes the current run.
  void duplicate(std::size_t row);
  /// As duplicate(), with another setup and a name of its own; empty: named by what differs.
  void duplicate_as(std::size_t row, const SetupState& setup, const QString& name = {});
  /// The last run stays.
  void remove(std::size_t row);
  void move(std::size_t row, std::size_t to);
  void rename(std::size_t row, const QString& name);
  void set_colour(std::size_t row, const QColor& colour);
  void set_visible(std::size_t row, bool visible);
  /// `text` names the change in the history. Nothing happens if nothing changes.
  void set_setup(std::size_t row, const SetupState& setup, const QString& text);
  /// The same of every run, in their order, in one step.
  void set_setups(const std::vector<SetupState>& setups, const QString& text);
  /// How the tools of the program are engaged, in every run.
  const LoadSetup& load() const { return load_; }
  void set_load(const LoadSetup& load, const QString& text);
  /// The same without a step of the history: what was set does not fit the program.
  void use_load(const LoadSetup& load) { apply({items_, current_, load}); }
  /// What a run is simulated with: its setup with all edits, and load().
  Setup setup(const RunItem& item) const;
  /// Another set of runs altogether; the history goes.
  void replace(std::vector<RunItem> items, std::size_t current, const LoadSetup& load = {});
  QUndoStack& history() { return history_; }
  /// Largest contour error of a run that may be chosen [mm]; none: any.
  const std::optional<double>& error_bound() const { return error_bound_; }
  void set_error_bound(const std::optional<double>& bound);

  /// Those of the program, which may set tolerances of its own: LoadedProgram::feed_controls.
  void set_feed_controls(std::vector<PathControl> controls);
  /// As run_titles().
  QString title(const RunItem& item) const;
  /// As short_run_titles(), with the run's letter before it, as pictures and tables name it: "B 0.02 mm";
  /// alone with one run.
  QString lettered_title(std::size_t row) const;
  const std::vector<PathControl>& feed_controls() const { return feed_controls_; }
  /// None where the model follows none.
  std::optional<ToleranceInForce> tolerance(const RunItem& item) const;

  /// What the setup that a run has now gives; null while that has not been simulated.
  std::shared_ptr<const ShownRun> result(std::size_t row) const;
  /// What pictures draw of it: result(), or before its summary is known what has been set_drawn().
  std::shared_ptr<const ShownRun> drawn(std::size_t row) const;
  /// The last result of a run of this program, with whatever setup; null without any.
  std::shared_ptr<const ShownRun> last_result(std::size_t row) const;
  RunStatus status(std::size_t row) const;
  /// Why a run has failed; empty for every other one.
  QString failure(std::size_t row) const;
  /// For a run that is gone: nothing.
  void set_result(int id, std::shared_ptr<const ShownRun> result);
  /// Of the run under way, until it has a result or is given up: what its pictures need, without the rest.
  void set_drawn(int id, std::shared_ptr<const ShownRun> drawn);
  /// The setup that a run has now is not simulated: cancelled, or failed with a message for the user.
  void give_up(int id, const QString& failure = {});
  /// A run that was given up waits again.
  void resume(std::size_t row);
  /// Another program: no result holds, and nothing is given up.
  void clear_results();

 signals:
  /// Runs have come, gone or moved.
  void list_changed();
  /// Title, colour, visibility or setup of a run.
  void item_changed(std::size_t row);
  void setup_changed(std::size_t row, const feedscope::ui::SetupState& before);
  /// Another way in which the tools are engaged.
  void load_changed();
  void current_changed();
  void error_bound_changed();
  void result_changed(std::size_t row);
  /// Given up, or waiting again.
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
    bool holds;  ///< of the setup that the run has now
  };
  std::map<int, Result> results_;  ///< the last of each run
  struct Drawn {
    int id = 0;
    std::shared_ptr<const ShownRun> shown;  ///< null: nothing is drawn before its result
  };
  Drawn drawn_;
  std::map<int, QString> given_up_;    ///< why, by the id of the run; empty: cancelled
  std::optional<double> error_bound_;  ///< [mm]
  std::vector<PathControl> feed_controls_;
  QStringList titles_;  ///< of the items
  QUndoStack history_;
};

}  // namespace feedscope::ui
