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
  iso,             ///< what ISO controls share; where they differ the block itself decides
  fanuc,           ///< Fanuc and what follows it (Haas, Mitsubishi): O numbers, macro B
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
/// Throws InputError with the nearest name for an id that is not known.
Dialect dialect_of_id(std::string_view id);

/// A language that is recognised and not read.
struct ForeignLanguage {
  std::string_view title;  ///< of the control
  Translatable meaning;    ///< what its words mean that the dialects read otherwise
  std::uint32_t line = 0;  ///< of the first word of it; 0: the ending of the file's name says it
};

/// The language of a control that is not supported, by words and file names that only it has.
std::optional<ForeignLanguage> recognise_foreign(const SourceText& source);

/// The dialect that a text is written in, by words that only one dialect has, in its first lines; where they
/// are missing by the ending of its name, else, and for a foreign language, Dialect::iso.
Dialect recognise(const SourceText& source);

}  // namespace feedscope
