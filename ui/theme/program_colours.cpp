#include "ui/theme/program_colours.h"

#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

const ProgramColours light_program{.comment = QColor(0x5b, 0x75, 0x5b),
                                   .label = QColor(0x6c, 0x73, 0x7a),
                                   .block_delete = QColor(0xb0, 0x00, 0x20),
                                   .g_code = QColor(0x1f, 0x5f, 0xa8),
                                   .m_code = QColor(0x7b, 0x3f, 0xa0),
                                   .axis_x = QColor(0xb8, 0x4f, 0x00),
                                   .axis_y = QColor(0x00, 0x7a, 0x59),
                                   .axis_z = QColor(0x00, 0x5f, 0x96),
                                   .other_axis = QColor(0x5a, 0x60, 0x68),
                                   .argument = QColor(0x5a, 0x60, 0x68),
                                   .feed = QColor(0x8a, 0x5a, 0x00),
                                   .tool = QColor(0x8c, 0x2f, 0x5f),
                                   .keyword = QColor(0x00, 0x6b, 0x75),
                                   .variable = QColor(0x9a, 0x20, 0x74),
                                   .literal = QColor(0x55, 0x66, 0x00),
                                   .caret_line = QColor(0xb4, 0xba, 0xc2),
                                   .found = QColor(0xff, 0xd8, 0x6b),
                                   .found_mark = QColor(0x8a, 0x6d, 0x00),
                                   .slow = QColor(0xb8, 0x32, 0x00)};
const ProgramColours dark_program{.comment = QColor(0x8a, 0xa3, 0x8a),
                                  .label = QColor(0x8d, 0x94, 0x9b),
                                  .block_delete = QColor(0xff, 0x7b, 0x7b),
                                  .g_code = QColor(0x7f, 0xb8, 0xf0),
                                  .m_code = QColor(0xc9, 0xa2, 0xf2),
                                  .axis_x = QColor(0xff, 0x9a, 0x57),
                                  .axis_y = QColor(0x45, 0xd1, 0xa5),
                                  .axis_z = QColor(0x6f, 0xc0, 0xf0),
                                  .other_axis = QColor(0xb5, 0xbb, 0xc2),
                                  .argument = QColor(0xb5, 0xbb, 0xc2),
                                  .feed = QColor(0xf0, 0xc0, 0x60),
                                  .tool = QColor(0xf2, 0x9a, 0xc0),
                                  .keyword = QColor(0x5c, 0xc8, 0xd0),
                                  .variable = QColor(0xf0, 0x9a, 0xdc),
                                  .literal = QColor(0xc3, 0xcf, 0x7a),
                                  .caret_line = QColor(0x4c, 0x52, 0x59),
                                  .found = QColor(0x6b, 0x55, 0x10),
                                  .found_mark = QColor(0xff, 0xd3, 0x4d),
                                  .slow = QColor(0xff, 0xb0, 0x5c)};

}  // namespace

const ProgramColours& program_colours(const QPalette& palette) {
  return theme_of(palette) == ThemeKind::dark ? dark_program : light_program;
}

QColor heat_colour(double heat, const QColor& ground, const QPalette& palette) {
  const QColor& hot = program_colours(palette).slow;
  const double share = std::clamp(heat, 0.0, 1.0);
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(std::lerp(a, b, share))); };
  return {mix(ground.red(), hot.red()), mix(ground.green(), hot.green()), mix(ground.blue(), hot.blue())};
}

}  // namespace feedscope::ui
