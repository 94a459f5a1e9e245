#include "core/machine/import/linuxcnc_ini.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "core/base/nearest_name.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/linuxcnc_kinematics.h"
#include "core/machine/import/machine_draft.h"
#include "core/machine/import/section_file.h"

namespace feedscope {
namespace {

constexpr double mm_of_inch = units::from_inch(1);
constexpr std::array letters{'X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'};

/// Sections that INI files of no other program have.
bool is_linuxcnc_section(std::string_view name) {
  constexpr std::array known{"EMC", "EMCMOT", "EMCIO", "RS274NGC", "TRAJ", "KINS", "HAL", "HALUI", "TASK"};
  return std::ranges::find(known, name) != known.end() || name.starts_with("AXIS_") ||
         name.starts_with("JOINT_");
}

std::size_t recognised_linuxcnc(std::string_view text) {
  std::size_t count = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    if (line.text.size() > 2 && line.text.front() == '[' && line.text.find(']') != std::string_view::npos) {
      count += is_linuxcnc_section(line.text.substr(1, line.text.find(']') - 1)) ? 1 : 0;
    }
  }
  return count > 1 ? count : 0;
}

struct StartUpWord {
  char letter;
  std::string text;  ///< after it
};

/// Words of "G21G64 P0.02", which need no blanks between them.
std::vector<StartUpWord> start_up_words(std::string_view code) {
  std::vector<StartUpWord> words;
  for (const char c : in_upper_case(code)) {
    if (c >= 'A' && c <= 'Z' && (words.empty() || !words.back().text.empty())) {
      words.push_back({c, ""});
    } else if (c != ' ' && c != '\t' && !words.empty()) {
      words.back().text += c;
    }
  }
  return words;
}

class LinuxCncReader {
 public:
  LinuxCncReader(const ConfigurationSource& source, MachineDraft draft)
      : draft_(std::move(draft)), file_(source, SectionStyle::linuxcnc, draft_) {}

  ImportedMachine read() {
    Machine& machine = draft_.machine();
    machine.control = "LinuxCNC";
    machine.reference = fmt::format("{}, INI file of the machine's LinuxCNC", draft_.file());
    draft_.choose_model({"linuxcnc", "cam"});
    if (const SectionEntry* name = file_.find("EMC", "MACHINE"); name != nullptr && !name->value.empty()) {
      machine.name = name->value;
    }
    read_units();
    read_coordinates();
    for (const AxisInfo& axis : known_axes) {
      read_axis(axis.name);
    }
    read_planner();
    read_start_up_code();
    note_keys();
    file_.leave_out_rest();
    return draft_.finish(linuxcnc_ini.kind, {5, 0.5, 0});
  }

 private:
  std::optional<double> number(const SectionEntry& entry, std::string_view unit = "") {
    return draft_.number(entry.value, entry.given(unit));
  }

  /// [TRAJ] LINEAR_UNITS: mm, inch, or the number of units per millimetre.
  void read_units() {
    const SectionEntry* entry = file_.find("TRAJ", "LINEAR_UNITS");
    if (entry == nullptr) {
      draft_.note(Severity::warning, file_.place_of("TRAJ"), "no-units",
                  NC_("core", "[TRAJ] LINEAR_UNITS is missing; mm is assumed"),
                  NC_("core", "write LINEAR_UNITS = mm or inch"));
      return;
    }
    const std::string word = in_upper_case(entry->value);
    if (word == "INCH" || word == "IN" || word == "IMPERIAL") {
      unit_ = mm_of_inch;
      unit_name_ = "inch";
    } else if (word != "MM" && word != "METRIC") {
      const std::optional<double> per_mm = number(*entry);
      if (per_mm && *per_mm > 0) {
        unit_ = 1 / *per_mm;
        unit_name_ = "units";
      } else if (per_mm) {
        draft_.note(Severity::error, entry->place, "no-units",
                    message(NC_("core", "LINEAR_UNITS = {} is not a unit; mm is assumed"), entry->value),
                    NC_("core", "write LINEAR_UNITS = mm or inch"));
      }
    }
  }

