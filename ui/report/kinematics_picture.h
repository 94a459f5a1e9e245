#pragma once

#include <QString>
#include <string>

#include "core/machine/machine.h"
#include "ui/language/language.h"

namespace feedscope::ui {

/// A drawing of the kinematics of a machine with all axes at zero, seen from the front right above: the lines
/// about which the rotary axes turn with their points and the positive sense, the linear axes, the tool
/// from the gauge point, and the chain from part to tool. Returns the bytes of a file in the format of the
/// name's ending: .png, .svg or .pdf. Texts and numbers in one of languages().
/// Creates a QApplication if there is none. Throws InputError for another ending, and for a machine without
/// rotary axes.
std::string kinematics_picture(const std::string& name, const Machine& machine,
                               const QString& language = languages().front());

}  // namespace feedscope::ui
