#pragma once

#include <QString>

namespace feedscope::ui {

/// A difference: "+1.25", "−1.25" with a sign as wide as a plus, "0.00" without one where no digit shows it.
QString signed_number(double value, int decimals);

}  // namespace feedscope::ui
