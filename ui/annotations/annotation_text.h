#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/run/quantity.h"
#include "ui/workbench/annotation.h"

namespace feedscope::ui {

/// Values at the place of a label.
struct AnnotationValues {
  State at;
  std::optional<ActualSample> actual = {};  ///< of a machine with drives
  std::optional<LoadSample> load = {};      ///< with known operations
  double contour_error = 0;                 ///< [mm]
  double distance = 0;                      ///< straight, to the other place [mm]
  double duration = 0;                      ///< to the other place [s]
  QString run;                              ///< name of the run
};

/// A name that may appear in braces in the text of an annotation.
struct AnnotationField {
  QString name;         ///< "feed"
  QString explanation;  ///< in the user's language
  std::function<QString(const AnnotationValues&)> value;
};
/// The quantities of the motion at the place, and the other values of labels.
std::vector<AnnotationField> annotation_fields();

/// `text` with the values in place of "{feed}" and other fields, numbers by the locale. Unknown names remain.
QString with_values(const QString& text, const AnnotationValues& values);

/// The first "{name}" in `text` that is not a field; empty if there is none.
QString unknown_field(const QString& text);

}  // namespace feedscope::ui
