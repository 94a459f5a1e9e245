#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace feedscope::samples {

/// Writes NC text block by block. A coordinate is left out where it did not change, as CAM systems do;
/// a block that changes nothing is not written.
/// Coordinates in mm, rounded to `decimals`; feeds in mm/min.
class NcWriter {
 public:
  explicit NcWriter(int decimals) : decimals_(decimals) {}

  void comment(std::string_view text);
  /// One line as it stands.
  void raw(std::string_view line);
  void rapid(const Eigen::Vector3d& end);
  /// `feed` 0: the feed in force.
  void line(const Eigen::Vector3d& end, double feed = 0);
  /// Arc in the XY plane around `center`.
  void arc(bool clockwise, const Eigen::Vector3d& end, const Eigen::Vector2d& center);

  const std::string& text() const { return text_; }

 private:
  void motion(std::string_view word, const Eigen::Vector3d& end, bool repeat_word);
  void append(char letter, double value);
  void finish(double feed);
  std::string number(double value) const;

  int decimals_;
  std::string text_;
  std::string block_;
  std::string word_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
};

}  // namespace feedscope::samples
