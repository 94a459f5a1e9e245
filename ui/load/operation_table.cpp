#include "ui/load/operation_table.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "core/load/load_keys.h"
#include "core/program/tools/cutter_radii.h"
#include "ui/fields/choice_delegate.h"
#include "ui/fields/number_text.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

constexpr double new_diameter = 10;     // [mm]
constexpr double new_radial_depth = 1;  // [mm]
constexpr double new_axial_depth = 5;   // [mm]
constexpr double most_teeth = 200;
constexpr int digits = 6;

/// Display of a number of operations, in the order of operation_keys.
struct NumberColumn {
  const char* title;
  const char* tip;
  Dimension dimension;
};
constexpr std::array<NumberColumn, operation_keys.size()> number_columns{{
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Diameter"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Diameter of the tool, a cylindrical end mill"),
     Dimension::length},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Helix"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Helix angle of the cutting edges"),
     Dimension::angle},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Radial depth"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Radial depth of cut a_e, up to the diameter (slot); as given, it is not simulated "
                       "along the path"),
     Dimension::length},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Axial depth"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Axial depth of cut a_p"), Dimension::length},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Spindle [1/min]"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Spindle speed where the program gives none; may be empty"),
     Dimension::number},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Least chip"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Chip thickness below which the edge rubs; places below it are listed; may be empty"),
     Dimension::error},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Max. chip"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Largest chip thickness allowed; places above it are listed; may be empty"),
     Dimension::error},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Max. force"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Largest peak force allowed; places above it are listed; may be empty"),
     Dimension::force},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Max. torque"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Largest torque allowed; places above it are listed; may be empty"),
     Dimension::torque},
    {QT_TRANSLATE_NOOP("feedscope::ui::OperationTable", "Max. power"),
     QT_TRANSLATE_NOOP("feedscope::ui::OperationTable",
                       "Largest power allowed; places above it are listed; may be empty"),
     Dimension::power},
}};

const OperationKey& key_at(int column) {
  return operation_keys[static_cast<std::size_t>(column - OperationTable::first_number)];
}

const NumberColumn& number_column(int column) {
  return number_columns[static_cast<std::size_t>(column - OperationTable::first_number)];
}

/// The shown number for a core value; value_of() is the inverse.
double shown_number(double value, int column) {
  const NumberColumn& info = number_column(column);
  return info.dimension == Dimension::number ? key_at(column).unit.to_unit(value)
                                             : in_shown_unit(value, info.dimension);
}
double value_of(double number, int column) {
  const NumberColumn& info = number_column(column);
  return info.dimension == Dimension::number ? key_at(column).unit.to_internal(number)
                                             : from_shown_unit(number, info.dimension);
}

QString number_in_cell(double number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number, 'g', digits);
}

std::optional<double> number_at(const Engagement& operation, int column) {
  const OperationKey& key = key_at(column);
  return key.needed != nullptr ? std::optional(operation.*key.needed) : operation.*key.given;
}

}  // namespace

OperationTable::OperationTable(QObject* parent)
    : QAbstractTableModel(parent), materials_(shipped_materials()) {}

void OperationTable::set_setup(LoadSetup setup) {
  beginResetModel();
  setup_ = std::move(setup);
  endResetModel();
}

void OperationTable::set_program(std::shared_ptr<const Program> program) {
  program_ = std::move(program);
}

QStringList OperationTable::tools() const {
  QStringList names;
  if (program_ != nullptr) {
    for (const ToolChange& change : program_->tools) {
      names.append(QString::fromStdString(CutterRadii::key(change.name)));
    }
  }
  names.removeDuplicates();
  return names;
}

void OperationTable::add() {
  Engagement operation;
  const auto is_free = [this](const QString& name) {
    return std::ranges::find(setup_.operations, name.toStdString(), &Engagement::tool) ==
           setup_.operations.end();
  };
  const QStringList names = tools();
  if (const auto name = std::ranges::find_if(names, is_free); name != names.end()) {
    operation.tool = name->toStdString();
  }
  operation.diameter = new_diameter;
  if (program_ != nullptr) {
    const auto cutter = std::ranges::find(program_->cutters, operation.tool, &CutterUse::tool);
    if (cutter != program_->cutters.end() && cutter->radius > 0) {
      operation.diameter = 2 * cutter->radius;
    }
  }
  operation.teeth = 2;
  operation.helix = units::from_deg(30);
  operation.radial_depth = std::min(new_radial_depth, operation.diameter);
  operation.axial_depth = new_axial_depth;
  operation.material = materials_.front().id;
  const auto row = static_cast<int>(setup_.operations.size());
  beginInsertRows({}, row, row);
  setup_.operations.push_back(std::move(operation));
  endInsertRows();
  emit edited();
}

void OperationTable::remove(int row) {
  beginRemoveRows({}, row, row);
  setup_.operations.erase(setup_.operations.begin() + row);
  endRemoveRows();
  emit edited();
}

int OperationTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(setup_.operations.size());
}

int OperationTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : first_number + static_cast<int>(operation_keys.size());
}

QString OperationTable::text(const Engagement& operation, int column) const {
  switch (column) {
    case tool:
      return operation.tool.empty() ? tr("all tools") : QString::fromStdString(operation.tool);
    case lines:
      return QString::fromStdString(ranges_text(operation.lines));
    case teeth:
      return QString::number(operation.teeth);
    case milling:
      return operation.milling == Milling::up ? tr("up (conventional)") : tr("down (climb)");
    case material: {
      const Material* known = material_with(operation.material, &Material::id);
      return QString::fromStdString(known != nullptr ? known->title : operation.material);
    }
    default: {
      const std::optional<double> value = number_at(operation, column);
      return value ? number_in_cell(shown_number(*value, column)) : QString();
    }
  }
}

