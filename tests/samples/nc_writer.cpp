#include "tests/samples/nc_writer.h"

#include <fmt/format.h>

namespace feedscope::samples {

void NcWriter::comment(std::string_view text) {
  text_ += fmt::format("({})\n", text);
}

void NcWriter::raw(std::string_view line) {
  text_ += fmt::format("{}\n", line);
}

void NcWriter::rapid(const Eigen::Vector3d& end) {
  motion("G0", end, false);
  finish(0);
}

void NcWriter::line(const Eigen::Vector3d& end, double feed) {
  motion("G1", end, false);
  finish(feed);
}

void NcWriter::arc(bool clockwise, const Eigen::Vector3d& end, const Eigen::Vector2d& center) {
  const Eigen::Vector2d offset = center - position_.head<2>();
  motion(clockwise ? "G2" : "G3", end, true);
  append('I', offset.x());
  append('J', offset.y());
  finish(0);
}

void NcWriter::motion(std::string_view word, const Eigen::Vector3d& end, bool repeat_word) {
  block_.clear();
  if (repeat_word || word != word_) {
    block_ = word;
    word_ = word;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (number(end[axis]) != number(position_[axis])) {
      append("XYZ"[axis], end[axis]);
    }
  }
  position_ = end;
}

void NcWriter::append(char letter, double value) {
  block_ += fmt::format("{}{}{}", block_.empty() ? "" : " ", letter, number(value));
}

void NcWriter::finish(double feed) {
  if (feed > 0) {
    append('F', feed);
  }
  if (!block_.empty()) {
    raw(block_);
  }
}

std::string NcWriter::number(double value) const {
  std::string digits = fmt::format("{:.{}f}", value, decimals_);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') {
    digits.pop_back();
  }
  return digits == "-0" ? "0" : digits;
}

}  // namespace feedscope::samples
