#include "ui/trace/trace_import_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"

namespace feedscope::ui {

namespace {

constexpr double fastest_rate = 1e7;  // [Hz]
constexpr int most_skipped = 100000;  // lines
constexpr double farthest = 1e6;      // offset of an axis, in the unit of its column
constexpr int digits = 12;

QString key_of(TraceQuantity quantity) {
  const std::string_view key = to_string(quantity);
  return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

void choose(QComboBox& box, const QVariant& data) {
  box.setCurrentIndex(std::max(0, box.findData(data)));
}

}  // namespace

TraceImportFields::TraceImportFields(QWidget* parent)
    : QWidget(parent),
      separator_(add_choice({{tr("found"), ""},
                             {tr("comma"), "comma"},
                             {tr("semicolon"), "semicolon"},
                             {tr("tab"), "tab"},
                             {tr("blanks"), "blank"}})),
      decimal_(add_choice({{tr("found"), ""}, {tr("point"), "point"}, {tr("comma"), "comma"}})),
      rate_(new NumberBox(this)),
      skip_(new WholeNumberBox(this)) {
  rate_->setRange(0, fastest_rate);
  rate_->setDecimals(3);
  rate_->setSpecialValueText(tr("from the times or the machine"));
  rate_->setSuffix(QStringLiteral(" Hz"));
  rate_->setToolTip(tr("Samples a second, in place of the times of the file"));
  skip_->setRange(0, most_skipped);
  skip_->setToolTip(tr("Lines before the table that are not read"));
  connect(rate_, &NumberBox::valueChanged, this, &TraceImportFields::changed);
  connect(skip_, &WholeNumberBox::valueChanged, this, &TraceImportFields::changed);

  auto* grid = new QGridLayout;
  for (const auto& [column, title] :
       {std::pair{1, tr("Column")}, std::pair{2, tr("Unit")}, std::pair{4, tr("Offset")}}) {
    grid->addWidget(new QLabel(title, this), 0, column);
  }
  add_row(TraceQuantity::time, tr("Time"), *grid);
  add_row(TraceQuantity::number, tr("Sample number"), *grid);
  add_row(TraceQuantity::x, QStringLiteral("X"), *grid);
  add_row(TraceQuantity::y, QStringLiteral("Y"), *grid);
  add_row(TraceQuantity::z, QStringLiteral("Z"), *grid);
  add_row(TraceQuantity::line, tr("Program line"), *grid);
  add_row(TraceQuantity::feed, tr("Feed"), *grid);
  add_row(TraceQuantity::actual_x, tr("X actual"), *grid);
  add_row(TraceQuantity::actual_y, tr("Y actual"), *grid);
  add_row(TraceQuantity::actual_z, tr("Z actual"), *grid);
  grid->setColumnStretch(1, 1);

  auto* form = new QGridLayout;
  const std::array<std::pair<QString, QWidget*>, 4> others{{{tr("Columns parted by"), separator_},
                                                            {tr("Decimal mark"), decimal_},
                                                            {tr("Rate"), rate_},
                                                            {tr("Lines to skip"), skip_}}};
  for (int row = 0; const auto& [title, field] : others) {
    auto* label = new QLabel(title, this);
    label->setBuddy(field);
    field->setAccessibleName(title);
    form->addWidget(label, row, 0);
    form->addWidget(field, row++, 1);
  }
  form->setRowStretch(4, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(grid, 2);
  layout->addSpacing(16);
  layout->addLayout(form, 1);
}

/// Text and data of each choice.
QComboBox* TraceImportFields::add_choice(const std::vector<std::pair<QString, QString>>& choices) {
  auto* box = new QComboBox(this);
  for (const auto& [text, data] : choices) {
    box->addItem(text, data);
  }
  connect(box, &QComboBox::currentIndexChanged, this, &TraceImportFields::changed);
  return box;
}

void TraceImportFields::add_row(TraceQuantity quantity, const QString& title, QGridLayout& grid) {
  Row& row = rows_[static_cast<std::size_t>(quantity)];
  const int at = grid.rowCount();
  row.column = add_choice({{tr("found, if there is one"), ""}});
  row.column->setAccessibleName(tr("Column of %1").arg(title));
  // As wide as its first choice; titles of columns have any length.
  row.column->setMinimumContentsLength(static_cast<int>(row.column->itemText(0).size()));
  row.column->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* label = new QLabel(title, this);
  label->setBuddy(row.column);
  grid.addWidget(label, at, 0);
  grid.addWidget(row.column, at, 1);
  const QString units = QString::fromStdString(trace_units(quantity));
  if (units != QStringLiteral("none")) {
    std::vector<std::pair<QString, QString>> choices{{tr("as the title says"), ""}};
    for (const QString& unit : units.split(QStringLiteral(", "))) {
      choices.emplace_back(unit, unit);
    }
    row.unit = add_choice(choices);
    row.unit->setAccessibleName(tr("Unit of %1").arg(title));
    grid.addWidget(row.unit, at, 2);
  }
  if (is_position(quantity)) {
    row.mirrored = new QCheckBox(tr("mirrored"), this);
    row.mirrored->setToolTip(tr("The trace counts this axis in the other direction; needs a unit"));
    row.mirrored->setAccessibleName(tr("%1 mirrored").arg(title));
    connect(row.mirrored, &QCheckBox::toggled, this, &TraceImportFields::changed);
    grid.addWidget(row.mirrored, at, 3);
    row.offset = new NumberBox(this);
    row.offset->setRange(-farthest, farthest);
    row.offset->setDecimals(4);
    row.offset->setToolTip(
        tr("Added to the position, in the unit of the column. 0: what shifts the trace is "
           "found where nearly all of it fits the path then"));
    row.offset->setAccessibleName(tr("Offset of %1").arg(title));
    connect(row.offset, &NumberBox::valueChanged, this, &TraceImportFields::changed);
    grid.addWidget(row.offset, at, 4);
  }
}

void TraceImportFields::set_titles(const std::vector<QString>& titles) {
  if (titles == titles_) {
    return;
  }
  titles_ = titles;
  for (const Row& row : rows_) {
    const QSignalBlocker quiet(row.column);
    const QVariant chosen = row.column->currentData();
    while (row.column->count() > 1) {
      row.column->removeItem(1);
    }
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const QString number = QString::number(i + 1);
      row.column->addItem(titles[i].isEmpty() ? number : QStringLiteral("%1: %2").arg(number, titles[i]),
                          number);
    }
    choose(*row.column, chosen);
  }
}

void TraceImportFields::set_columns(const TraceColumns& columns) {
  const QSignalBlocker quiet(this);
  for (std::size_t q = 0; q < trace_quantity_count; ++q) {
    const Row& row = rows_[q];
    const auto& column = columns.columns[q];
    QString number;
    if (column) {
      const QString name = QString::fromStdString(column->column);
      const auto titled = std::ranges::find(titles_, name);
      number = titled == titles_.end() ? name : QString::number(titled - titles_.begin() + 1);
    }
    choose(*row.column, number);
    if (row.unit != nullptr) {
      choose(*row.unit, column && column->unit_given ? QString::fromStdString(column->unit) : QString());
    }
    if (row.mirrored != nullptr) {
      row.mirrored->setChecked(column && column->factor < 0);
      row.offset->setValue(column ? column->offset : 0);
    }
  }
  const char separator = columns.separator;
  choose(*separator_, QString(separator == '\t'  ? "tab"
                              : separator == ',' ? "comma"
                              : separator == ';' ? "semicolon"
                              : separator == ' ' ? "blank"
                                                 : ""));
  choose(*decimal_, QString(columns.decimal == '.' ? "point" : columns.decimal == ',' ? "comma" : ""));
  rate_->setValue(columns.period > 0 ? 1 / columns.period : 0);
  skip_->setValue(static_cast<int>(std::min<std::size_t>(columns.skip, most_skipped)));
}

QString TraceImportFields::specification() const {
  QStringList parts;
  for (std::size_t q = 0; q < trace_quantity_count; ++q) {
    const Row& row = rows_[q];
    const QString column = row.column->currentData().toString();
    if (column.isEmpty()) {
      continue;
    }
    QString part = key_of(static_cast<TraceQuantity>(q)) + '=' + column;
    QString unit = row.unit == nullptr ? QString() : row.unit->currentData().toString();
    const bool mirrored = row.mirrored != nullptr && row.mirrored->isChecked();
    if (mirrored && unit.isEmpty()) {
      unit = QStringLiteral("mm");
    }
    if (!unit.isEmpty()) {
      part += ':' + QString(mirrored ? "-" : "") + unit;
    }
    if (row.offset != nullptr && row.offset->value() != 0) {
      part += QString(unit.isEmpty() ? "::" : ":") + QString::number(row.offset->value(), 'g', digits);
    }
    parts.append(part);
  }
  for (const auto& [key, box] : {std::pair{"separator=", separator_}, std::pair{"decimal=", decimal_}}) {
    if (const QString word = box->currentData().toString(); !word.isEmpty()) {
      parts.append(key + word);
    }
  }
  if (rate_->value() > 0) {
    parts.append(QStringLiteral("rate=") + QString::number(rate_->value(), 'g', digits));
  }
  if (skip_->value() > 0) {
    parts.append(QStringLiteral("skip=") + QString::number(skip_->value()));
  }
  return parts.join(',');
}

}  // namespace feedscope::ui
