#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

/// `where` of keys outside every table, in English.
inline constexpr const char* the_file = "the file";
/// A `where` as part of a message: tables remain as written, the_file is translated.
Message table_text(const std::string& where);

/// A value of a TOML file with its place, for precise error messages. `where` in the functions below names
/// the table in messages: "[axes.X]", the_file.
class ConfigNode {
 public:
  enum class Kind : std::uint8_t { text, number, truth, list, table, other };

  Kind kind() const { return kind_; }
  bool is_text() const { return kind_ == Kind::text; }
  bool is_number() const { return kind_ == Kind::number; }
  bool is_list() const { return kind_ == Kind::list; }
  const std::string& text() const { return text_; }
  double number() const { return number_; }
  const std::vector<ConfigNode>& items() const { return items_; }  ///< of a list; values of a table
  const std::vector<std::string>& keys() const { return keys_; }   ///< of a table, one per item, sorted

  std::string place() const;  ///< "FILE:LINE:COLUMN"
  /// Throws InputError that begins with the place.
  [[noreturn]] void fail(const Message& what) const;
  [[noreturn]] void fail(const std::string& text) const { fail(Message::as_written(text)); }

  /// Value of a key, nullptr if this table has none.
  const ConfigNode* find(const std::string& key) const;
  /// Throws InputError with the nearest valid name for an unknown key.
  void check_keys(const std::vector<std::string>& known, const std::string& where) const;
  /// These throw InputError if the key is missing or its value is of another kind.
  const ConfigNode& need(const std::string& key, const std::string& where) const;
  const ConfigNode& need_table(const std::string& key, const std::string& where) const;
  const std::string& need_text(const std::string& key, const std::string& where) const;

 private:
  friend class ConfigBuilder;
  struct Position {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
  };

  std::string place(const Position& position) const;

  Kind kind_ = Kind::other;
  double number_ = 0;
  std::string text_;
  std::vector<ConfigNode> items_;
  std::vector<std::string> keys_;
  std::vector<Position> key_positions_;
  Position position_;
  std::shared_ptr<const std::string> file_;
};

/// Reads a TOML file of at most 1 MiB. `what` for messages: "machine file". Throws InputError with file and
/// reason, for wrong syntax also line and column.
ConfigNode read_config_file(const std::filesystem::path& file, Translatable what);
/// Reads a text; `name` replaces the file in messages.
ConfigNode parse_config(const std::string& text, const std::string& name);

}  // namespace feedscope
