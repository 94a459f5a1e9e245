#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/machine/import/configuration_source.h"
#include "core/machine/import/machine_draft.h"

namespace feedscope {

/// Syntax of sections and includes of a control.
enum class SectionStyle : std::uint8_t {
  linuxcnc,  ///< KEY = value; comments on their own lines or after a blank; #INCLUDE file; the first of two
             ///< applies
  klipper,   ///< key: value or key = value; [include glob]; further lines indented; the last of two applies
};

struct SectionEntry {
  std::string section;
  std::string key;
  std::string value;
  ConfigurationPlace place;

  /// Value with its name, such as "[AXIS_X] MAX_VELOCITY = 5".
  GivenValue given(std::string_view unit = "") const;
};

struct SectionHead {
  std::string name;
  ConfigurationPlace place;
};

/// A configuration in sections, with included files in place. Lines that are neither section nor entry, files
/// that cannot be included, and entries replaced by another value become notes of the draft.
class SectionFile {
 public:
  SectionFile(const ConfigurationSource& source, SectionStyle style, MachineDraft& draft);

  /// Entry that applies; null if there is none.
  const SectionEntry* find(std::string_view section, std::string_view key);
  const SectionHead* find_section(std::string_view section) const;
  const std::vector<SectionEntry>& entries() const { return entries_; }
  /// Passes everything that find() was never called for to MachineDraft::leave_out(): "[SECTION] KEY", or
  /// "[SECTION]" for a section without any call.
  void leave_out_rest() const;
  const std::vector<SectionHead>& sections() const { return sections_; }
  /// Place of a section; the file as a whole without it.
  ConfigurationPlace place_of(std::string_view section) const;

 private:
  struct OpenFile {
    std::string name;  ///< empty: the imported file
    std::filesystem::path folder;
  };

  void read(std::string_view text, const OpenFile& file);
  void read_line(const ConfigurationLine& line, const OpenFile& file);
  bool include(const ConfigurationLine& line, const OpenFile& file);
  void include_all(const std::string& pattern, const ConfigurationPlace& place, const OpenFile& from);
  void include_one(const std::filesystem::path& file, const std::string& name,
                   const ConfigurationPlace& place);
  void add(SectionEntry entry);
  std::string_view without_comment(std::string_view text) const;

  SectionStyle style_;
  MachineDraft& draft_;
  std::string section_;
  std::vector<SectionEntry> entries_;
  std::map<std::pair<std::string, std::string>, std::size_t>
      holding_;                                          ///< section and key: index into entries_
  std::set<std::pair<std::string, std::string>> asked_;  ///< by find(): section and key
  std::vector<SectionHead> sections_;
  std::vector<std::filesystem::path> open_;  ///< files being read, outermost first
  std::size_t files_ = 0;
};

}  // namespace feedscope