  /// Letters of the joints in their order.
  void read_coordinates() {
    const SectionEntry* entry = file_.find("TRAJ", "COORDINATES");
    std::string text = entry == nullptr ? "XYZ" : in_upper_case(entry->value);
    if (const SectionEntry* kins = file_.find("KINS", "KINEMATICS")) {
      constexpr std::string_view word = "COORDINATES=";
      const std::string upper = in_upper_case(kins->value);
      if (const std::size_t at = upper.find(word); at != std::string::npos) {
        entry = kins;
        text = upper.substr(at + word.size());
        text.resize(std::min(text.find(' '), text.size()));
      }
      turns_ = LinuxCncKinematics(file_, draft_, unit_, unit_name_).read();
      if (!upper.starts_with("TRIVKINS") && !turns_) {
        draft_.note(
            Severity::warning, kins->place, "not-modelled",
            message(NC_("core", "kinematics {} is not modelled: X, Y and Z are treated as axes of their own"),
                    kins->value));
      }
    }
    constexpr std::size_t most_joints = 16;
    for (const char c : text) {
      if (std::ranges::find(letters, c) != letters.end() && joints_.size() < most_joints) {
        joints_.push_back(c);
      }
    }
    for (const char letter : letters) {
      const bool turns = turns_ && draft_.machine().kinematics.find(letter) != nullptr;
      if (joints_.find(letter) != std::string::npos && !known_axes.find(letter) && !turns) {
        draft_.note(Severity::info, entry == nullptr ? ConfigurationPlace() : entry->place, "axis-skipped",
                    message(NC_("core", "axis {} is not part of the simulation; skipped"), letter));
      }
    }
  }

  /// Section of an axis: [AXIS_X], before LinuxCNC 2.8 [AXIS_0].
  std::string axis_section(char axis) const {
    const std::string own = fmt::format("AXIS_{}", axis);
    const auto place = std::ranges::find(letters, axis) - letters.begin();
    const std::string numbered = fmt::format("AXIS_{}", place);
    return file_.find_section(own) == nullptr && file_.find_section(numbered) != nullptr ? numbered : own;
  }

  std::vector<std::string> joint_sections(char axis) const {
    std::vector<std::string> sections;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const std::string name = fmt::format("JOINT_{}", i);
      if (joints_[i] == axis && file_.find_section(name) != nullptr) {
        sections.push_back(name);
      }
    }
    return sections;
  }

  void read_axis(char axis) {
    read_limit(axis, "MAX_VELOCITY", "/s", "velocity", units::to_m_min);
    read_limit(axis, "MAX_ACCELERATION", "/s2", "acceleration", units::to_m);
  }

  /// `to_unit`: from mm to the unit of the key.
  void read_limit(char axis, const char* name, const char* per, const char* key, double (*to_unit)(double)) {
    const std::string section = axis_section(axis);
    const std::string unit = unit_name_ + per;
    const SectionEntry* entry = file_.find(section, name);
    if (entry != nullptr) {
      if (const std::optional<double> value = number(*entry, unit)) {
        draft_.give_axis(axis, key, to_unit(*value * unit_), entry->given(unit));
        compare_with_joints(axis, *entry, *value);
      }
      return;
    }
    for (const std::string& joint : joint_sections(axis)) {
      const SectionEntry* other = file_.find(joint, name);
      const std::optional<double> value = other == nullptr ? std::nullopt : number(*other, unit);
      if (value && *value > 0) {
        draft_.note(Severity::warning, file_.place_of(section), "limit-missing",
                    message(NC_("core", "[{}] gives no {}; that of [{}] is assumed"), section,
                            std::string_view(name), joint),
                    message(NC_("core", "write {} into [{}]: LinuxCNC does not take it from the joint"),
                            std::string_view(name), section));
        draft_.assume_axis(axis, key, to_unit(*value * unit_),
                           fmt::format("[{}] gives none: as {}: {}", section, draft_.place_text(other->place),
                                       other->given(unit).what));
        return;
      }
    }
    if (joints_.find(axis) != std::string::npos) {
      draft_.note(
          Severity::warning, file_.place_of(section), "limit-missing",
          message(NC_("core", "{} of axis {} is missing; it is assumed"), std::string_view(name), axis),
          message(NC_("core", "write {} into [{}]"), std::string_view(name), section));
    }
  }

