#include "ui/models/setup_tables.h"

#include <QFont>
#include <QLocale>
#include <cmath>

#include "core/base/error.h"
#include "ui/fields/number_text.h"
#include "ui/language/core_texts.h"
#include "ui/models/texts.h"

namespace feedscope::ui {

namespace {

QString number_text(double number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number, 'g', 7);
}

QString value_text(const SettingValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return number_text(*number);
  }
  return core_text(std::get<std::string>(value));
}

QString range_text(const SettingSpec& spec) {
  if (!spec.choices.empty()) {
    return SetupTable::tr("choice");
  }
  if (std::isinf(spec.maximum)) {
    return QStringLiteral("%1 %2").arg(spec.minimum_allowed ? "≥" : ">", number_text(spec.minimum));
  }
  if (spec.minimum == -spec.maximum && spec.minimum_allowed) {
    return QStringLiteral("± %1").arg(number_text(spec.maximum));
  }
  return QStringLiteral("%1%2 … %3")
      .arg(spec.minimum_allowed ? "" : "> ", number_text(spec.minimum), number_text(spec.maximum));
}

}  // namespace

QStringList changes_of(const SetupState& state) {
  QStringList lines;
  for (const auto& [key, value] : state.edits()) {
    const SettingSpec spec = state.spec(key);
    lines.append(QStringLiteral("%1: %2 → %3 %4")
                     .arg(setting_title(key), value_text(state.file_value(key)), value_text(value),
                          unit_text(spec.unit))
                     .trimmed());
  }
  return lines;
}

SetupTable::SetupTable(SetupEdit& edit, QObject* parent) : QAbstractTableModel(parent), edit_(edit) {
  connect(&edit_, &SetupEdit::values_changed, this,
          [this] { emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1)); });
  connect(&edit_, &SetupEdit::keys_changed, this, [this] {
    beginResetModel();
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
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return value_text(edit_.state().value(*key));
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font;
      font.setBold(edit_.state().edited(*key));
      font.setItalic(edit_.state().provenance(*key).assumed);
      return font;
    }
    case choices_role: {
      QStringList choices;
      for (const std::string& choice : edit_.state().spec(*key).choices) {
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
  if (value.toString() == value_text(edit_.state().value(key))) {
    return true;  // not to replace a number by its rounded text
  }
  try {
    const SettingSpec spec = edit_.state().spec(key);
    const QString text = value.toString().trimmed();
    const auto choice = std::ranges::find(spec.choices, text, core_text);
    const auto number = spec.choices.empty() ? number_of(text) : std::nullopt;
    edit_.set(key, number                         ? SettingValue(*number)
                   : choice != spec.choices.end() ? SettingValue(*choice)
                                                  : parse_setting(spec, text.toStdString()));
    return true;
  } catch (const InputError& error) {
    emit refused(index, QString::fromUtf8(error.what()));
    return false;
  }
}

Qt::ItemFlags SetupTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() && key_at(index).has_value() ? flags | Qt::ItemIsEditable : flags;
}

QString SetupTable::explanation(const std::string& key) const {
  const SettingSpec spec = edit_.state().spec(key);
  const Provenance provenance = edit_.state().provenance(key);
  QStringList lines;
  lines.append(QStringLiteral("<b>%1</b>%2")
                   .arg(core_text(spec.title).toHtmlEscaped(),
                        spec.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(unit_text(spec.unit))));
  lines.append(core_text(spec.explanation).toHtmlEscaped());
  if (spec.choices.empty()) {
    lines.append(tr("Range: %1").arg(range_text(spec)));
  }
  if (edit_.state().edited(key)) {
    lines.append(tr("Changed; the file says %1.").arg(value_text(edit_.state().file_value(key))));
  }
  const QString source = QString::fromStdString(provenance.source).toHtmlEscaped();
  if (source.isEmpty()) {
    lines.append(tr("Source: the model's own value; the machine's file gives none."));
  } else {
    lines.append(provenance.assumed ? tr("Assumed: %1").arg(source) : tr("Source: %1").arg(source));
  }
  return QStringLiteral("<p>%1</p>").arg(lines.join("<br>"));
}

int AxisTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(axis_limit_specs().size());
}

int AxisTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(axis_names.size());
}

QVariant AxisTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || section < 0) {
    return {};
  }
  const auto i = static_cast<std::size_t>(section);
  if (orientation == Qt::Horizontal) {
    return i < axis_names.size() ? QString(QChar(axis_names[i])) : QVariant();
  }
  if (i >= axis_limit_specs().size()) {
    return {};
  }
  const SettingSpec& spec = axis_limit_specs()[i];
  return QStringLiteral("%1 [%2]").arg(core_text(spec.title), unit_text(spec.unit));
}

std::optional<std::string> AxisTable::key_at(const QModelIndex& index) const {
  return topic_of(index);
}

std::string AxisTable::topic_of(const QModelIndex& index) const {
  return axis_key(axis_names[static_cast<std::size_t>(index.column())],
                  axis_limit_specs()[static_cast<std::size_t>(index.row())].key);
}

SettingsTable::SettingsTable(SetupEdit& edit, QObject* parent) : SetupTable(edit, parent) {
  reload();
}

void SettingsTable::reload() {
  specs_ = settings_of(*edit().file().model);
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
  return spec.optional && edit().state().value(spec.key) == SettingValue(std::string());
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
      return unit_text(spec.unit);
    case range:
      return range_text(spec);
    default:
      return {};
  }
}

}  // namespace feedscope::ui
