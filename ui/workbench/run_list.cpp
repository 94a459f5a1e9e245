#include "ui/workbench/run_list.h"

#include <QSet>
#include <QUndoCommand>
#include <algorithm>

#include "core/base/error.h"
#include "core/machine/contour_tolerance.h"
#include "ui/workbench/setting_texts.h"
#include "ui/workbench/tolerance_text.h"

namespace feedscope::ui {

namespace {

// Each has a contrast of at least three to one to the light and the dark background, and differs from those
// of axes and other curves in the charts. The first ones are distinct for every kind of colour vision.
constexpr std::array<QRgb, 8> run_colours{0xff7538ff, 0xff945c38, 0xffff1aad, 0xff799e00,
                                          0xff5786ff, 0xffc46471, 0xff23718b, 0xff796906};

}  // namespace

QColor run_colour(std::size_t number) {
  return QColor(run_colours[number % run_colours.size()]);
}

QList<qreal> run_dashes(std::size_t number) {
  static const std::array<QList<qreal>, 8> dashes{
      {{}, {6, 3}, {1.5, 1.5}, {8, 2, 1.5, 2}, {3, 2}, {8, 2, 1.5, 2, 1.5, 2}, {12, 4}, {4, 2, 4, 6}}};
  return dashes[number % dashes.size()];
}

QString run_letter(std::size_t row) {
  constexpr std::size_t letters = 26;
  const QString letter(QChar(static_cast<char16_t>(u'A' + row % letters)));
  return row < letters ? letter : letter + QString::number(row / letters);
}

namespace {

bool is_tolerance(const std::string& key) {
  return key == contour_tolerance_key || key == program_tolerance_key;
}

/// What was changed of a setup, one text each.
QStringList changed_texts(const SetupState& setup, std::string_view left_out) {
  std::map<std::string, SettingValue> changed = setup.edits();
  std::erase_if(changed,
                [&](const auto& edit) { return is_tolerance(edit.first) || edit.first == left_out; });
  return setting_texts(changed);
}

/// Model, tolerance in force and changes, one part each.
QStringList title_parts(const RunItem& item, std::span<const PathControl> feed_controls,
                        std::string_view left_out) {
  const SetupState& setup = item.setup;
  QStringList parts{QString::fromStdString(setup.file().model->info().id)};
  const auto tolerance = tolerance_in_force(feed_controls, setup.setup());
  if (tolerance && left_out != contour_tolerance_key) {
    parts.append(tolerance_text(*tolerance));
  }
  return parts + changed_texts(setup, left_out);
}

QString joined(QStringList parts, qsizetype most) {
  if (const qsizetype more = parts.size() - most; more > 0) {
    parts.resize(most);
    parts.append(RunList::tr("%n more", "changed settings, behind two of them", static_cast<int>(more)));
  }
  return parts.join(QStringLiteral(", "));
}

/// Values of `item` of what is changed in any of the runs without a name.
QStringList compared_texts(const RunItem& item, std::span<const RunItem> items) {
  std::map<std::string, SettingValue> values;
  for (const RunItem& other : items) {
    for (const auto& [key, value] : other.setup.edits()) {
      try {
        if (other.name.isEmpty() && !is_tolerance(key)) {
          values.insert({key, item.setup.value(key)});
        }
      } catch (const InputError&) {  // its machine or model has no such value
      }
    }
  }
  return setting_texts(values);
}

}  // namespace

QString run_title(const RunItem& item, std::span<const PathControl> feed_controls,
                  std::string_view left_out) {
  if (!item.name.isEmpty()) {
    return item.name;
  }
  const QStringList parts = title_parts(item, feed_controls, left_out);
  const qsizetype changes = changed_texts(item.setup, left_out).size();
  constexpr qsizetype most_changes = 2;
  return joined(parts, parts.size() - changes + most_changes);
}

QStringList short_run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls) {
  std::vector<QStringList> parts;
  std::map<QString, std::size_t> runs_with;
  std::size_t unnamed = 0;
  for (const RunItem& item : items) {
    parts.push_back(QStringList{QString::fromStdString(item.setup.file().machine.id)} +
                    title_parts(item, feed_controls, {}));
    if (item.name.isEmpty()) {
      ++unnamed;
      for (const QString& part : QSet<QString>(parts.back().begin(), parts.back().end())) {
        ++runs_with[part];
      }
    }
  }
  QStringList titles;
  for (std::size_t i = 0; i < items.size(); ++i) {
    QStringList own = parts[i];
    own.removeIf([&](const QString& part) { return runs_with[part] == unnamed; });
    constexpr qsizetype most = 4;
    constexpr qsizetype most_compared = 2;
    if (own.isEmpty()) {
      own = compared_texts(items[i], items);
      own = own.size() > most_compared ? QStringList() : own;
    }
    titles.append(!items[i].name.isEmpty() ? items[i].name
                  : own.isEmpty()          ? run_title(items[i], feed_controls)
                                           : joined(own, most));
  }
  return numbered(titles);
}