  void compare_with_joints(char axis, const SectionEntry& entry, double value) {
    const std::string step_limit =
        entry.key == "MAX_VELOCITY" ? std::string("STEPGEN_MAXVEL") : std::string("STEPGEN_MAXACCEL");
    std::vector<const SectionEntry*> others{file_.find(entry.section, step_limit)};
    for (const std::string& joint : joint_sections(axis)) {
      others.push_back(file_.find(joint, entry.key));
      others.push_back(file_.find(joint, step_limit));
    }
    for (const SectionEntry* other : others) {
      const std::optional<double> limit = other == nullptr ? std::nullopt : number(*other);
      if (limit && *limit > 0 && *limit < value) {
        draft_.note(Severity::warning, entry.place, "limits-contradict",
                    message(NC_("core", "[{}] {} = {} exceeds [{}] {} = {} ({}); the planner uses {}"),
                            entry.section, entry.key, entry.value, other->section, other->key, other->value,
                            draft_.place_text(other->place), entry.value),
                    NC_("core", "the joint cannot follow there: lower the limit of the axis"));
      }
    }
  }

  void read_planner() {
    constexpr double ns_in_s = 1e9;
    if (const SectionEntry* entry = file_.find("EMCMOT", "SERVO_PERIOD")) {
      if (const std::optional<double> period = number(*entry, "ns")) {
        draft_.give("servo_period_s", *period / ns_in_s, entry->given("ns"));
        draft_.give("interpolation_period_s", *period / ns_in_s, entry->given("ns"));
      }
    }
    const SectionEntry* velocity = file_.find("TRAJ", "MAX_LINEAR_VELOCITY");
    velocity = velocity == nullptr ? file_.find("TRAJ", "MAX_VELOCITY") : velocity;
    const std::string unit = unit_name_ + "/s";
    if (const std::optional<double> value = velocity == nullptr ? std::nullopt : number(*velocity, unit)) {
      draft_.give("max_linear_velocity_m_min", units::to_m_min(*value * unit_), velocity->given(unit));
    }
    if (const SectionEntry* entry = file_.find("DISPLAY", "MAX_FEED_OVERRIDE")) {
      if (const std::optional<double> value = number(*entry)) {
        draft_.give("max_feed_override", std::max(*value, 1.0), entry->given());
      }
    }
    draft_.assume("planner", "2.9", fmt::format("{} does not tell the release of LinuxCNC", draft_.file()));
    note_other_planner("PLANNER_TYPE", 0);
    note_other_planner("ARC_BLEND_ENABLE", 1);
    note_other_planner("ARC_BLEND_FALLBACK_ENABLE", 0);
    note_other_planner("ARC_BLEND_OPTIMIZATION_DEPTH", 50);
    note_other_planner("ARC_BLEND_GAP_CYCLES", 4);
    note_other_planner("ARC_BLEND_RAMP_FREQ", 100);
    note_other_planner("ARC_BLEND_KINK_RATIO", 0.1);
  }

  /// The model uses the default.
  void note_other_planner(const char* key, double usual) {
    const SectionEntry* entry = file_.find("TRAJ", key);
    const std::optional<double> value = entry == nullptr ? std::nullopt : number(*entry);
    if (value && *value != usual) {
      draft_.note(Severity::warning, entry->place, "not-modelled",
                  message(NC_("core", "[TRAJ] {} = {} is not modelled; the model computes with {}"),
                          std::string_view(key), entry->value, usual));
    }
  }

  /// RS274NGC_STARTUP_CODE, else the default tolerances of G64.
  void read_start_up_code() {
    give_tolerance("G64_DEFAULT_TOLERANCE", "blend_tolerance_mm");
    give_tolerance("G64_DEFAULT_NAIVETOLERANCE", "naive_tolerance_mm");
    const SectionEntry* entry = file_.find("RS274NGC", "RS274NGC_STARTUP_CODE");
    if (entry == nullptr) {
      return;
    }
    const std::vector<StartUpWord> words = start_up_words(entry->value);
    double unit = unit_;
    for (const StartUpWord& word : words) {
      const std::string code = word.letter == 'G' ? word.text : "";
      if (code == "20" || code == "21") {
        unit = code == "20" ? mm_of_inch : 1;
      } else if (code == "64" || code == "61" || code == "61.1") {
        draft_.give("blend_mode", "G" + code, entry->given());
      }
    }
    for (const StartUpWord& word : words) {
      if (word.letter == 'P' || word.letter == 'Q') {
        read_start_up_tolerance(word.letter, word.text, *entry, unit);
      }
    }
  }

