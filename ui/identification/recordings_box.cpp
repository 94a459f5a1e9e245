#include "ui/identification/recordings_box.h"

#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/fields/focus_outline.h"
#include "ui/language/texts.h"
#include "ui/shared/paths.h"
#include "ui/theme/type_size.h"
#include "ui/workbench/trace_messages.h"

namespace feedscope::ui {
namespace {

constexpr int least_rows = 1;
constexpr int most_rows = 4;

}  // namespace

RecordingsBox::RecordingsBox(Workbench& workbench, QWidget* parent)
    : QWidget(parent), workbench_(workbench), list_(new QListWidget(this)), note_(new QLabel(this)) {
  list_->setAccessibleName(tr("Recordings that are used"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideMiddle);
  new FocusOutline(*list_);
  note_->setWordWrap(true);
  note_->setTextFormat(Qt::PlainText);
  note_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(list_);
  layout->addWidget(note_);
  connect(list_, &QListWidget::itemChanged, this,
          [this](const QListWidgetItem* item) { take_tick(list_->row(item)); });
  TraceList& traces = workbench_.traces();
  connect(&traces, &TraceList::list_changed, this, &RecordingsBox::refresh);
  connect(&traces, &TraceList::changed, this, &RecordingsBox::refresh);
  connect(&workbench_, &Workbench::program_changed, this, &RecordingsBox::refresh);
  connect(&TypeSize::of_application(), &TypeSize::changed, this,
          [this] { QMetaObject::invokeMethod(this, &RecordingsBox::refresh, Qt::QueuedConnection); });
  refresh();
}

bool RecordingsBox::is_used(std::size_t row) const {
  return !unused_.contains(workbench_.traces().items()[row].id);
}

std::vector<std::shared_ptr<const Trace>> RecordingsBox::traces() const {
  std::vector<std::shared_ptr<const Trace>> used;
  for (std::size_t row = 0; row < workbench_.traces().items().size(); ++row) {
    if (auto trace = workbench_.traces().trace(row); is_used(row) && trace != nullptr) {
      used.push_back(std::move(trace));
    }
  }
  return used;
}

std::vector<std::shared_ptr<const SectionTable>> RecordingsBox::tables() const {
  std::vector<std::shared_ptr<const SectionTable>> used;
  for (const TableState& table : tables_) {
    if (table.used) {
      used.push_back(table.table);
    }
  }
  return used;
}

bool RecordingsBox::is_reading() const {
  const TraceList& traces = workbench_.traces();
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    if (is_used(row) && traces.trace(row) == nullptr && traces.status(row) == TraceStatus::waiting) {
      return true;
    }
  }
  return false;
}

void RecordingsBox::add_table(const std::filesystem::path& file) {
  const QString name = to_qstring(file);
  auto read = std::make_shared<const SectionTable>(SectionTable{name, read_section_times(file)});
  std::erase_if(tables_, [&](const TableState& other) { return other.table->name == name; });
  tables_.push_back({std::move(read), true});
  refresh();
}

void RecordingsBox::forget_tables() {
  tables_.clear();
  refresh();
}

std::vector<std::size_t> RecordingsBox::unused_traces() const {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < workbench_.traces().items().size(); ++row) {
    if (!is_used(row)) {
      rows.push_back(row);
    }
  }
  return rows;
}

void RecordingsBox::set_state(const std::vector<std::size_t>& unused_traces, std::vector<TableState> tables) {
  const std::vector<TraceItem>& traces = workbench_.traces().items();
  unused_.clear();
  for (const std::size_t row : unused_traces) {
    if (row < traces.size()) {
      unused_.insert(traces[row].id);
    }
  }
  tables_ = std::move(tables);
  refresh();
}

void RecordingsBox::take_tick(int row) {
  const bool used = list_->item(row)->checkState() == Qt::Checked;
  const std::vector<TraceItem>& items = workbench_.traces().items();
  const auto index = static_cast<std::size_t>(row);
  if (index >= items.size()) {
    tables_[index - items.size()].used = used;
  } else if (used) {
    unused_.erase(items[index].id);
  } else {
    unused_.insert(items[index].id);
  }
  show_notes();
  emit changed();
}

void RecordingsBox::add_row(const QString& text, const QString& tip, bool used) {
  auto* item = new QListWidgetItem(text, list_);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(used ? Qt::Checked : Qt::Unchecked);
  item->setToolTip(tip);
}

/// Errors of a trace, in its program and in its file.
QString RecordingsBox::messages_of(std::size_t row) const {
  const TraceList& traces = workbench_.traces();
  const auto shown = traces.result(row);
  if (shown == nullptr) {
    return traces.failure(row);
  }
  QStringList said;
  for (const Diagnostic& message : messages_on(*shown->trace, shown->found)) {
    if (message.severity != Severity::info || said.isEmpty()) {
      said.append(message_text(message));
    }
  }
  return said.join(' ');
}

void RecordingsBox::refresh() {
  const QSignalBlocker quiet(list_);
  const int current = list_->currentRow();
  list_->clear();
  const TraceList& traces = workbench_.traces();
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    const QString& name = traces.items()[row].name;
    const auto trace = traces.trace(row);
    const QString messages = messages_of(row);
    add_row(trace == nullptr || trace->time.empty()
                ? name
                : tr("%1: trace, %2").arg(name, clock_text(trace->time.back() - trace->time.front())),
            messages.isEmpty() ? to_qstring(traces.items()[row].file) : messages, is_used(row));
  }
  for (const TableState& table : tables_) {
    add_row(tr("%1: %2 section times")
                .arg(to_qstring(to_path(table.table->name).filename()))
                .arg(table.table->times.size()),
            table.table->name, table.used);
  }
  const int rows = list_->count();
  list_->setVisible(rows > 0);
  if (rows > 0) {
    list_->setFixedHeight(std::clamp(rows, least_rows, most_rows) * list_->sizeHintForRow(0) +
                          2 * list_->frameWidth() + 2);
    list_->setCurrentRow(std::clamp(current, 0, rows - 1));
  }
  show_notes();
  emit changed();
}

/// Shows errors in the ticked recordings, or how to obtain one.
void RecordingsBox::show_notes() {
  QStringList notes;
  const TraceList& traces = workbench_.traces();
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    const QString messages = messages_of(row);
    if (is_used(row) && !messages.isEmpty()) {
      notes.append(tr("%1: %2").arg(traces.items()[row].name, messages));
    }
  }
  if (list_->count() == 0 && workbench_.program() == nullptr) {
    notes.append(
        tr("Open the program that ran on your machine. For most numbers run the test program: write it here, "
           "and open it."));
  } else if (list_->count() == 0) {
    notes.append(tr(
        "Record X, Y and Z on the control while this program runs, best at 1 to 4 ms a sample, and open the "
        "trace. Without a trace: write the times of its sections into a table with the titles "
        "section,seconds and open that. The test program tells most numbers."));
  }
  note_->setText(notes.join('\n'));
  note_->setVisible(!notes.isEmpty());
}

QString RecordingsBox::note() const {
  return note_->text();
}

}  // namespace feedscope::ui
