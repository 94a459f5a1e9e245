#include "core/load/load_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/load/load_keys.h"
#include "core/machine/config_file.h"
#include "core/machine/settings.h"
#include "core/program/tools/cutter_radii.h"

namespace feedscope {
namespace {

constexpr Translatable file_kind = NC_("core", "load file");
constexpr double format_version = 1;
constexpr std::array<const char*, 3> linear_cutting{"ktc_n_mm2", "krc_n_mm2", "kac_n_mm2"};
constexpr std::array<const char*, 3> linear_edge{"kte_n_mm", "kre_n_mm", "kae_n_mm"};
constexpr const char* kienzle_force = "kc11_n_mm2";
constexpr const char* kienzle_exponent = "mc";
constexpr std::array<const char*, 3> kienzle_share{"", "radial_share", "axial_share"};
constexpr double largest_coefficient = 1e5;
constexpr double most_teeth = 200;

struct NumberBounds {
  double least = 0;
  double most = 0;
  bool least_allowed = true;
};

double number_of(const ConfigNode& table, const char* key, const std::string& where,
                 const NumberBounds& bounds, bool whole = false) {
  const ConfigNode& node = table.need(key, where);
  if (!node.is_number()) {
    node.fail(message(NC_("core", "{} in {} must be a number"), std::string_view(key), table_text(where)));
  }
  SettingSpec spec{
      .key = key,
      .minimum = bounds.least,
      .maximum = bounds.most,
      .minimum_allowed = bounds.least_allowed,
      .whole = whole,
  };
  check_setting(spec, node.number(), node.place());
  return node.number();
}

const std::vector<ConfigNode>& tables_of(const ConfigNode& root, const std::string& key) {
  static const std::vector<ConfigNode> none;
  const ConfigNode* list = root.find(key);
  if (list == nullptr) {
    return none;
  }
  const bool tables =
      list->is_list() && std::all_of(list->items().begin(), list->items().end(), [](const ConfigNode& item) {
        return item.kind() == ConfigNode::Kind::table;
      });
  if (!tables) {
    list->fail(message(NC_("core", "'{0}' must be tables; begin each with [[{0}]]"), std::string_view(key)));
  }
  return list->items();
}

std::vector<ProgramLines> ranges_at(const ConfigNode& node) {
  auto ranges = node.is_text() ? ranges_of(node.text()) : std::nullopt;
  if (!ranges) {
    node.fail(NC_(
        "core",
        "'lines' must be ranges of lines of the program in quotes, such as \"10-25\" or \"10-25, 40-52\""));
  }
  return *std::move(ranges);
}

/// A number or a quoted name.
std::string tool_of(const ConfigNode& node) {
  std::string tool;
  if (node.is_text()) {
    tool = CutterRadii::key(node.text());
  } else if (node.is_number() && node.number() >= 0 && node.number() == std::floor(node.number()) &&
             node.number() < 1e9) {
    tool = fmt::format("{:.0f}", node.number());
  }
  if (tool.empty()) {
    node.fail(NC_("core", "'tool' must be its number, or its name in quotes, as the program calls it"));
  }
  return tool;
}

Engagement operation_of(const ConfigNode& table, const std::string& where) {
  std::vector<std::string> keys{"tool", "lines", "teeth", "milling", "material"};
  for (const OperationKey& key : operation_keys) {
    keys.emplace_back(key.key);
  }
  table.check_keys(keys, where);
  Engagement operation;
  if (const ConfigNode* tool = table.find("tool")) {
    operation.tool = tool_of(*tool);
  }
  if (const ConfigNode* lines = table.find("lines")) {
    operation.lines = ranges_at(*lines);
  }
  operation.teeth = static_cast<int>(number_of(table, "teeth", where, {1, most_teeth}, true));
  for (const OperationKey& key : operation_keys) {
    const NumberBounds bounds{key.least, key.most, key.least_allowed};
    if (key.needed != nullptr) {
      operation.*key.needed = key.unit.to_internal(number_of(table, key.key, where, bounds));
    } else if (table.find(key.key) != nullptr) {
      operation.*key.given = key.unit.to_internal(number_of(table, key.key, where, bounds));
    }
  }
  const std::string& milling = table.need_text("milling", where);
  if (milling != "up" && milling != "down") {
    table.need("milling", where)
        .fail(
            message(NC_("core", "milling '{}' is not known; write \"up\" (conventional) or \"down\" (climb)"),
                    milling));
  }
  operation.milling = milling == "up" ? Milling::up : Milling::down;
  operation.material = table.need_text("material", where);
  if (const Message problem = operation_problem(operation); !problem.empty()) {
    table.fail(at_place(where, problem));
  }
  return operation;
}

Material material_of(const ConfigNode& table, const std::string& where) {
  Material material;
  material.id = table.need_text("id", where);
  material.source = table.need_text("source", where);
  material.title = table.find("title") != nullptr ? table.need_text("title", where) : material.id;
  const std::string& law = table.need_text("law", where);
  std::vector<std::string> keys{"id", "title", "source", "law"};
  const auto read = [&](const char* key, double most) {
    keys.emplace_back(key);
    return number_of(table, key, where, {0, most, true});
  };
  if (law == "linear-edge") {
    for (std::size_t i = 0; i < linear_cutting.size(); ++i) {
      material.cutting[i] = read(linear_cutting[i], largest_coefficient);
      material.edge[i] = read(linear_edge[i], largest_coefficient);
    }
  } else if (law == "kienzle") {
    material.law = CuttingLaw::kienzle;
    material.specific_force = read(kienzle_force, largest_coefficient);
    material.exponent = read(kienzle_exponent, 0.9);
    for (std::size_t i = 1; i < kienzle_share.size(); ++i) {
      material.share[i] = read(kienzle_share[i], 10);
    }
  } else {
    table.need("law", where)
        .fail(message(NC_("core", "law '{}' is not known; write \"linear-edge\" or \"kienzle\""), law));
  }
  table.check_keys(keys, where);
  if (!(force_law(material).chip[0] > 0)) {
    table.fail(message(NC_("core", "{} has no tangential cutting force; {} must be above 0"), where,
                       std::string_view(law == "kienzle" ? kienzle_force : linear_cutting[0])));
  }
  return material;
}

std::vector<Material> materials_of(const ConfigNode& root) {
  std::vector<Material> materials;
  for (const ConfigNode& table : tables_of(root, "material")) {
    Material material = material_of(table, fmt::format("[[material]] number {}", materials.size() + 1));
    const bool known = std::any_of(materials.begin(), materials.end(),
                                   [&](const Material& other) { return other.id == material.id; });
    if (known) {
      table.fail(message(NC_("core", "material '{}' is given twice; remove one or give it another id"),
                         material.id));
    }
    materials.push_back(std::move(material));
  }
  return materials;
}

void check_version(const ConfigNode& root) {
  const double version = number_of(root, "feedscope_load", the_file, {1, 1e6}, true);
  if (version != format_version) {
    root.need("feedscope_load", the_file)
        .fail(message(
            NC_("core", "load files of version {:.0f} are not known; this program reads version {:.0f}"),
            version, format_version));
  }
}

LoadSetup load_of(const ConfigNode& root, bool overlaps) {
  root.check_keys({"feedscope_load", "operation", "material"}, the_file);
  check_version(root);
  LoadSetup setup;
  setup.materials = materials_of(root);
  for (const ConfigNode& table : tables_of(root, "operation")) {
    const std::string where = fmt::format("[[operation]] number {}", setup.operations.size() + 1);
    setup.operations.push_back(operation_of(table, where));
    try {
      find_material(setup.operations.back().material, setup.materials);
    } catch (const InputError& error) {
      table.need("material", where).fail(error.message());
    }
    if (const Message problem = overlap_problem(setup.operations); !overlaps && !problem.empty()) {
      table.fail(problem);
    }
  }
  if (setup.operations.empty()) {
    root.fail(NC_("core",
                  "the file has no operation; add an [[operation]] with tool, diameter_mm, teeth, helix_deg, "
                  "ae_mm, ap_mm, milling and material"));
  }
  return setup;
}

bool overlap(const Engagement& a, const Engagement& b) {
  if (a.lines.empty() || b.lines.empty()) {
    return a.lines.empty() && b.lines.empty() && a.tool == b.tool;
  }
  if (!a.tool.empty() && !b.tool.empty() && a.tool != b.tool) {
    return false;
  }
  return std::any_of(a.lines.begin(), a.lines.end(), [&](const ProgramLines& one) {
    return std::any_of(b.lines.begin(), b.lines.end(), [&](const ProgramLines& other) {
      return one.first <= other.last && other.first <= one.last;
    });
  });
}

std::string toml_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string text_of(const Engagement& operation) {
  std::string text = "\n[[operation]]\n";
  if (!operation.tool.empty()) {
    text += fmt::format("tool = {}\n", toml_string(operation.tool));
  }
  if (!operation.lines.empty()) {
    text += fmt::format("lines = {}\n", toml_string(ranges_text(operation.lines)));
  }
  text += fmt::format("teeth = {}\n", operation.teeth);
  for (const OperationKey& key : operation_keys) {
    const std::optional<double> value =
        key.needed != nullptr ? std::optional(operation.*key.needed) : operation.*key.given;
    if (value) {
      text += fmt::format("{} = {}\n", key.key, shortest_in_unit(*value, key.unit));
    }
  }
  return text + fmt::format("milling = \"{}\"\nmaterial = {}\n",
                            operation.milling == Milling::up ? "up" : "down",
                            toml_string(operation.material));
}

std::string text_of(const Material& material) {
  std::string text =
      fmt::format("\n[[material]]\nid = {}\ntitle = {}\nsource = {}\n", toml_string(material.id),
                  toml_string(material.title), toml_string(material.source));
  if (material.law == CuttingLaw::linear_edge) {
    text += "law = \"linear-edge\"\n";
    for (std::size_t i = 0; i < linear_cutting.size(); ++i) {
      text += fmt::format("{} = {}\n{} = {}\n", linear_cutting[i], material.cutting[i], linear_edge[i],
                          material.edge[i]);
    }
    return text;
  }
  return text + fmt::format("law = \"kienzle\"\n{} = {}\n{} = {}\n{} = {}\n{} = {}\n", kienzle_force,
                            material.specific_force, kienzle_exponent, material.exponent, kienzle_share[1],
                            material.share[1], kienzle_share[2], material.share[2]);
}

}  // namespace

LoadSetup read_load_file(const std::filesystem::path& file) {
  return load_of(read_config_file(file, file_kind), false);
}

LoadSetup parse_load(const std::string& text, const std::string& name, bool overlaps) {
  return load_of(parse_config(text, name), overlaps);
}

std::vector<Material> read_materials(const std::filesystem::path& file) {
  const ConfigNode root = read_config_file(file, NC_("core", "file of materials"));
  root.check_keys({"feedscope_load", "material"}, the_file);
  check_version(root);
  return materials_of(root);
}

std::string load_file_text(const LoadSetup& setup) {
  std::string text = fmt::format("feedscope_load = {:.0f}\n", format_version);
  for (const Engagement& operation : setup.operations) {
    text += text_of(operation);
  }
  for (const Material& material : setup.materials) {
    text += text_of(material);
  }
  return text;
}

Message overlap_problem(const std::vector<Engagement>& operations) {
  for (std::size_t i = 0; i < operations.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(operations[i], operations[j])) {
        return message(NC_("core",
                           "operations {} ({}) and {} ({}) apply to the same motions; remove one, or give "
                           "each its own tool or lines"),
                       j + 1, describe(operations[j]), i + 1, describe(operations[i]));
      }
    }
  }
  return {};
}

}  // namespace feedscope