QStringList numbered(QStringList names) {
  std::map<QString, int> count;
  for (QString& name : names) {
    if (const int number = ++count[name]; number > 1) {
      name += QStringLiteral(" (%1)").arg(number);
    }
  }
  return names;
}

QStringList run_titles(std::span<const RunItem> items, std::span<const PathControl> feed_controls) {
  const auto machine = [](const RunItem& item) -> const std::string& { return item.setup.file().machine.id; };
  const bool machines_differ =
      std::ranges::adjacent_find(items, std::ranges::not_equal_to(), machine) != items.end();
  QStringList titles;
  for (const RunItem& item : items) {
    const QString title = run_title(item, feed_controls);
    titles.append(machines_differ && item.name.isEmpty()
                      ? QString::fromStdString(machine(item)) + QStringLiteral(", ") + title
                      : title);
  }
  return numbered(titles);
}

class RunList::Change : public QUndoCommand {
 public:
  Change(RunList& runs, Snapshot after, const QString& text)
      : QUndoCommand(text),
        runs_(runs),
        before_{runs.items_, runs.current_, runs.load_},
        after_(std::move(after)) {}
  void undo() override { runs_.apply(before_); }
  void redo() override { runs_.apply(after_); }

 private:
  RunList& runs_;
  Snapshot before_;
  Snapshot after_;
};

RunList::RunList(Setup first, QObject* parent) : QObject(parent) {
  items_.push_back({next_id_++, {}, free_colour(), true, SetupState(std::move(first))});
  titles_ = run_titles(items_, feed_controls_);
}

std::size_t RunList::row_of(int id) const {
  return static_cast<std::size_t>(std::ranges::find(items_, id, &RunItem::id) - items_.begin());
}

void RunList::select(std::size_t row) {
  if (row < items_.size() && row != current_) {
    current_ = row;
    emit current_changed();
  }
}

void RunList::duplicate(std::size_t row) {
  duplicate_as(row, items_[row].setup);
}

void RunList::duplicate_as(std::size_t row, const SetupState& setup, const QString& name) {
  Snapshot after{items_, row + 1, load_};
  RunItem copy{next_id_++, name.trimmed(), free_colour(), true, setup};
  if (const auto same = result(row); same != nullptr && same->run.setup == this->setup(copy)) {
    results_[copy.id] = {same, true};
  }
  after.items.insert(after.items.begin() + static_cast<std::ptrdiff_t>(row) + 1, std::move(copy));
  push(std::move(after), tr("duplicate run"));
}

void RunList::remove(std::size_t row) {
  if (items_.size() < 2) {
    return;
  }
  Snapshot after{items_, current_, load_};
  after.items.erase(after.items.begin() + static_cast<std::ptrdiff_t>(row));
  if (after.current > row || after.current == after.items.size()) {
    --after.current;
  }
  push(std::move(after), tr("remove run"));
}

