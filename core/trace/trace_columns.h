#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Usable quantities of a trace column.
///
/// x, y and z are the positions compared with the program; actual_x etc. are encoder positions of a trace
/// that has both.
enum class TraceQuantity : std::uint8_t { time, number, x, y, z, line, feed, actual_x, actual_y, actual_z };
inline constexpr std::size_t trace_quantity_count = 10;
/// By axis.
inline constexpr std::array place_quantities{TraceQuantity::x, TraceQuantity::y, TraceQuantity::z};
inline constexpr std::array actual_quantities{TraceQuantity::actual_x, TraceQuantity::actual_y,
                                              TraceQuantity::actual_z};

/// Whether it is a set or actual position of an axis.
bool is_position(TraceQuantity quantity);
/// Names in column specifications: "time", "number", ...
std::string_view to_string(TraceQuantity quantity);

/// Column of a quantity in a file.
struct TraceColumn {
  std::string column;       ///< 1-based number, or name in the header of the table
  double factor = 1;        ///< internal units per unit of the file; negative: mirrored
  bool unit_given = false;  ///< else the header of the table may contain the unit
  std::string unit = "";    ///< as written
  double offset = 0;        ///< of a position, added in the unit of the column
};

/// Options for reading a table of samples; missing ones are detected.
struct TraceColumns {
  std::array<std::optional<TraceColumn>, trace_quantity_count> columns;
  char separator = 0;  ///< 0: detected; ' ' means any number of blanks and tabs
  char decimal = 0;    ///< '.' or ','; 0: detected
  double period = 0;   ///< explicit, precedes times of the file [s]; 0: none
  /// Servo period of the machine, for files without times if `period` is not set [s]; 0: none.
  double machine_period = 0;
  std::size_t skip = 0;  ///< lines before the table

  const std::optional<TraceColumn>& of(TraceQuantity quantity) const {
    return columns[static_cast<std::size_t>(quantity)];
  }
  std::optional<TraceColumn>& of(TraceQuantity quantity) {
    return columns[static_cast<std::size_t>(quantity)];
  }
  bool any() const;
};

/// Predefined columns: name and specification.
struct TracePreset {
  std::string_view name;
  std::string_view specification;
};
const std::vector<TracePreset>& trace_presets();

/// Reads the name of a preset, optionally followed by assignments as in "linuxcnc,rate=500", or
/// "time=1:ms,x=2,y=3:-mm,line=Block,feed=6:mm/min,separator=tab,decimal=comma, rate=1000,skip=2": for each
/// quantity the number or the name of its column, its unit, a minus sign if the axis is mirrored, and for a
/// position an offset in this unit: "x=2:mm:-12.5". Throws InputError with the problem and the nearest valid
/// name.
TraceColumns parse_trace_columns(const std::string& specification);

/// Internal units per `unit` of a quantity; none for a unit that it cannot have.
std::optional<double> trace_unit(TraceQuantity quantity, std::string_view unit);
/// Possible units of a quantity, for messages.
std::string trace_units(TraceQuantity quantity);

/// Meaning of a column title such as "X_mm", "Feed [mm/min]" or "Axis X actual position", judged by its
/// words.
struct NamedColumn {
  std::optional<TraceQuantity> quantity;
  std::string unit;     ///< as in the title
  int rank = 0;         ///< of several columns for one quantity the highest rank is used
  bool actual = false;  ///< a position that its title describes as measured
};
NamedColumn recognise_column(std::string_view title);

}  // namespace feedscope
