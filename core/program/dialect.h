#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/message.h"
#include "core/program/text/source_text.h"

namespace feedscope {

/// The language of an NC program.
enum class Dialect : std::uint8_t {
  iso,             ///< shared by ISO controls; where they differ the block itself decides
  fanuc,           ///< Fanuc and compatible controls (Haas, Mitsubishi): O numbers, macro B
  linuxcnc,        ///< LinuxCNC: RS-274/NGC with O words and named variables
  grbl,            ///< grbl and 3D printers: plain words only
  sinumerik,       ///< Siemens Sinumerik 840D
  heidenhain,      ///< Heidenhain conversational
  heidenhain_iso,  ///< Heidenhain DIN/ISO
};

struct DialectInfo {
  Dialect dialect = Dialect::iso;
  std::string_view id;     ///< as on the command line
  std::string_view title;  ///< as on the screen
};

std::span<const DialectInfo> all_dialects();
const DialectInfo& info_of(Dialect dialect);
/// Throws InputError with the nearest name for an unknown id.
Dialect dialect_of_id(std::string_view id);

/// A language that is recognised but not read.
struct ForeignLanguage {
  std::string_view title;  ///< of the control
  Translatable meaning;    ///< meaning of its words that the dialects read otherwise
  std::uint32_t line = 0;  ///< of its first word; 0: recognised by the file name extension
};

/// Recognises the language of an unsupported control, by words and file names that only it has.
std::optional<ForeignLanguage> recognise_foreign(const SourceText& source);

/// Recognises the dialect of a text by words in its first lines that only one dialect has, or else by its
/// file name extension. Returns Dialect::iso for everything else and for a foreign language.
Dialect recognise(const SourceText& source);

}  // namespace feedscope