  /// The complete control, 2.9, was observed to take only the tolerance for joining blocks from the start-up
  /// code, and to run blends with P 0 (traces of its own motion). Without Q that tolerance is P.
  void read_start_up_tolerance(char letter, std::string_view text, const SectionEntry& entry, double unit) {
    const std::optional<double> value = draft_.number(text, entry.given());
    if (!value) {
      return;
    }
    const bool is_q = letter == 'Q';
    if (is_q || !has_start_up_q_) {
      draft_.give("naive_tolerance_mm", *value * unit, entry.given());
      has_start_up_q_ = is_q;
    }
    if (!is_q) {
      draft_.assume("blend_tolerance_mm", 0.0,
                    fmt::format("{}: LinuxCNC 2.9 was seen to run blends with P 0 in spite of {}",
                                draft_.place_text(entry.place), entry.given().what));
      draft_.note(
          Severity::warning, entry.place, "start-up-tolerance",
          message(NC_("core",
                      "P of G64 in the start-up code has no effect on blends in LinuxCNC 2.9; P{} is used "
                      "for joining blocks alone"),
                  text),
          NC_("core", "write G64 P into the program, or set blend_tolerance_mm if your release takes it"));
    }
  }

  void give_tolerance(const char* key, const char* setting) {
    const SectionEntry* entry = file_.find("RS274NGC", key);
    if (const std::optional<double> value = entry == nullptr ? std::nullopt : number(*entry, unit_name_)) {
      draft_.give(setting, *value * unit_, entry->given(unit_name_));
    }
  }

  /// LinuxCNC ignores a misspelt key without any message.
  void note_keys() {
    const std::vector<std::string> used{"MAX_VELOCITY", "MAX_ACCELERATION",    "LINEAR_UNITS",
                                        "COORDINATES",  "MAX_LINEAR_VELOCITY", "SERVO_PERIOD"};
    const std::vector<std::string> others{"MIN_VELOCITY",
                                          "MAX_JERK",
                                          "MAX_LIMIT",
                                          "MIN_LIMIT",
                                          "MAX_OUTPUT",
                                          "MAX_LINEAR_JERK",
                                          "DEFAULT_VELOCITY",
                                          "DEFAULT_ACCELERATION",
                                          "MIN_LINEAR_VELOCITY",
                                          "MAX_ANGULAR_VELOCITY",
                                          "DEFAULT_LINEAR_VELOCITY",
                                          "DEFAULT_ANGULAR_VELOCITY",
                                          "MIN_ANGULAR_VELOCITY",
                                          "MAX_LINEAR_ACCELERATION",
                                          "MAX_ANGULAR_ACCELERATION",
                                          "DEFAULT_LINEAR_ACCELERATION",
                                          "DEFAULT_ANGULAR_ACCELERATION",
                                          "ANGULAR_UNITS"};
    for (const SectionEntry& entry : file_.entries()) {
      const bool of_motion = entry.section == "TRAJ" || entry.section == "EMCMOT" ||
                             entry.section.starts_with("AXIS_") || entry.section.starts_with("JOINT_");
      const bool known = std::ranges::find(used, entry.key) != used.end() ||
                         std::ranges::find(others, entry.key) != others.end();
      const std::string nearest = !of_motion || known ? "" : nearest_name(entry.key, used);
      if (!nearest.empty()) {
        draft_.note(Severity::warning, entry.place, "not-understood",
                    message(NC_("core", "[{}] {} is not known; skipped"), entry.section, entry.key),
                    message(NC_("core", "did you mean '{}'?"), nearest));
      }
    }
  }

  MachineDraft draft_;
  SectionFile file_;
  double unit_ = 1;  ///< of the machine [mm]
  std::string unit_name_ = "mm";
  std::string joints_;
  bool has_start_up_q_ = false;
  bool turns_ = false;  ///< the machine has rotary axes
};

ImportedMachine read_linuxcnc(const ConfigurationSource& source, MachineDraft draft) {
  return LinuxCncReader(source, std::move(draft)).read();
}

}  // namespace

const ConfigurationFormat linuxcnc_ini{QT_TRANSLATE_NOOP("core", "INI file of LinuxCNC"), recognised_linuxcnc,
                                       read_linuxcnc};

}  // namespace feedscope
