#include "ui/workbench/annotation.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace feedscope::ui {
namespace {

struct Annotations {
  Q_DECLARE_TR_FUNCTIONS(Annotations)
};

struct KindName {
  AnnotationKind kind;
  const char* key;
  const char* title;
};
constexpr auto kind_names = std::to_array<KindName>({
    {AnnotationKind::text, "text", QT_TRANSLATE_NOOP("Annotations", "Text")},
    {AnnotationKind::arrow, "arrow", QT_TRANSLATE_NOOP("Annotations", "Arrow")},
    {AnnotationKind::callout, "callout", QT_TRANSLATE_NOOP("Annotations", "Callout")},
    {AnnotationKind::dimension, "dimension", QT_TRANSLATE_NOOP("Annotations", "Dimension")},
    {AnnotationKind::region, "region", QT_TRANSLATE_NOOP("Annotations", "Region")},
});

const KindName& name_of(AnnotationKind kind) {
  return *std::ranges::find(kind_names, kind, &KindName::kind);
}

}  // namespace

QString annotation_key(AnnotationKind kind) {
  return QLatin1String(name_of(kind).key);
}

QString annotation_title(AnnotationKind kind) {
  return Annotations::tr(name_of(kind).title);
}

bool has_two_places(AnnotationKind kind) {
  return kind == AnnotationKind::dimension || kind == AnnotationKind::region;
}

QString first_text(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::callout:
      return QStringLiteral("{feed}\n{deviation}\n{cause}");
    case AnnotationKind::dimension:
      return QStringLiteral("{distance}");
    case AnnotationKind::region:
      return QStringLiteral("{duration}");
    case AnnotationKind::text:
    case AnnotationKind::arrow:
      break;
  }
  return Annotations::tr("Line %1").arg(QStringLiteral("{line}"));
}

}  // namespace feedscope::ui
