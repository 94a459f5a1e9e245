#include "ui/lessons/tries_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QResizeEvent>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "core/base/typed_number.h"
#include "ui/fields/focus_outline.h"
#include "ui/language/core_texts.h"
#include "ui/language/signed_number.h"
#include "ui/language/texts.h"
#include "ui/lessons/lesson_tries.h"
#include "ui/shared/row_copy.h"
#include "ui/shared/table_items.h"

namespace feedscope::ui {

namespace {

constexpr int heading_letters = 11;  // in a line

/// "peak feed,", "line 16", "[m/min]".
QString heading(const QString& title, const QString& unit) {
  QStringList lines;
  for (const QString& word : title.split(' ')) {
    if (!lines.isEmpty() && lines.last().size() + word.size() < heading_letters) {
      lines.last() += ' ' + word;
    } else {
      lines.append(word);
    }
  }
  if (!unit.isEmpty()) {
    lines.append(QStringLiteral("[%1]").arg(unit));
  }
  return lines.join('\n');
}

QString change_text(const std::optional<double>& percent) {
  return percent ? signed_number(*percent, 1) : QStringLiteral("–");
}

/// Draws the change below its number where its own column has no room.
class PairedDelegate : public QStyledItemDelegate {
 public:
  explicit PairedDelegate(QTableView& table) : QStyledItemDelegate(&table), table_(table) {}

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const QModelIndex change = index.siblingAtColumn(index.column() + 1);
    if (index.column() > 0 && change.isValid() && table_.isColumnHidden(change.column()) &&
        !change.data().toString().isEmpty()) {
      const QString text = change.data().toString();
      option->text +=
          QChar(QChar::LineSeparator) + (index.row() == 0 ? text : QStringLiteral("%1 %").arg(text));
    }
  }

 private:
  QTableView& table_;
};

std::optional<double> measured_change(const LessonTry& one, const LessonTry& first) {
  return one.measured && first.measured ? change_percent(*one.measured, *first.measured) : std::nullopt;
}

}  // namespace

QString control_value_text(const std::string& value) {
  const auto number = typed_number(value).value;
  return number ? QLocale().toString(*number, 'g', QLocale::FloatingPointShortest) : core_text(value);
}

TriesTable::TriesTable(QWidget* parent) : QTableWidget(parent) {
  setAccessibleName(tr("Values tried"));
  setFrameShape(QFrame::NoFrame);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setTextElideMode(Qt::ElideMiddle);
  setWordWrap(false);
  horizontalHeader()->setHighlightSections(false);
  setItemDelegate(new PairedDelegate(*this));
  install_row_copy(*this);
  new FocusOutline(*this);
}

void TriesTable::show_work(const Question& question, const QString& watched, const QuestionWork& work) {
  const bool of_time = watched_name(question.watch) == cycle_time_name;
  const MeasureSpec& spec = *question.watch.spec;
  QStringList headings{heading(setting_title(question.control.key), setting_unit(question.control.key)),
                       heading(tr("cycle time"), tr("s")), heading(tr("change"), QStringLiteral("%"))};
  if (!of_time) {
    headings += {heading(watched, QString::fromStdString(spec.unit)), headings.last()};
  }
  setColumnCount(static_cast<int>(headings.size()));
  setHorizontalHeaderLabels(headings);
  setRowCount(static_cast<int>(work.tries.size()));
  constexpr int time_decimals = 3;
  int row = 0;
  for (const LessonTry& one : work.tries) {
    const LessonTry& first = work.tries.front();
    const auto change = [&](const std::optional<double>& percent) {
      return row > 0 ? change_text(percent) : tr("reference");
    };
    QStringList cells{control_value_text(one.value), QLocale().toString(one.cycle_time, 'f', time_decimals),
                      change(change_percent(one.cycle_time, first.cycle_time))};
    if (!of_time) {
      cells += {one.measured ? QLocale().toString(*one.measured, 'f', spec.decimals) : QStringLiteral("–"),
                change(measured_change(one, first))};
    }
    for (int column = 0; column < cells.size(); ++column) {
      QTableWidgetItem* cell = fixed_item(cells[column]);
      cell->setToolTip(cells[column]);
      if (column > 0) {
        cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      }
      setItem(row, column, cell);
    }
    ++row;
  }
  setVisible(row > 0);
  fit_columns();
}

void TriesTable::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) {
    QTimer::singleShot(0, this, &TriesTable::fit_columns);
  }
}

void TriesTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) {
    fit_columns();
  }
}

void TriesTable::fit_columns() {
  constexpr int least_letters = 10;
  const auto show_changes = [this](bool shown) {
    for (int column = 2; column < columnCount(); column += 2) {
      setColumnHidden(column, !shown);
    }
    resizeColumnsToContents();
  };
  const auto room_for_values = [this] {
    int room = viewport()->width();
    for (int column = 1; column < columnCount(); ++column) {
      room -= columnWidth(column);
    }
    return room;
  };
  if (columnCount() > 0) {
    const int least = least_letters * fontMetrics().averageCharWidth();
    show_changes(true);
    if (room_for_values() < std::min(least, columnWidth(0))) {
      show_changes(false);
    }
    setColumnWidth(0, std::clamp(room_for_values(), least, std::max(least, columnWidth(0))));
  }
  fit_height();
}

void TriesTable::fit_height() {
  resizeRowsToContents();
  int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
  for (int row = 0; row < rowCount(); ++row) {
    height += rowHeight(row);
  }
  const bool wide = horizontalHeader()->length() > viewport()->width();
  setFixedHeight(height + (wide ? horizontalScrollBar()->sizeHint().height() : 0));
}

}  // namespace feedscope::ui
