#include "ui/program_text/work_offsets_table.h"

#include <QHeaderView>
#include <cmath>
#include <optional>

#include "ui/fields/number_text.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/table_items.h"

namespace feedscope::ui {

namespace {

constexpr double farthest = 1e6;  // [mm]

enum OffsetColumn { name_column, first_axis_column, use_column = first_axis_column + 3, offset_column_count };

/// None for a text that is not a coordinate.
std::optional<double> coordinate_of(const QString& text) {
  const std::optional<double> value = number_of(text);
  return value && std::abs(*value) <= farthest ? value : std::nullopt;
}

}  // namespace

WorkOffsetsTable::WorkOffsetsTable(const WorkOffsets& given, const Program* program, QWidget* parent)
    : QTableWidget(parent) {
  setAccessibleName(tr("Work offsets"));
  setColumnCount(offset_column_count);
  setHorizontalHeaderLabels({tr("Offset"), with_unit_of("X", Dimension::length),
                             with_unit_of("Y", Dimension::length), with_unit_of("Z", Dimension::length),
                             tr("Use")});
  verticalHeader()->hide();
  horizontalHeader()->setStretchLastSection(true);
  WorkOffsets others = given;
  for (const OffsetUse& use : program == nullptr ? std::vector<OffsetUse>() : program->work_offsets) {
    const auto own = given.all().find(use.name);
    const bool is_own = own != given.all().end();
    const QString motions = tr("from line %1, motions: %2").arg(use.line).arg(use.blocks);
    add(use.name, is_own ? &own->second : nullptr,
        is_own || use.given ? motions : tr("%1; assumed as zero").arg(motions));
    others.erase(use.name);
  }
  for (const auto& [name, zero] : others.all()) {
    add(name, &zero, tr("set here, not used by the program"));
  }
}

void WorkOffsetsTable::add(const std::string& name, const Vec3* zero, const QString& use) {
  const int row = rowCount();
  insertRow(row);
  setItem(row, name_column, fixed_item(QString::fromStdString(name)));
  for (int axis = 0; axis < 3; ++axis) {
    auto* cell = new QTableWidgetItem(
        zero == nullptr ? QString() : editable_text(in_shown_unit((*zero)[axis], Dimension::length)));
    cell->setToolTip(
        tr("Zero point of the offset in the coordinates shown; empty: as programmed, otherwise 0"));
    setItem(row, first_axis_column + axis, cell);
  }
  setItem(row, use_column, fixed_item(use));
}

WorkOffsets WorkOffsetsTable::offsets() const {
  WorkOffsets offsets;
  for (int row = 0; row < rowCount(); ++row) {
    Vec3 zero = Vec3::Zero();
    bool any = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (const auto value = coordinate_of(item(row, first_axis_column + axis)->text())) {
        zero[axis] = from_shown_unit(*value, Dimension::length);
        any = true;
      }
    }
    if (any) {
      offsets.set(item(row, name_column)->text().toStdString(), zero);
    }
  }
  return offsets;
}

QString WorkOffsetsTable::fault() const {
  for (int row = 0; row < rowCount(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      const QString text = item(row, first_axis_column + axis)->text();
      if (!text.trimmed().isEmpty() && !coordinate_of(text)) {
        return tr("The %1 coordinate of work offset %2, \"%3\", is not a number from -1000000 to 1000000.")
            .arg(QChar(coordinate_names[static_cast<std::size_t>(axis)]))
            .arg(item(row, name_column)->text(), text);
      }
    }
  }
  return {};
}

void WorkOffsetsTable::clear_offsets() {
  for (int row = 0; row < rowCount(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      item(row, first_axis_column + axis)->setText({});
    }
  }
}

}  // namespace feedscope::ui
