#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// What a column of a trace can hold that is of use here.
///
/// x, y and z are the positions that are laid beside the program; actual_x and its kin those that encoders
/// measured, of a trace that has both.
enum class TraceQuantity : std::uint8_t { time, number, x, y, z, line, feed, actual_x, actual_y, actual_z };
inline constexpr std::size_t trace_quantity_count = 10;
/// By axis.
inline constexpr std::array place_quantities{TraceQuantity::x, TraceQuantity::y, TraceQuantity::z};
inline constexpr std::array actual_quantities{TraceQuantity::actual_x, TraceQuantity::actual_y,
                                              TraceQuantity::actual_z};

/// Whether it is a set or actual position of an axis.
bool is_position(TraceQuantity quantity);
/// "time", "number", ... as in column specifications.
std::string_view to_string(TraceQuantity quantity);

/// Where a quantity stands in a file.
struct TraceColumn {
  std::string column;       ///< number from 1 on, or its name in the head of the table
  double factor = 1;        ///< inside units a unit of the file; negative: mirrored
  bool unit_given = false;  ///< else the head of the table may say the unit
  std::string unit = "";    ///< as it is written
  double offset = 0;        ///< of a position, added to it in the unit of the column
};

/// How a table of samples is read; what is not given is found from the file.
struct TraceColumns {
  std::array<std::optional<TraceColumn>, trace_quantity_count> columns;
  char separator = 0;  ///< 0: found; ' ' stands for any number of blanks and tabs
  char decimal = 0;    ///< '.' or ','; 0: found
  double period = 0;   ///< as given, before times of the file [s]; 0: not given
  /// Servo period of the machine that ran, for files without times where `period` is not given [s]; 0: none.
  double machine_period = 0;
  std::size_t skip = 0;  ///< lines in front of the table

  const std::optional<TraceColumn>& of(TraceQuantity quantity) const {
    return columns[static_cast<std::size_t>(quantity)];
  }
  std::optional<TraceColumn>& of(TraceQuantity quantity) {
    return columns[static_cast<std::size_t>(quantity)];
  }
  bool any() const;
};

/// Ready ones: name and specification.
struct TracePreset {
  std::string_view name;
  std::string_view specification;
};
const std::vector<TracePreset>& trace_presets();

/// Reads the name of a preset, which assignments may follow as in "linuxcnc,rate=500", or
/// "time=1:ms,x=2,y=3:-mm,line=Block,feed=6:mm/min,separator=tab,decimal=comma, rate=1000,skip=2": of each
/// quantity the number or the name of its column, its unit, a minus sign where the axis is mirrored, and of a
/// position what is added to it in this unit: "x=2:mm:-12.5". Throws InputError naming what is wrong, with
/// the nearest valid name.
TraceColumns parse_trace_columns(const std::string& specification);

/// Inside units a `unit` of a quantity; none for a unit that it cannot have.
std::optional<double> trace_unit(TraceQuantity quantity, std::string_view unit);
/// The units that a quantity can have, for messages.
std::string trace_units(TraceQuantity quantity);

/// What a column of a head like "X_mm", "Feed [mm/min]" or "Axis X actual position" is, judged by its words.
struct NamedColumn {
  std::optional<TraceQuantity> quantity;
  std::string unit;     ///< as it stands there
  int rank = 0;         ///< of several columns for one quantity the one of the highest rank is used
  bool actual = false;  ///< a position that its title calls measured
};
NamedColumn recognise_column(std::string_view title);

}  // namespace feedscope
