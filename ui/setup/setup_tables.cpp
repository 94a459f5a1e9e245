#include "ui/setup/setup_tables.h"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <cmath>

#include "core/base/error.h"
#include "core/machine/key_unit.h"
#include "core/toolpath/turn_limiter.h"
#include "ui/fields/choice_delegate.h"
#include "ui/fields/number_text.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

namespace {

/// A number with fewer digits if it was converted.
QString plain_number(double number, double factor) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number * factor, 'g', factor == 1 ? 7 : 5);
}

QString value_text(const SettingValue& value, const SettingSpec& spec) {
  if (const auto* number = std::get_if<double>(&value)) {
    return plain_number(*number, key_unit(spec.unit).factor);
  }
  return core_text(std::get<std::string>(value));
}

/// A bound as written in a file, without an exponent.
QString bound_text(double bound, double factor) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return factor == 1 ? locale.toString(bound, 'f', QLocale::FloatingPointShortest)
                     : plain_number(bound, factor);
}

QString range_text(const SettingSpec& spec) {
  const auto text_of = [factor = key_unit(spec.unit).factor](double bound) {
    return bound_text(bound, factor);
  };
  if (!spec.choices.empty()) {
    return SetupTable::tr("choice");
  }
  constexpr double beyond = 1e9;  // a bound far from any value is not informative
  if (spec.maximum >= beyond) {
    return QStringLiteral("%1 %2").arg(spec.minimum_allowed ? "≥" : ">", text_of(spec.minimum));
  }
  if (spec.minimum == -spec.maximum && spec.minimum_allowed) {
    return QStringLiteral("± %1").arg(text_of(spec.maximum));
  }
  return QStringLiteral("%1%2 … %3")
      .arg(spec.minimum_allowed ? "" : "> ", text_of(spec.minimum), text_of(spec.maximum));
}

/// "= 0.51 g" for a value that data sheets often give in another unit; "" otherwise.
QString data_sheet_text(const SettingValue& value, const SettingSpec& spec) {
  const DataSheetUnit other = data_sheet_unit(spec.unit);
  const auto* number = std::get_if<double>(&value);
  constexpr int digits = 4;
  return number == nullptr || other.name.empty()
             ? QString()
             : QStringLiteral(" = %1 %2")
                   .arg(QLocale().toString(*number / other.factor, 'g', digits),
                        QString::fromUtf8(other.name.data(), qsizetype(other.name.size())));
}

/// Whether a default applies without a value and is shown instead.
bool has_usual_value(const SettingSpec& spec) {
  return spec.optional && spec.fallback > 0;
}

/// An error with title and unit as in the table.
QString shown_problem(const InputError& error, const std::string& key, const std::string& unit) {
  QString text = failure_text(error);
  text.replace(QString::fromStdString(key), setting_title(key));
  return unit.empty()
             ? text
             : text.replace(QString::fromStdString(" " + unit), QStringLiteral(" ") + unit_text(unit));
}

}  // namespace

QStringList changes_of(const SetupState& state) {
  QStringList lines;
  for (const auto& [key, value] : state.edits()) {
    const SettingSpec spec = state.spec(key);
    lines.append(QStringLiteral("%1: %2 → %3 %4")
                     .arg(setting_title(key), value_text(state.file_value(key), spec),
                          value_text(value, spec), key_unit(spec.unit).text)
                     .trimmed());
  }
  return lines;
}

SetupTable::SetupTable(SetupEdit& edit, QObject* parent)
    : QAbstractTableModel(parent), edit_(edit), state_(edit.state()) {
  connect(&edit_, &SetupEdit::values_changed, this, [this] {
    state_ = edit_.state();
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  });
  connect(&edit_, &SetupEdit::keys_changed, this, [this] {
    beginResetModel();
    state_ = edit_.state();
    reload();
    endResetModel();
  });
}

QVariant SetupTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  if (role == Qt::ToolTipRole) {
    return explanation(topic_of(index));
  }
  const std::optional<std::string> key = key_at(index);
  if (!key.has_value()) {
    return role == Qt::DisplayRole ? caption(index) : QVariant();
  }
  const SettingSpec spec = state_.spec(*key);
  const bool of_axis = key->find('.') != std::string::npos;
  const bool usual = !of_axis && has_usual_value(spec) && state_.value(*key) == SettingValue(std::string());
  switch (role) {
    case Qt::DisplayRole:
      return value_text(usual ? SettingValue(spec.fallback) : state_.value(*key), spec);
    case Qt::EditRole:
      return value_text(state_.value(*key), spec);
    case Qt::ForegroundRole:
      return usual ? QVariant(QGuiApplication::palette().brush(QPalette::PlaceholderText)) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font;
      font.setBold(state_.edited(*key));
      font.setItalic(state_.provenance(*key).assumed);
      return font;
    }
    case ChoiceDelegate::choices_role: {
      QStringList choices;
      for (const std::string& choice : spec.choices) {
        choices.append(core_text(choice));
      }
      return choices;
    }
    default:
      return {};
  }
}

bool SetupTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) || !key_at(index)) {
    return false;
  }
  const std::string key = *key_at(index);
  if (value.toString() == value_text(state_.value(key), state_.spec(key))) {
    return true;  // keeps a number from being replaced by its rounded text
  }
  const SettingSpec spec = state_.spec(key);
  try {
    const QString text = value.toString().trimmed();
    const auto choice = std::ranges::find(spec.choices, text, core_text);
    const auto number = spec.choices.empty() ? number_of(text) : std::nullopt;
    edit_.set(key, number                         ? SettingValue(*number / key_unit(spec.unit).factor)
                   : choice != spec.choices.end() ? SettingValue(*choice)
                                                  : parse_setting(spec, text.toStdString()));
    return true;
  } catch (const InputError& error) {
    emit refused(index, shown_problem(error, key, spec.unit));
    return false;
  }
}

