#pragma once

#include <string>

#include "core/base/message.h"

namespace feedscope {

/// A model that could not be fitted when several were compared.
struct UnfittedModel {
  std::string title;  ///< of the model
  Message reason;     ///< of an InputError
  std::string id;     ///< of the model; "" if a session stored only the title

  bool operator==(const UnfittedModel&) const = default;
};

}  // namespace feedscope
