#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/program/program.h"
#include "core/program/text/subprogram_files.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {

/// Where the radius of each cutter comes from: what ReadOptions say, else the program, else the tool table
/// that they name or that is in the program's folder.
class Cutters {
 public:
  /// `files` outlives it. Throws InputError for a table of `options` that cannot be read.
  Cutters(const ReadOptions& options, SubprogramFiles& files);

  struct Found {
    CutterSource source = CutterSource::unknown;
    double radius = 0;  ///< [mm]
  };
  Found find(std::string_view tool, std::optional<double> programmed);

  /// Name of the table that was used; empty: none was.
  const std::string& table_name() const { return table_name_; }
  /// What is wrong with a table beside the program; empty: nothing, or there is none.
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
