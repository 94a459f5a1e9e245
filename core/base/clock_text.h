#pragma once

#include <string>

namespace feedscope {

/// "1:02:05": a duration of 0 s or more to the nearest second, in hours, minutes and seconds.
std::string clock_text(double seconds);

}  // namespace feedscope
