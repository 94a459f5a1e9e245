#include "tests/core/program/heidenhain/read_heidenhain.h"

#include <fmt/format.h>

#include <cmath>

namespace feedscope {

std::string path_of(const ReadProgram& program) {
  std::string text;
  const auto number = [](double value) {
    std::string shown = fmt::format("{:.3f}", std::abs(value) < 5e-4 ? 0.0 : value);
    shown.erase(shown.find_last_not_of('0') + 1);
    return shown.ends_with('.') ? shown.substr(0, shown.size() - 1) : shown;
  };
  for (const MotionBlock& block : program.motions) {
    text += text.empty() ? "" : " ";
    if (block.motion == Motion::dwell) {
      text += number(block.dwell) + "s";
      continue;
    }
    text += block.motion == Motion::rapid ? "r" : "";
    text += number(block.target.x()) + "," + number(block.target.y()) + "," + number(block.target.z());
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
      Eigen::Index axis = 0;
      arc.axis.cwiseAbs().maxCoeff(&axis);
      text += fmt::format("({}{}{})", arc.axis[axis] > 0 ? '+' : '-', "XYZ"[axis],
                          arc.turns > 0 ? "+" + number(arc.turns) : "");
    }
  }
  return text;
}

}  // namespace feedscope