const Material* OperationTable::material_with(const std::string& value, std::string Material::*member) const {
  for (const auto* list : {&setup_.materials, &materials_}) {
    if (const auto found = std::ranges::find(*list, value, member); found != list->end()) {
      return &*found;
    }
  }
  return nullptr;
}

QStringList OperationTable::choices(int column) const {
  switch (column) {
    case tool:
      return tools() << tr("all tools");
    case milling:
      return {tr("down (climb)"), tr("up (conventional)")};
    case material: {
      QStringList titles;
      for (const auto* list : {&setup_.materials, &materials_}) {
        for (const Material& each : *list) {
          titles.append(QString::fromStdString(each.title));
        }
      }
      titles.removeDuplicates();
      return titles;
    }
    default:
      return {};
  }
}

QVariant OperationTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const Engagement& operation = setup_.operations[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(operation, index.column());
    case ChoiceDelegate::choices_role:
      return choices(index.column());
    case Qt::TextAlignmentRole:
      return QVariant(
          Qt::AlignVCenter |
          (index.column() == teeth || index.column() >= first_number ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::ToolTipRole:
      if (const Material* known = material_with(operation.material, &Material::id);
          index.column() == material && known != nullptr) {
        return QString::fromStdString(known->source);
      }
      return headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole);
    default:
      return {};
  }
}

QString OperationTable::take_number(Engagement& operation, int column, const QString& text) const {
  const OperationKey& key = key_at(column);
  if (text.trimmed().isEmpty() && key.given != nullptr) {
    (operation.*key.given).reset();
    return {};
  }
  const std::optional<double> number = number_of(text);
  if (!number) {
    return number_problem(text);
  }
  const double value = value_of(*number, column);
  const double in_file = key.unit.to_unit(value);
  if (in_file > key.most || in_file < key.least || (in_file == key.least && !key.least_allowed)) {
    const QString least = number_in_cell(shown_number(key.unit.to_internal(key.least), column));
    const QString most = number_in_cell(shown_number(key.unit.to_internal(key.most), column));
    return key.least_allowed ? tr("must be from %1 to %2").arg(least, most)
                             : tr("must be above %1 and at most %2").arg(least, most);
  }
  if (key.needed != nullptr) {
    operation.*key.needed = value;
  } else {
    operation.*key.given = value;
  }
  return {};
}

QString OperationTable::take(Engagement& operation, int column, const QString& text) const {
  switch (column) {
    case tool:
      operation.tool = text == tr("all tools") ? "" : CutterRadii::key(text.trimmed().toStdString());
      return {};
    case lines: {
      if (text.trimmed().isEmpty()) {
        operation.lines.clear();
        return {};
      }
      const auto ranges = ranges_of(text.toStdString());
      operation.lines = ranges.value_or(operation.lines);
      return ranges ? QString() : tr("must be ranges of lines, such as 10-25, 40-52; or empty");
    }
    case teeth: {
      const std::optional<double> number = number_of(text);
      if (!number || *number != std::floor(*number) || *number < 1 || *number > most_teeth) {
        return tr("must be a whole number from 1 to %1").arg(most_teeth);
      }
      operation.teeth = static_cast<int>(*number);
      return {};
    }
    case milling:
      operation.milling = text == tr("up (conventional)") ? Milling::up : Milling::down;
      return {};
    case material: {
      const Material* known = material_with(text.toStdString(), &Material::title);
      operation.material = known != nullptr ? known->id : operation.material;
      return known != nullptr ? QString() : tr("is not known");
    }
    default:
      return take_number(operation, column, text);
  }
}

bool OperationTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return false;
  }
  Engagement& operation = setup_.operations[static_cast<std::size_t>(index.row())];
  const QString typed = value.toString();
  if (typed == text(operation, index.column())) {
    return true;  // the shown value is rounded
  }
  Engagement changed = operation;
  const QString problem = take(changed, index.column(), typed);
  if (!problem.isEmpty()) {
    emit refused(
        QStringLiteral("%1 \"%2\": %3")
            .arg(headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString(), typed, problem));
    return false;
  }
  operation = std::move(changed);
  emit dataChanged(index, index);
  emit edited();
  return true;
}

QVariant OperationTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  const bool title = role == Qt::DisplayRole;
  switch (section) {
    case tool:
      return title ? tr("Tool") : tr("As the program calls it");
    case lines:
      return title ? tr("Lines")
                   : tr("Where the operation applies, such as 10-25, 40-52; empty: wherever its tool cuts");
    case teeth:
      return title ? tr("Teeth") : tr("Number of cutting edges, equally spaced");
    case milling:
      return title
                 ? tr("Milling")
                 : tr("Up milling begins a chip thin, down milling thick: the side of the tool on which the "
                      "material is");
    case material:
      return title ? tr("Material") : tr("Coefficients of the cutting force; each with its source");
    default: {
      const NumberColumn& column = number_column(section);
      return title ? with_unit_of(tr(column.title), column.dimension) : tr(column.tip);
    }
  }
}

Qt::ItemFlags OperationTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace feedscope::ui
