#pragma once

#include <string>

#include "core/base/message.h"

namespace feedscope {

/// A model that could not be fitted while others are compared.
struct UnfittedModel {
  std::string title;  ///< of the model
  Message reason;     ///< of an InputError
  std::string id;     ///< of the model; "" where a session kept the title alone

  bool operator==(const UnfittedModel&) const = default;
};

}  // namespace feedscope
