#pragma once

#include <QString>

namespace feedscope::ui {

/// A difference: "+1.25", "−1.25" with a minus as wide as a plus; "0.00" without a sign if it rounds to zero.
QString signed_number(double value, int decimals);

}  // namespace feedscope::ui
