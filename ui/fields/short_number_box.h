#pragma once

#include "ui/fields/number_box.h"
#include "ui/fields/number_text.h"

namespace feedscope::ui {

/// A number without trailing zeros, for values of any size.
class ShortNumberBox : public NumberBox {
 public:
  using NumberBox::NumberBox;

  QString textFromValue(double value) const override { return editable_text(value); }
};

}  // namespace feedscope::ui
