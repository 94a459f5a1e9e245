#pragma once

#include <string>

namespace feedscope {

/// A duration of 0 s or more to three significant figures, below 0.1 s in ms: "12.3 ms", "48.5 s", from a
/// minute on "1:48.5", from an hour on "1:02:05". Zeros at the end stay, "2.00 s": times are compared.
std::string short_time(double seconds);
/// A length of at least 0 mm with three significant digits, below 0.1 mm in um: "11.3 um", "0.25 mm".
std::string short_length(double mm);
/// A share in whole percent, below one with one nonzero digit: "8 %", "0.3 %".
std::string short_percent(double share);

}  // namespace feedscope