void RunList::move(std::size_t row, std::size_t to) {
  to = std::min(to, items_.size() - 1);
  if (row == to) {
    return;
  }
  Snapshot after{items_, current_, load_};
  const auto from = after.items.begin() + static_cast<std::ptrdiff_t>(row);
  const auto target = after.items.begin() + static_cast<std::ptrdiff_t>(to);
  if (row < to) {
    std::rotate(from, from + 1, target + 1);
  } else {
    std::rotate(target, from, from + 1);
  }
  const int id = current_item().id;
  after.current =
      static_cast<std::size_t>(std::ranges::find(after.items, id, &RunItem::id) - after.items.begin());
  push(std::move(after), tr("move run"));
}

void RunList::rename(std::size_t row, const QString& name) {
  Snapshot after{items_, current_, load_};
  after.items[row].name = name.trimmed();
  push(std::move(after), tr("name of run"));
}

void RunList::set_colour(std::size_t row, const QColor& colour) {
  Snapshot after{items_, current_, load_};
  after.items[row].colour = colour;
  push(std::move(after), tr("colour of run"));
}

void RunList::set_visible(std::size_t row, bool visible) {
  Snapshot after{items_, current_, load_};
  after.items[row].visible = visible;
  push(std::move(after), visible ? tr("show run") : tr("hide run"));
}

void RunList::set_setup(std::size_t row, const SetupState& setup, const QString& text) {
  Snapshot after{items_, current_, load_};
  after.items[row].setup = setup;
  push(std::move(after), text);
}

void RunList::set_setups(const std::vector<SetupState>& setups, const QString& text) {
  Snapshot after{items_, current_, load_};
  for (std::size_t row = 0; row < after.items.size(); ++row) {
    after.items[row].setup = setups[row];
  }
  push(std::move(after), text);
}

void RunList::set_load(const LoadSetup& load, const QString& text) {
  push({items_, current_, load}, text);
}

Setup RunList::setup(const RunItem& item) const {
  Setup setup = item.setup.setup();
  setup.load = load_;
  return setup;
}

void RunList::replace(std::vector<RunItem> items, std::size_t current, const LoadSetup& load) {
  history_.clear();
  results_.clear();
  given_up_.clear();
  for (RunItem& item : items) {
    item.id = next_id_++;
  }
  items_ = std::move(items);
  current_ = std::min(current, items_.size() - 1);
  load_ = load;
  titles_ = run_titles(items_, feed_controls_);
  emit list_changed();
  emit current_changed();
  emit load_changed();
}

void RunList::push(Snapshot after, const QString& text) {
  if (after.items != items_ || after.current != current_ || !(after.load == load_)) {
    history_.push(new Change(*this, std::move(after), text));
  }
}

void RunList::apply(const Snapshot& snapshot) {
  const Snapshot before{items_, current_, load_};
  const int selected = current_item().id;
  std::map<int, QString> titles;
  for (std::size_t row = 0; row < items_.size(); ++row) {
    titles[items_[row].id] = titles_[static_cast<qsizetype>(row)];
  }
  items_ = snapshot.items;
  titles_ = run_titles(items_, feed_controls_);
  current_ = snapshot.current;
  load_ = snapshot.load;
  const auto is_gone = [this](const auto& entry) { return row_of(entry.first) == items_.size(); };
  std::erase_if(results_, is_gone);
  std::erase_if(given_up_, is_gone);
  check_results(before);

  const bool same_rows = std::ranges::equal(before.items, items_, {}, &RunItem::id, &RunItem::id);
  if (!same_rows) {
    emit list_changed();
  }
  if (current_item().id != selected) {
    emit current_changed();
  }
  for (std::size_t row = 0; row < before.items.size(); ++row) {
    const RunItem& was = before.items[row];
    const std::size_t now = row_of(was.id);
    if (now == items_.size()) {
      continue;
    }
    if (!(items_[now] == was) || title(items_[now]) != titles[was.id]) {
      emit item_changed(now);
      if (!(items_[now].setup == was.setup)) {
        emit setup_changed(now, was.setup);
      }
    }
  }
  if (!(load_ == before.load)) {
    emit load_changed();
  }
}

