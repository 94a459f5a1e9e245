#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/quantity.h"
#include "ui/workbench/annotation.h"

namespace feedscope::ui {

/// What a label can tell of its place.
struct AnnotationValues {
  State at;
  std::optional<ActualSample> actual = {};  ///< of a machine with drives
  std::optional<LoadSample> load = {};      ///< where operations are known
  double contour_error = 0;                 ///< [mm]
  double distance = 0;                      ///< straight, to the other place [mm]
  double duration = 0;                      ///< to the other place [s]
  QString run;                              ///< name of the run
};

/// One name that stands in braces in the text of an annotation.
struct AnnotationField {
  QString name;         ///< "feed"
  QString explanation;  ///< in the user's language
  std::function<QString(const AnnotationValues&)> value;
};
/// The quantities of the motion at the place, and what else a label can tell.
std::vector<AnnotationField> annotation_fields();

/// `text` with the values in place of "{feed}" and its like, numbers by the locale. What is no field stays.
QString with_values(const QString& text, const AnnotationValues& values);

/// The first "{name}" in `text` that is no field; empty if there is none.
QString unknown_field(const QString& text);

}  // namespace feedscope::ui
