#include "core/machine/config_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/machine/file_text.h"

namespace feedscope {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = 1;  // MiB; a machine file is a few thousand bytes

}  // namespace

/// Converts the result of the TOML library to nodes.
class ConfigBuilder {
 public:
  explicit ConfigBuilder(std::shared_ptr<const std::string> file) : file_(std::move(file)) {}

  ConfigNode build(const toml::node& from) const {
    ConfigNode node;
    node.file_ = file_;
    node.position_ = position(from.source());
    if (const auto* text = from.as_string()) {
      node.kind_ = ConfigNode::Kind::text;
      node.text_ = text->get();
    } else if (from.is_number()) {
      node.kind_ = ConfigNode::Kind::number;
      node.number_ = *from.value<double>();
    } else if (from.is_boolean()) {
      node.kind_ = ConfigNode::Kind::truth;
    } else if (const auto* list = from.as_array()) {
      node.kind_ = ConfigNode::Kind::list;
      for (const toml::node& item : *list) {
        node.items_.push_back(build(item));
      }
    } else if (const auto* table = from.as_table()) {
      node.kind_ = ConfigNode::Kind::table;
      for (const auto& [key, value] : *table) {
        node.keys_.emplace_back(key.str());
        node.key_positions_.push_back(position(key.source()));
        node.items_.push_back(build(value));
      }
    }
    return node;
  }

 private:
  static ConfigNode::Position position(const toml::source_region& region) {
    return {region.begin.line, region.begin.column};
  }

  std::shared_ptr<const std::string> file_;
};

Message table_text(const std::string& where) {
  return where == the_file ? Message(NC_("core", "the file")) : Message::as_written(where);
}

std::string ConfigNode::place(const Position& position) const {
  return fmt::format("{}:{}:{}", *file_, position.line, position.column);
}

std::string ConfigNode::place() const {
  return place(position_);
}

void ConfigNode::fail(const Message& what) const {
  throw InputError(at_place(place(), what));
}

const ConfigNode* ConfigNode::find(const std::string& key) const {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  return found == keys_.end() ? nullptr : &items_[static_cast<std::size_t>(found - keys_.begin())];
}

void ConfigNode::check_keys(const std::vector<std::string>& known, const std::string& where) const {
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (std::find(known.begin(), known.end(), keys_[i]) == known.end()) {
      const std::string nearest = nearest_name(keys_[i], known);
      const Message known_ones =
          nearest.empty() ? message(NC_("core", "known: {}"), fmt::to_string(fmt::join(known, ", ")))
                          : message(NC_("core", "did you mean '{}'?"), nearest);
      throw InputError(at_place(place(key_positions_[i]), message(NC_("core", "unknown key '{}' in {}; {}"),
                                                                  keys_[i], table_text(where), known_ones)));
    }
  }
}

const ConfigNode& ConfigNode::need(const std::string& key, const std::string& where) const {
  const ConfigNode* node = find(key);
  if (node == nullptr) {
    fail(message(NC_("core", "key '{}' is missing in {}"), key, table_text(where)));
  }
  return *node;
}

const ConfigNode& ConfigNode::need_table(const std::string& key, const std::string& where) const {
  const ConfigNode& node = need(key, where);
  if (node.kind() != Kind::table) {
    node.fail(message(NC_("core", "'{}' in {} must be a table"), key, table_text(where)));
  }
  return node;
}

const std::string& ConfigNode::need_text(const std::string& key, const std::string& where) const {
  const ConfigNode& node = need(key, where);
  if (!node.is_text() || node.text().empty()) {
    node.fail(message(NC_("core", "'{}' in {} must be a text in quotes"), key, table_text(where)));
  }
  return node.text();
}

ConfigNode read_config_file(const fs::path& file, Translatable what) {
  return parse_config(file_text(file, what, largest_file), file.string());
}

ConfigNode parse_config(const std::string& text, const std::string& name) {
  try {
    return ConfigBuilder(std::make_shared<const std::string>(name)).build(toml::parse(text, name));
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw InputError(at_place(fmt::format("{}:{}:{}", name, begin.line, begin.column),
                              message(NC_("core", "not valid TOML: {}"), error.description())));
  }
}

}  // namespace feedscope
