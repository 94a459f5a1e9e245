#include "ui/trace/trace_import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.h"
#include "core/trace/read_trace.h"
#include "core/trace/table_columns.h"
#include "core/trace/trace_text.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/paths.h"
#include "ui/trace/trace_import_fields.h"
#include "ui/trace/trace_presets.h"
#include "ui/workbench/trace_messages.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t looked_at = 65536;  // bytes of the file
constexpr int shown_rows = 8;

/// Whole lines of the start of a file. Throws InputError if it is unreadable.
std::string head_of(const std::filesystem::path& file) {
  TraceText text(file, nullptr);
  std::string head(text.head().substr(0, looked_at));
  const auto end = head.rfind('\n');
  if (head.size() == looked_at && end != std::string::npos) {
    head.resize(end + 1);
  }
  return head;
}

}  // namespace

TraceImportDialog::TraceImportDialog(const std::filesystem::path& file, const std::string& columns,
                                     const QString& reason, QWidget* parent)
    : QDialog(parent),
      name_(to_qstring(file.filename()).toStdString()),
      head_(head_of(file)),
      presets_(new QComboBox(this)),
      keep_(new QPushButton(tr("&Keep as …"), this)),
      forget_(new QPushButton(tr("&Forget"), this)),
      preview_(new QTableWidget(this)),
      fields_(new TraceImportFields(this)),
      outcome_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("Import trace"));
  constexpr QSize usual(760, 600);
  resize(usual);
  auto* asked = new QLabel(this);
  asked->setWordWrap(true);
  asked->setText(reason.isEmpty()
                     ? tr("What are the columns of %1?").arg(to_qstring(file.filename()))
                     : tr("%1: %2. What are its columns?")
                           .arg(to_qstring(file.filename()), without_columns_option(reason, QString())));
  presets_->setAccessibleName(tr("Preset"));
  keep_->setToolTip(tr("Keep what is chosen under a name, for other traces of this kind"));
  forget_->setToolTip(tr("Remove this preset from the list"));
  preview_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  preview_->setSelectionMode(QAbstractItemView::NoSelection);
  preview_->verticalHeader()->hide();
  preview_->setAccessibleName(tr("First rows of the file"));
  outcome_->setWordWrap(true);
  auto* top = new QHBoxLayout;
  auto* label = new QLabel(tr("&Preset:"), this);
  label->setBuddy(presets_);
  top->addWidget(label);
  top->addWidget(presets_, 1);
  top->addWidget(keep_);
  top->addWidget(forget_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(asked);
  layout->addLayout(top);
  layout->addWidget(preview_, 1);
  layout->addWidget(fields_);
  layout->addWidget(outcome_);
  layout->addWidget(buttons_);

  list_presets();
  show_rows();  // the fields know the columns
  if (!columns.empty()) {
    fields_->set_columns(parse_trace_columns(columns));
  }
  connect(presets_, &QComboBox::activated, this, &TraceImportDialog::use_preset);
  connect(keep_, &QPushButton::clicked, this, &TraceImportDialog::ask_name);
  connect(forget_, &QPushButton::clicked, this, [this] {
    forget_trace_preset(presets_->currentText());
    list_presets();
    refresh();
  });
  connect(fields_, &TraceImportFields::changed, this, &TraceImportDialog::refresh);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  refresh();
}

QString TraceImportDialog::specification() const {
  return fields_->specification();
}

QString TraceImportDialog::outcome() const {
  return outcome_->text();
}

void TraceImportDialog::list_presets() {
  presets_->clear();
  presets_->addItem(tr("none"));
  for (const KeptTracePreset& preset : kept_trace_presets()) {
    presets_->addItem(preset.name, preset.specification);
    presets_->setItemData(presets_->count() - 1, preset.own, Qt::UserRole + 1);
  }
}

void TraceImportDialog::use_preset(int index) {
  const QString specification = presets_->itemData(index).toString();
  try {
    fields_->set_columns(specification.isEmpty() ? TraceColumns()
                                                 : parse_trace_columns(specification.toStdString()));
  } catch (const InputError&) {
    // a damaged saved preset changes nothing
  }
  refresh();
}

