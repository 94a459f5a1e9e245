#pragma once

#include <string>

namespace feedscope {

/// "1:02:05": a duration of 0 s or more to the nearest second, in hours, minutes and seconds.
std::string clock_text(double seconds);
/// "-1.250 s": to the nearest millisecond; what is nearest to none has no sign.
std::string seconds_text(double seconds);

}  // namespace feedscope
