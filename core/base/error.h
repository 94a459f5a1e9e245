#pragma once

#include <stdexcept>
#include <string>

namespace feedscope {

/// Wrong use or unreadable input: machine file, option, call, file. The message has thing, value, place and
/// advice; the command line prints it and exits with code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace feedscope
