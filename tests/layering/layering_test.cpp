#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

/// What may include what: each includes itself and what stands before it.
const std::vector<std::string> stages{"core/base",         "core/kinematics",
                                      "core/machine",      "core/program",
                                      "core/toolpath",     "core/blend",
                                      "core/compressor",   "core/limits",
                                      "core/feed",         "core/trajectory",
                                      "core/drives",       "core/load",
                                      "core/trace",        "core/models",
                                      "core/analysis",     "core/identification",
                                      "core/lessons",      "core/export",
                                      "core/handbook",     "ui/units",
                                      "ui/language",       "ui/theme",
                                      "ui/fields",         "ui/shared",
                                      "ui/help",           "ui/scene",
                                      "ui/paper",          "ui/workbench",
                                      "ui/annotations",    "ui/scene_view",
                                      "ui/charts",         "ui/circular",
                                      "ui/load",           "ui/study",
                                      "ui/runs",           "ui/decide",
                                      "ui/contour",        "ui/trace",
                                      "ui/identification", "ui/why",
                                      "ui/slow_places",    "ui/time_use",
                                      "ui/versions",       "ui/messages",
                                      "ui/playback",       "ui/program_text",
                                      "ui/setup",          "ui/lessons",
                                      "ui/session",        "ui/report",
                                      "ui/film",           "ui/page",
                                      "ui/window",         "app"};

struct SourceFile {
  std::string path;  ///< from the project's top level
  std::vector<std::string> lines;
};

std::vector<SourceFile> sources_under(const std::vector<std::string>& folders) {
  const fs::path top = FEEDSCOPE_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") {
        SourceFile file{fs::relative(entry.path(), top).generic_string(), {}};
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
          file.lines.push_back(line);
        }
        files.push_back(std::move(file));
      }
    }
  }
  return files;
}

/// The name in an #include line, or "".
std::string included(const std::string& line) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::smatch match;
  return std::regex_search(line, match, pattern) ? match[1].str() : "";
}

/// "FILE:LINE: #include NAME" for every include that `wrong(file, name)` objects to.
template <typename Predicate>
std::vector<std::string> includes_where(const std::vector<SourceFile>& files, Predicate wrong) {
  std::vector<std::string> found;
  for (const SourceFile& file : files) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string name = included(file.lines[i]);
      if (!name.empty() && wrong(file, name)) {
        found.push_back(file.path + ":" + std::to_string(i + 1) + ": #include " + name);
      }
    }
  }
  return found;
}

/// Position of the stage that holds `path`; the number of stages if none does.
std::size_t stage_of(const std::string& path) {
  const auto holds = [&](const std::string& stage) { return path.starts_with(stage + "/"); };
  return static_cast<std::size_t>(std::find_if(stages.begin(), stages.end(), holds) - stages.begin());
}

TEST(Layering, TheFoldersAreTheStages) {
  for (const std::string room : {"core", "ui"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(FEEDSCOPE_SOURCE_DIR) / room)) {
      if (entry.is_directory()) {
        EXPECT_THAT(stages, testing::Contains(room + "/" + entry.path().filename().string()));
      }
    }
  }
}

/// What a panel needs of another one, if anything, is in a folder that both use.
TEST(Layering, PanelsDoNotKnowEachOther) {
  const std::vector<std::string> panels{"charts",   "study",         "runs",         "decide",   "contour",
                                        "why",      "slow_places",   "time_use",     "versions", "messages",
                                        "playback", "setup",         "program_text", "lessons",  "scene_view",
                                        "trace",    "identification"};
  const auto folder_of = [](const std::string& path) {
    const std::string inside = path.substr(std::min(path.size(), std::string("ui/").size()));
    return path.starts_with("ui/") ? inside.substr(0, inside.find('/')) : "";
  };
  const auto other_panel = [&](const SourceFile& file, const std::string& name) {
    return std::ranges::count(panels, folder_of(file.path)) > 0 &&
           std::ranges::count(panels, folder_of(name)) > 0 && folder_of(file.path) != folder_of(name);
  };
  EXPECT_THAT(includes_where(sources_under({"ui"}), other_panel), testing::IsEmpty());
}

TEST(Layering, IncludesRunOneWay) {
  const auto upwards = [](const SourceFile& file, const std::string& name) {
    const std::size_t stage = stage_of(name);
    return stage < stages.size() && stage > stage_of(file.path);
  };
  EXPECT_THAT(includes_where(sources_under({"core", "ui", "app"}), upwards), testing::IsEmpty());
}

/// A model explains its limits itself, by ControlModel::explain().
TEST(Layering, WhatFollowsTheModelsKnowsNoModel) {
  const auto of_one_model = [](const SourceFile&, const std::string& name) {
    return name.starts_with("core/models/") && name != "core/models/control_model.h" &&
           name != "core/models/explanation/reason.h";
  };
  EXPECT_THAT(includes_where(sources_under({"core/analysis", "core/identification", "core/lessons",
                                            "core/export", "core/handbook"}),
                             of_one_model),
              testing::IsEmpty());
}

TEST(Layering, NothingIncludesTests) {
  const auto test = [](const SourceFile&, const std::string& name) { return name.starts_with("tests/"); };
  EXPECT_THAT(includes_where(sources_under({"core", "ui", "app"}), test), testing::IsEmpty());
}

