#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {

/// A tool table in columns under a line of headings: Heidenhain's TOOL.T, spreadsheet lists.
class ToolColumns {
 public:
  /// None if no line of the text is a heading with a column of tools and one of radii or diameters.
  static std::optional<ToolColumns> find(const SourceText& text, double unit);

  /// Throws InputError with line and value. Omits rows without a tool or without a radius of 0 or more.
  CutterRadii read() const;

 private:
  enum class Meaning : unsigned char { other, number, name, radius, excess, diameter };
  struct Column {
    Meaning meaning = Meaning::other;
    std::size_t from = 0;  ///< of a table of fixed width
  };

  ToolColumns(const SourceText& text, double unit) : text_(&text), unit_(unit) {}
  bool read_headings(std::string_view line);
  bool has(Meaning meaning) const;
  std::vector<std::string_view> cells(std::string_view line) const;
  double number(std::string_view cell, std::uint32_t line) const;

  const SourceText* text_;
  double unit_;              ///< [mm]
  std::uint32_t heads_ = 0;  ///< line of the headings
  char separator_ = '\0';    ///< none: columns of fixed width
  std::vector<Column> columns_;
};

}  // namespace feedscope
