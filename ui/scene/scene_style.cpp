#include "ui/scene/scene_style.h"

#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

const SceneColours on_light{.kind = Background::light,
                            .background = {0.984, 0.988, 0.992},
                            .text = {0.13, 0.17, 0.21},
                            .frame = {0.55, 0.60, 0.65},
                            .grid = {0.865, 0.885, 0.905},
                            .programmed = {0.50, 0.53, 0.57},
                            .rapid = {0.82, 0.68, 0.78},
                            .actual = {0.80, 0.10, 0.30},
                            .blend_edge = {0.10, 0.12, 0.15},
                            .curve_edge = {0.72, 0.76, 0.80},
                            .tool = {0.84, 0.26, 0.05},
                            .highlight = {0.80, 0.00, 0.48},
                            .axes = {Rgb{0.80, 0.27, 0.15}, Rgb{0.05, 0.50, 0.35}, Rgb{0.10, 0.35, 0.75}}};

const SceneColours on_dark{.kind = Background::dark,
                           .background = {0.106, 0.114, 0.125},
                           .text = {0.84, 0.86, 0.88},
                           .frame = {0.45, 0.48, 0.52},
                           .grid = {0.20, 0.215, 0.235},
                           .programmed = {0.50, 0.53, 0.57},
                           .rapid = {0.46, 0.34, 0.43},
                           .actual = {1.00, 0.45, 0.55},
                           .blend_edge = {0.90, 0.92, 0.94},
                           .curve_edge = {0.36, 0.41, 0.47},
                           .tool = {0.98, 0.45, 0.16},
                           .highlight = {1.00, 0.37, 0.72},
                           .axes = {Rgb{1.00, 0.54, 0.24}, Rgb{0.18, 0.79, 0.61}, Rgb{0.34, 0.71, 0.91}}};

}  // namespace

const SceneColours& scene_colours(Background kind) {
  return kind == Background::dark ? on_dark : on_light;
}

std::string SceneTexts::name_of(CauseKind kind) const {
  return cause_kind ? cause_kind(kind) : cause_title({kind, -1});
}

std::string SceneTexts::name_of(const QuantityInfo& info) const {
  return quantity ? quantity(info) : std::string(info.title);
}

std::string SceneTexts::localised(std::string number) const {
  if (const std::size_t point = number.find('.'); point != std::string::npos) {
    number.replace(point, 1, decimal_point);
  }
  if (const std::size_t minus = number.find('-'); minus != std::string::npos) {
    number.replace(minus, 1, "−");
  }
  return number;
}

}  // namespace feedscope::ui