TEST(Layering, ProjectHeadersAreIncludedFromTheTopLevel) {
  const auto found_beside = [](const SourceFile& file, const std::string& name) {
    const fs::path beside = fs::path(FEEDSCOPE_SOURCE_DIR) / fs::path(file.path).parent_path() / name;
    return fs::exists(beside);
  };
  EXPECT_THAT(includes_where(sources_under({"core", "ui", "app", "tests"}), found_beside),
              testing::IsEmpty());
}

TEST(Layering, CoreKnowsNeitherQtNorVtk) {
  static const std::regex window(R"(^(Q[A-Z].*|Qt.*|vtk.*|GL/.*)$)");
  const auto is_window = [](const SourceFile&, const std::string& name) {
    return std::regex_match(name, window);
  };
  EXPECT_THAT(includes_where(sources_under({"core"}), is_window), testing::IsEmpty());
}

TEST(Layering, HeadersOfTheCoreIncludeNoLibraryButEigen) {
  static const std::regex library(R"(^(fmt|nlohmann|CLI|fast_float|toml\+\+|tbb)[/.].*$)");
  // What the sources of one folder share and nobody else sees; it is not installed.
  const std::string of_export_alone = "core/export/json_parts.h";
  const auto is_library = [&](const SourceFile& file, const std::string& name) {
    return file.path.ends_with(".h") && file.path != of_export_alone && std::regex_match(name, library);
  };
  EXPECT_THAT(includes_where(sources_under({"core"}), is_library), testing::IsEmpty());
  const auto takes_it = [&](const SourceFile& file, const std::string& name) {
    return name == of_export_alone && (file.path.ends_with(".h") || !file.path.starts_with("core/export/"));
  };
  EXPECT_THAT(includes_where(sources_under({"core", "ui", "app"}), takes_it), testing::IsEmpty());
}

TEST(Layering, SceneKnowsNoWidgets) {
  static const std::regex widget(
      R"(^(QtWidgets/.*|QtCharts/.*|QApplication|Q.*(Widget|Window|Dialog|Action|Button|Layout|View|Chart|Slider|Box|Label|Menu|Edit|Bar))$)");
  const auto is_widget = [](const SourceFile&, const std::string& name) {
    return std::regex_match(name, widget) || name.starts_with("ui/charts/");
  };
  EXPECT_THAT(includes_where(sources_under({"ui/scene"}), is_widget), testing::IsEmpty());
}

/// Two classes of one name in one namespace break the program wherever the linker keeps one constructor of
/// both.
TEST(Layering, NoTwoHeadersDefineTheSameClass) {
  const std::regex opens(R"(namespace ([\w:]+) \{)");
  const std::regex defines(R"((?:struct|class|enum class) (\w+(?:::\w+)*)[^;]*\{.*)");
  std::map<std::string, std::string> known;
  for (const SourceFile& file : sources_under({"core", "ui", "app"})) {
    std::string space;
    for (const std::string& line : file.path.ends_with(".h") ? file.lines : std::vector<std::string>()) {
      std::smatch match;
      if (std::regex_match(line, match, opens)) {
        space = match[1];
      } else if (std::regex_match(line, match, defines)) {
        const auto [first, is_new] = known.emplace(space + "::" + match[1].str(), file.path);
        EXPECT_TRUE(is_new || first->second == file.path)
            << first->first << " is defined in " << first->second << " and " << file.path;
      }
    }
  }
  EXPECT_GT(known.size(), 300U);
}

/// Those of Qt drop the decimal sign of another language.
TEST(Layering, NumbersAreTypedIntoFieldsOfUiFieldsAlone) {
  static const std::regex own_reading(
      R"(\bQ(Double)?SpinBox\b|\bQ(Double|Int)Validator\b|QInputDialog::get(Double|Int)\b|\.toDouble\(&|\.toInt\(&)");
  std::vector<std::string> found;
  for (const SourceFile& file : sources_under({"ui", "app"})) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (!file.path.starts_with("ui/fields/") && std::regex_search(file.lines[i], own_reading)) {
        found.push_back(file.path + ":" + std::to_string(i + 1) + ": " + file.lines[i]);
      }
    }
  }
  EXPECT_THAT(found, testing::IsEmpty());
}

/// What differs between systems has a file for each of them, in folders posix and windows.
TEST(Layering, SystemsDifferInFilesOfTheirOwnAlone) {
  static const std::regex asks_for_system(
      R"(\b(_WIN32|_WIN64|WIN32|__MINGW\w+|__linux__|__APPLE__|__unix__|__GLIBC__|Q_OS_\w+)\b)");
  std::vector<std::string> found;
  for (const SourceFile& file : sources_under({"core", "ui", "app"})) {
    const std::string folder = fs::path(file.path).parent_path().filename().string();
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (folder != "posix" && folder != "windows" && std::regex_search(file.lines[i], asks_for_system)) {
        found.push_back(file.path + ":" + std::to_string(i + 1) + ": " + file.lines[i]);
      }
    }
  }
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(Layering, TheTopLevelHoldsWhatTheDesignNames) {
  const std::vector<std::string> allowed{
      "CMakeLists.txt", "CMakePresets.json", "LICENSE",   "README.md", "app",   "build",
      "core",           "machines",          "packaging", "resources", "tests", "ui"};
  for (const auto& entry : fs::directory_iterator(FEEDSCOPE_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.starts_with(".") || std::find(allowed.begin(), allowed.end(), name) != allowed.end())
        << name;
  }
}

}  // namespace
}  // namespace feedscope