QString TraceImportDialog::keep_as(const QString& name) {
  if (specification().isEmpty()) {
    return tr("Nothing is chosen: there is nothing to keep.");
  }
  if (!keep_trace_preset(name, specification())) {
    return tr("Choose another name: it is empty, or that of a preset of the program.");
  }
  list_presets();
  presets_->setCurrentText(name.trimmed());
  refresh();
  return {};
}

void TraceImportDialog::ask_name() {
  QString problem;
  QString name;
  do {
    bool accepted = false;
    const QString asked = tr("Name of the preset:");
    name = QInputDialog::getText(this, tr("Keep preset"),
                                 problem.isEmpty() ? asked : problem + QStringLiteral("\n\n") + asked,
                                 QLineEdit::Normal, name, &accepted);
    if (!accepted) {
      return;
    }
    problem = keep_as(name);
  } while (!problem.isEmpty());
}

/// Shows the file's rows, separated as chosen; false if it has no table.
bool TraceImportDialog::show_rows() {
  try {
    const QString chosen = specification();
    const TraceColumns columns =
        chosen.isEmpty() ? TraceColumns() : parse_trace_columns(chosen.toStdString());
    const TableHead table = find_table(head_, name_, columns);
    std::size_t widest = table.titles.size();
    for (const auto& row : table.rows) {
      widest = std::max(widest, row.size());
    }
    std::vector<QString> titles(widest);
    for (std::size_t i = 0; i < table.titles.size(); ++i) {
      titles[i] = QString::fromStdString(table.titles[i]);
    }
    fields_->set_titles(titles);
    preview_->setColumnCount(static_cast<int>(widest));
    preview_->setRowCount(std::min<int>(shown_rows, static_cast<int>(table.rows.size())));
    const QLocale locale;
    constexpr int digits = 10;
    for (int column = 0; column < preview_->columnCount(); ++column) {
      const QString title = titles[static_cast<std::size_t>(column)];
      const QString number = locale.toString(column + 1);
      preview_->setHorizontalHeaderItem(
          column, new QTableWidgetItem(title.isEmpty() ? number : number + QStringLiteral(": ") + title));
      for (int row = 0; row < preview_->rowCount(); ++row) {
        const auto& fields = table.rows[static_cast<std::size_t>(row)];
        const auto at = static_cast<std::size_t>(column);
        const bool known = at < fields.size() && fields[at].has_value();
        auto* item = new QTableWidgetItem(known ? locale.toString(fields[at].value_or(0), 'g', digits)
                                                : QStringLiteral("–"));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        preview_->setItem(row, column, item);
      }
    }
    preview_->resizeColumnsToContents();
    return true;
  } catch (const InputError& error) {
    preview_->setRowCount(0);
    outcome_->setText(failure_text(error));
    return false;
  }
}

void TraceImportDialog::refresh() {
  forget_->setEnabled(presets_->currentData(Qt::UserRole + 1).toBool());
  bool good = show_rows();
  if (good) {
    try {
      const QString chosen = specification();
      const Trace trace = parse_trace(
          head_, name_, chosen.isEmpty() ? TraceColumns() : parse_trace_columns(chosen.toStdString()));
      const QLocale locale;
      const bool has_rate = trace.clock == TraceClock::times || trace.clock == TraceClock::option;
      QStringList parts{has_rate
                            ? tr("One sample each %1 ms").arg(locale.toString(1000 * trace.period, 'g', 4))
                            : tr("One sample each servo period of the machine")};
      for (std::size_t axis = 0; axis < trace.place.size(); ++axis) {
        if (trace.has(axis)) {
          const auto [low, high] = std::ranges::minmax_element(trace.place[axis]);
          parts.append(tr("%1 from %2 to %3")
                           .arg(QString(QLatin1Char("XYZ"[axis])), number_text(*low, Dimension::length),
                                amount_text(*high, Dimension::length)));
        }
      }
      outcome_->setText(tr("In the first %1 samples: %2.")
                            .arg(locale.toString(static_cast<qulonglong>(trace.size())), parts.join(", ")));
    } catch (const InputError& error) {
      good = false;
      outcome_->setText(failure_text(error));
    }
  }
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(good);
}

}  // namespace feedscope::ui
