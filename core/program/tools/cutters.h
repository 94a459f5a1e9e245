#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/program/program.h"
#include "core/program/text/subprogram_files.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {

/// Source of the radius of each cutter: ReadOptions, else the program, else the tool table that the options
/// name or that is in the program's folder.
class Cutters {
 public:
  /// `files` outlives it. Throws InputError for an unreadable table of `options`.
  Cutters(const ReadOptions& options, SubprogramFiles& files);

  struct Found {
    CutterSource source = CutterSource::unknown;
    double radius = 0;  ///< [mm]
  };
  Found find(std::string_view tool, std::optional<double> programmed);

  /// Name of the table used; empty: none.
  const std::string& table_name() const { return table_name_; }
  /// Fault of a table in the program's folder; empty: no fault, or no table.
  const Message& table_fault() const { return table_fault_; }

 private:
  void read_table_beside();

  CutterRadii asked_;
  bool wear_only_ = false;
  double unit_ = 1;
  SubprogramFiles& files_;
  CutterRadii table_;
  bool has_table_ = false;
  std::string table_name_;
  Message table_fault_;
};

}  // namespace feedscope
