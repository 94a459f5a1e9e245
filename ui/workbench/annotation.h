#pragma once

#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <QString>
#include <cstdint>

#include "core/analysis/programmed_place.h"

namespace feedscope::ui {

enum class AnnotationKind : std::uint8_t {
  text,       ///< words beside a place
  arrow,      ///< words with an arrow to the place
  callout,    ///< a framed label with a line to the place
  dimension,  ///< the straight distance between two places
  region,     ///< the stretch of path between two places, marked
};
inline constexpr AnnotationKind annotation_kinds[] = {AnnotationKind::text, AnnotationKind::arrow,
                                                      AnnotationKind::callout, AnnotationKind::dimension,
                                                      AnnotationKind::region};

/// "text", "arrow" ...: for files.
QString annotation_key(AnnotationKind kind);
/// For people.
QString annotation_title(AnnotationKind kind);
bool has_two_places(AnnotationKind kind);

/// Something that a person has put beside a place of the path.
struct Annotation {
  int id = 0;  ///< of the list that holds it
  AnnotationKind kind = AnnotationKind::callout;
  ProgrammedPlace place;
  ProgrammedPlace until;  ///< the other place of a dimension or a region
  /// Lines; "{feed}" and the other annotation_fields() become the values at the place.
  QString text;
  QPointF offset{60, -50};  ///< of the label's middle from what it belongs to [pixels at 96 dots an inch]
  /// The 3D view in which a person put the label there [pixels at 96 dots an inch]: in a larger or smaller
  /// one it is further or nearer in proportion. Empty: the same everywhere.
  QSizeF view;
  QColor colour{0xd5, 0x5e, 0x00};
  double size = 10;  ///< of the text [points]

  bool operator==(const Annotation&) const = default;
};

/// What a new annotation of a kind says: live values where the kind has some.
QString first_text(AnnotationKind kind);

}  // namespace feedscope::ui
