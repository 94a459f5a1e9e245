#include "ui/session/reading_json.h"

#include <QJsonArray>
#include <cmath>

#include "core/base/error.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

namespace {

constexpr const char* dialect_key = "dialect";
constexpr const char* unit_key = "unit";
constexpr const char* skip_key = "skip_deleted";
constexpr const char* repeat_key = "repeat_limit";
constexpr const char* depth_key = "call_depth";
constexpr const char* radii_key = "cutter_radii_mm";
constexpr const char* table_key = "tool_table";
constexpr const char* table_unit_key = "tool_table_unit_mm";
constexpr const char* wear_key = "wear_only";
constexpr const char* cut_off_key = "simulate_cut_off";
constexpr const char* offsets_key = "work_offsets_mm";
constexpr double largest_count = 1e15;

/// The number of `key`, at least `least` and, if `whole`, without decimals.
double number_of(const QJsonObject& json, const QString& key, double least, bool whole) {
  const double value = json[key].toDouble(-1);
  if (value >= least && value <= largest_count && (!whole || value == std::floor(value))) {
    return value;
  }
  throw InputError(QStringLiteral("\"reading\": \"%1\" is %2; it must be a %3 from %4 to %5")
                       .arg(key, json[key].toVariant().toString(),
                            whole ? QStringLiteral("whole number") : QStringLiteral("number"))
                       .arg(least)
                       .arg(largest_count)
                       .toStdString());
}

LengthUnit unit_of(const QJsonValue& json) {
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    if (json.toString().toStdString() == to_string(unit)) {
      return unit;
    }
  }
  throw InputError(QStringLiteral("\"reading\": \"%1\" is %2; it must be \"mm\" or \"inch\"")
                       .arg(unit_key, json.toVariant().toString())
                       .toStdString());
}

Vec3 zero_of(const QString& name, const QJsonArray& coordinates) {
  const bool numbers = coordinates.size() == 3 && coordinates[0].isDouble() && coordinates[1].isDouble() &&
                       coordinates[2].isDouble();
  if (!numbers || WorkOffsets::key(name.toStdString()).empty()) {
    throw InputError(
        QStringLiteral("\"reading\": \"%1\": \"%2\" must be a work offset such as G55 with three "
                       "numbers, its zero point in mm")
            .arg(offsets_key, name)
            .toStdString());
  }
  return {coordinates[0].toDouble(), coordinates[1].toDouble(), coordinates[2].toDouble()};
}

}  // namespace

std::vector<std::string> reading_keys() {
  return {dialect_key, unit_key,       skip_key, repeat_key,  depth_key,  radii_key,
          table_key,   table_unit_key, wear_key, cut_off_key, offsets_key};
}

QJsonObject to_json(const ReadOptions& options, const std::filesystem::path& folder) {
  const ReadOptions usual;
  QJsonObject json;
  if (options.dialect) {
    json[dialect_key] = QString::fromUtf8(info_of(*options.dialect).id.data());
  }
  if (options.unit) {
    json[unit_key] = QString::fromUtf8(to_string(*options.unit).data());
  }
  if (options.skip_deleted_blocks) {
    json[skip_key] = true;
  }
  if (options.repeat_limit != usual.repeat_limit) {
    json[repeat_key] = static_cast<double>(options.repeat_limit);
  }
  if (options.call_depth != usual.call_depth) {
    json[depth_key] = static_cast<double>(options.call_depth);
  }
  if (!options.radii.empty()) {
    QJsonObject radii;
    for (const auto& [tool, radius] : options.radii.all()) {
      radii[QString::fromStdString(tool)] = radius;
    }
    json[radii_key] = radii;
  }
  if (!options.tool_table.empty()) {
    const std::filesystem::path relative = options.tool_table.lexically_relative(folder);
    json[table_key] = to_portable_qstring(relative.empty() ? options.tool_table : relative);
  }
  if (options.table_unit != usual.table_unit) {
    json[table_unit_key] = options.table_unit;
  }
  if (options.wear_only) {
    json[wear_key] = true;
  }
  if (options.simulate_cut_off) {
    json[cut_off_key] = true;
  }
  if (!options.offsets.empty()) {
    QJsonObject offsets;
    for (const auto& [name, zero] : options.offsets.all()) {
      offsets[QString::fromStdString(name)] = QJsonArray{zero.x(), zero.y(), zero.z()};
    }
    json[offsets_key] = offsets;
  }
  return json;
}

ReadOptions read_reading(const QJsonObject& json, const std::filesystem::path& folder) {
  ReadOptions options;
  if (json.contains(dialect_key)) {
    options.dialect = dialect_of_id(json[dialect_key].toString().toStdString());
  }
  if (json.contains(unit_key)) {
    options.unit = unit_of(json[unit_key]);
  }
  options.skip_deleted_blocks = json[skip_key].toBool();
  if (json.contains(repeat_key)) {
    options.repeat_limit = static_cast<std::uint64_t>(number_of(json, repeat_key, 0, true));
  }
  if (json.contains(depth_key)) {
    options.call_depth = static_cast<std::size_t>(number_of(json, depth_key, 0, true));
  }
  const QJsonObject radii = json[radii_key].toObject();
  for (const QString& tool : radii.keys()) {
    options.radii.set(tool.toStdString(), number_of(radii, tool, 0, false));
  }
  if (const QString table = json[table_key].toString(); !table.isEmpty()) {
    options.tool_table = (folder / to_path(table)).lexically_normal();
  }
  if (json.contains(table_unit_key)) {
    options.table_unit = number_of(json, table_unit_key, 1e-6, false);
  }
  options.wear_only = json[wear_key].toBool();
  options.simulate_cut_off = json[cut_off_key].toBool();
  const QJsonObject offsets = json[offsets_key].toObject();
  for (const QString& name : offsets.keys()) {
    options.offsets.set(name.toStdString(), zero_of(name, offsets[name].toArray()));
  }
  return options;
}

}  // namespace feedscope::ui