/// Determines which results still belong to their runs' setups.
void RunList::check_results(const Snapshot& before) {
  for (const RunItem& was : before.items) {
    const std::size_t now = row_of(was.id);
    if (now < items_.size() && !(items_[now].setup == was.setup && load_ == before.load)) {
      given_up_.erase(was.id);
      if (const auto found = results_.find(was.id); found != results_.end()) {
        found->second.holds = found->second.shown->run.setup == setup(items_[now]);
      }
    }
  }
}

void RunList::set_feed_controls(std::vector<PathControl> controls) {
  feed_controls_ = std::move(controls);
  titles_ = run_titles(items_, feed_controls_);
  for (std::size_t row = 0; row < items_.size(); ++row) {
    emit item_changed(row);
  }
}

QString RunList::title(const RunItem& item) const {
  return titles_.value(static_cast<qsizetype>(row_of(item.id)));
}

QString RunList::lettered_title(std::size_t row) const {
  const QString name = short_run_titles(items_, feed_controls_)[static_cast<qsizetype>(row)];
  return items_.size() > 1 ? run_letter(row) + ' ' + name : name;
}

std::optional<ToleranceInForce> RunList::tolerance(const RunItem& item) const {
  return tolerance_in_force(feed_controls_, item.setup.setup());
}

QColor RunList::free_colour() const {
  const auto used = [this](const QColor& colour) {
    return std::ranges::count(items_, colour, &RunItem::colour);
  };
  return QColor(*std::ranges::min_element(run_colours, {}, [&](QRgb rgb) { return used(QColor(rgb)); }));
}

void RunList::set_error_bound(const std::optional<double>& bound) {
  if (bound != error_bound_) {
    error_bound_ = bound;
    emit error_bound_changed();
  }
}

std::shared_ptr<const ShownRun> RunList::result(std::size_t row) const {
  const auto found = results_.find(items_[row].id);
  return found != results_.end() && found->second.holds ? found->second.shown : nullptr;
}

std::shared_ptr<const ShownRun> RunList::drawn(std::size_t row) const {
  const auto whole = result(row);
  const bool begun = whole == nullptr && drawn_.shown != nullptr && drawn_.id == items_[row].id &&
                     drawn_.shown->run.setup == setup(items_[row]);
  return begun ? drawn_.shown : whole;
}

std::shared_ptr<const ShownRun> RunList::last_result(std::size_t row) const {
  const auto found = results_.find(items_[row].id);
  return found != results_.end() ? found->second.shown : nullptr;
}

RunStatus RunList::status(std::size_t row) const {
  if (result(row) != nullptr) {
    return RunStatus::simulated;
  }
  const auto found = given_up_.find(items_[row].id);
  if (found == given_up_.end()) {
    return RunStatus::waiting;
  }
  return found->second.isEmpty() ? RunStatus::cancelled : RunStatus::failed;
}

QString RunList::failure(std::size_t row) const {
  const auto found = given_up_.find(items_[row].id);
  return found == given_up_.end() ? QString() : found->second;
}

void RunList::set_drawn(int id, std::shared_ptr<const ShownRun> drawn) {
  drawn_ = {id, std::move(drawn)};
}

void RunList::set_result(int id, std::shared_ptr<const ShownRun> result) {
  drawn_ = {};
  const std::size_t row = row_of(id);
  if (row < items_.size()) {
    const bool holds = result->run.setup == setup(items_[row]);
    results_[id] = {std::move(result), holds};
    given_up_.erase(id);
    emit result_changed(row);
  }
}

void RunList::give_up(int id, const QString& failure) {
  drawn_ = {};
  const std::size_t row = row_of(id);
  if (row < items_.size() && result(row) == nullptr) {
    given_up_[id] = failure;
    emit status_changed(row);
  }
}

void RunList::resume(std::size_t row) {
  if (given_up_.erase(items_[row].id) > 0) {
    emit status_changed(row);
  }
}

void RunList::clear_results() {
  drawn_ = {};
  results_.clear();
  given_up_.clear();
  for (std::size_t row = 0; row < items_.size(); ++row) {
    emit result_changed(row);
  }
}

}  // namespace feedscope::ui
