#pragma once

#include <string>

namespace feedscope {

/// A duration of at least 0 s as "1:02:05", to the nearest second, in hours, minutes and seconds.
std::string clock_text(double seconds);
/// A duration such as "-1.250 s", to the nearest millisecond; without a sign if rounded to zero.
std::string seconds_text(double seconds);

}  // namespace feedscope
