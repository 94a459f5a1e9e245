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

/// How a control writes sections and includes files.
enum class SectionStyle : std::uint8_t {
  linuxcnc,  ///< KEY = value; comments in lines of their own or behind a blank; #INCLUDE file; the first of
             ///< two holds
  klipper,   ///< key: value or key = value; [include glob]; further lines indented; the last of two holds
};

struct SectionEntry {
  std::string section;
  std::string key;
  std::string value;
  ConfigurationPlace place;

  /// "[AXIS_X] MAX_VELOCITY = 5"
  GivenValue given(std::string_view unit = "") const;
};

struct SectionHead {
  std::string name;
  ConfigurationPlace place;
};

/// A configuration in sections, with the files that it includes in their place. What can be read as neither
/// section nor entry, a file that cannot be included, and an entry that another one replaces with another
/// value are notes of the draft.
class SectionFile {
 public:
  SectionFile(const ConfigurationSource& source, SectionStyle style, MachineDraft& draft);

  /// The entry that holds; null if there is none.
  const SectionEntry* find(std::string_view section, std::string_view key);
  const SectionHead* find_section(std::string_view section) const;
  const std::vector<SectionEntry>& entries() const { return entries_; }
  /// Leaves out of the draft what find() was never asked for: "[SECTION] KEY", of sections that were asked
  /// for nothing "[SECTION]".
  void leave_out_rest() const;
  const std::vector<SectionHead>& sections() const { return sections_; }
  /// Where a section stands; the file as a whole without it.
  ConfigurationPlace place_of(std::string_view section) const;

 private:
  struct OpenFile {
    std::string name;  ///< empty: the file that is imported
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
      holding_;                                          ///< section and key: place in entries_
  std::set<std::pair<std::string, std::string>> asked_;  ///< of find(): section and key
  std::vector<SectionHead> sections_;
  std::vector<std::filesystem::path> open_;  ///< files that are being read, the outermost first
  std::size_t files_ = 0;
};

}  // namespace feedscope
