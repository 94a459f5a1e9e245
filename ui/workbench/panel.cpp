#include "ui/workbench/panel.h"

namespace feedscope::ui {

void Panel::follow(Workbench& /*workbench*/) {}

}  // namespace feedscope::ui