Qt::ItemFlags SetupTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() && key_at(index).has_value() ? flags | Qt::ItemIsEditable : flags;
}

QString SetupTable::explanation(const std::string& key) const {
  const SettingSpec spec = state_.spec(key);
  const Provenance provenance = state_.provenance(key);
  QStringList lines;
  lines.append(
      QStringLiteral("<b>%1</b>%2")
          .arg(core_text(spec.title).toHtmlEscaped(),
               spec.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(key_unit(spec.unit).text)));
  if (const QString other = data_sheet_text(state_.value(key), spec); !other.isEmpty()) {
    lines.append(value_text(state_.value(key), spec) + QLatin1Char(' ') + key_unit(spec.unit).text + other);
  }
  lines.append(core_text(spec.explanation).toHtmlEscaped());
  if (spec.choices.empty()) {
    lines.append(tr("Range: %1").arg(range_text(spec)));
  }
  if (state_.edited(key)) {
    lines.append(tr("Changed; the machine file has %1.").arg(value_text(state_.file_value(key), spec)));
  }
  const QString source = QString::fromStdString(provenance.source).toHtmlEscaped();
  if (source.isEmpty() && spec.optional) {
    lines.append(tr("The machine file gives no value."));
  } else if (source.isEmpty()) {
    lines.append(tr("Source: default of the model; the machine file gives none."));
  } else {
    lines.append(provenance.assumed ? tr("Assumed: %1").arg(source) : tr("Source: %1").arg(source));
  }
  return QStringLiteral("<p>%1</p>").arg(lines.join("<br>"));
}

AxisTable::AxisTable(SetupEdit& edit, const std::vector<SettingSpec>& specs, QObject* parent)
    : SetupTable(edit, parent), specs_(specs) {}

QModelIndex AxisTable::index_of(const std::string& key) const {
  for (int row = 0; row < rowCount(); ++row) {
    for (int column = 0; column < columnCount(); ++column) {
      if (topic_of(index(row, column)) == key) {
        return index(row, column);
      }
    }
  }
  return {};
}

bool AxisTable::has_values() const {
  for (const AxisInfo& axis : axes()) {
    for (const SettingSpec& spec : specs_) {
      if (state().value(axis_key(axis.name, spec.key)) != SettingValue(std::string())) {
        return true;
      }
    }
  }
  return false;
}

const AxisList& AxisTable::axes() const {
  return state().file().machine.axes.axes();
}

int AxisTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(specs_.size());
}

int AxisTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(axes().size());
}

QVariant AxisTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || section < 0) {
    return {};
  }
  const auto i = static_cast<std::size_t>(section);
  if (orientation == Qt::Horizontal) {
    return i < axes().size() ? QString(QChar(axes()[i].name)) : QVariant();
  }
  if (i >= specs_.size()) {
    return {};
  }
  const SettingSpec& spec = specs_[i];
  return spec.unit.empty() ? core_text(spec.title)
                           : QStringLiteral("%1 [%2]").arg(core_text(spec.title), key_unit(spec.unit).text);
}

std::optional<std::string> AxisTable::key_at(const QModelIndex& index) const {
  return topic_of(index);
}

std::string AxisTable::topic_of(const QModelIndex& index) const {
  return axis_key(axes()[static_cast<std::size_t>(index.column())].name,
                  specs_[static_cast<std::size_t>(index.row())].key);
}

SettingsTable::SettingsTable(SetupEdit& edit, QObject* parent) : SetupTable(edit, parent) {
  reload();
}

void SettingsTable::reload() {
  specs_ = settings_of(*state().file().model);
  if (state().file().machine.kinematics.empty()) {
    std::erase_if(specs_, [](const SettingSpec& spec) { return is_rotary_setting(spec.key); });
  }
}

int SettingsTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(specs_.size());
}

int SettingsTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant SettingsTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal) {
    return {};
  }
  switch (section) {
    case title:
      return tr("Setting");
    case value:
      return tr("Value");
    case unit:
      return tr("Unit");
    case range:
      return tr("Range");
    default:
      return {};
  }
}

int SettingsTable::row_of(const std::string& key) const {
  const auto found = std::ranges::find(specs_, key, &SettingSpec::key);
  return found == specs_.end() ? -1 : static_cast<int>(found - specs_.begin());
}

bool SettingsTable::is_unset(int row) const {
  const SettingSpec& spec = specs_[static_cast<std::size_t>(row)];
  return spec.optional && !has_usual_value(spec) && state().value(spec.key) == SettingValue(std::string());
}

std::optional<std::string> SettingsTable::key_at(const QModelIndex& index) const {
  return index.column() == value ? std::optional(topic_of(index)) : std::nullopt;
}

std::string SettingsTable::topic_of(const QModelIndex& index) const {
  return specs_[static_cast<std::size_t>(index.row())].key;
}

QString SettingsTable::caption(const QModelIndex& index) const {
  const SettingSpec& spec = specs_[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case title:
      return core_text(spec.title);
    case unit:
      return key_unit(spec.unit).text;
    case range:
      return range_text(spec);
    default:
      return {};
  }
}

}  // namespace feedscope::ui
