#pragma once

#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <QString>
#include <cstdint>

#include "core/analysis/contour/programmed_place.h"

namespace feedscope::ui {

enum class AnnotationKind : std::uint8_t {
  text,       ///< words next to a place
  arrow,      ///< words with an arrow to the place
  callout,    ///< a framed label with a line to the place
  dimension,  ///< the straight distance between two places
  region,     ///< the path between two places, highlighted
};
inline constexpr AnnotationKind annotation_kinds[] = {AnnotationKind::text, AnnotationKind::arrow,
                                                      AnnotationKind::callout, AnnotationKind::dimension,
                                                      AnnotationKind::region};

/// Key in files: "text", "arrow" ...
QString annotation_key(AnnotationKind kind);
/// Title for people.
QString annotation_title(AnnotationKind kind);
bool has_two_places(AnnotationKind kind);

/// An annotation of a person at a place of the path.
struct Annotation {
  int id = 0;  ///< in its list
  AnnotationKind kind = AnnotationKind::callout;
  ProgrammedPlace place;
  ProgrammedPlace until;  ///< the other place of a dimension or a region
  /// Lines; "{feed}" and other annotation_fields() are replaced by the values at the place.
  QString text;
  QPointF offset{60, -50};  ///< of the label's centre from its reference point [pixels at 96 dots per inch]
  /// Size of the 3D view in which a person placed the label [pixels at 96 dots per inch]: in other sizes its
  /// distance is in proportion. Empty: equal in all sizes.
  QSizeF view;
  QColor colour{0xd5, 0x5e, 0x00};
  double size = 10;  ///< of the text [points]

  bool operator==(const Annotation&) const = default;
};

/// Initial text of an annotation: live values for kinds that have some.
QString first_text(AnnotationKind kind);

}  // namespace feedscope::ui
