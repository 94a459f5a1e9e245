#pragma once

#include <string>

namespace feedscope {

/// A duration of 0 s or more to three significant figures, below 0.1 s in ms: "12.3 ms", "48.5 s", from a
/// minute on "1:48.5", from an hour on "1:02:05". Zeros at the end stay, "2.00 s": times are compared.
std::string short_time(double seconds);
/// A length of 0 mm or more to three significant figures, below 0.1 mm in um: "11.3 um", "0.25 mm".
std::string short_length(double mm);
/// A share to a whole percent, below one to a figure that is not 0: "8 %", "0.3 %".
std::string short_percent(double share);

}  // namespace feedscope
