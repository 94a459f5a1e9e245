#include "ui/annotations/annotation_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "ui/language/core_texts.h"

namespace feedscope::ui {
namespace {

struct Annotations {
  Q_DECLARE_TR_FUNCTIONS(Annotations)
};

QString number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

QString feed(double speed) {
  return Annotations::tr("%1 mm/min").arg(number(units::to_mm_min(speed), 0));
}

QString millimetres(double length) {
  return Annotations::tr("%1 mm").arg(number(length, 3));
}

using Values = AnnotationValues;
constexpr auto fields = std::to_array<AnnotationField>({
    {"feed", QT_TRANSLATE_NOOP("Annotations", "achieved feed"),
     [](const Values& v) { return feed(v.at.speed); }},
    {"programmed", QT_TRANSLATE_NOOP("Annotations", "programmed feed"),
     [](const Values& v) { return feed(v.at.programmed_feed); }},
    {"deviation", QT_TRANSLATE_NOOP("Annotations", "contour error"),
     [](const Values& v) { return Annotations::tr("%1 µm").arg(number(1000 * v.contour_error, 1)); }},
    {"cause", QT_TRANSLATE_NOOP("Annotations", "limiting cause"),
     [](const Values& v) { return core_text(cause_title(v.at.cause)); }},
    {"acceleration", QT_TRANSLATE_NOOP("Annotations", "acceleration, length of the vector"),
     [](const Values& v) {
       return Annotations::tr("%1 m/s²").arg(number(units::to_m(v.at.acceleration.norm()), 2));
     }},
    {"jerk", QT_TRANSLATE_NOOP("Annotations", "jerk, length of the vector"),
     [](const Values& v) {
       return Annotations::tr("%1 m/s³").arg(number(units::to_m(v.at.jerk.norm()), 1));
     }},
    {"line", QT_TRANSLATE_NOOP("Annotations", "line of the program"),
     [](const Values& v) { return QLocale().toString(v.at.line); }},
    {"time", QT_TRANSLATE_NOOP("Annotations", "time since the start"),
     [](const Values& v) { return Annotations::tr("%1 s").arg(number(v.at.time, 3)); }},
    {"x", QT_TRANSLATE_NOOP("Annotations", "position along X"),
     [](const Values& v) { return millimetres(v.at.position.x()); }},
    {"y", QT_TRANSLATE_NOOP("Annotations", "position along Y"),
     [](const Values& v) { return millimetres(v.at.position.y()); }},
    {"z", QT_TRANSLATE_NOOP("Annotations", "position along Z"),
     [](const Values& v) { return millimetres(v.at.position.z()); }},
    {"distance", QT_TRANSLATE_NOOP("Annotations", "straight distance between the two places"),
     [](const Values& v) { return millimetres(v.distance); }},
    {"duration", QT_TRANSLATE_NOOP("Annotations", "time between the two places"),
     [](const Values& v) { return Annotations::tr("%1 s").arg(number(v.duration, 3)); }},
    {"run", QT_TRANSLATE_NOOP("Annotations", "name of the run"), [](const Values& v) { return v.run; }},
});

const AnnotationField* find_field(const QString& name) {
  const auto found = std::ranges::find_if(
      fields, [&](const AnnotationField& field) { return name == QLatin1String(field.name); });
  return found == fields.end() ? nullptr : &*found;
}

const QRegularExpression& field_pattern() {
  static const QRegularExpression pattern(QStringLiteral("\\{([a-z]+)\\}"));
  return pattern;
}

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

std::span<const AnnotationField> annotation_fields() {
  return fields;
}

QString with_values(const QString& text, const AnnotationValues& values) {
  QString filled;
  qsizetype done = 0;
  for (auto match = field_pattern().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch name = match.next();
    if (const AnnotationField* field = find_field(name.captured(1))) {
      filled += text.mid(done, name.capturedStart() - done) + field->value(values);
      done = name.capturedEnd();
    }
  }
  return filled + text.mid(done);
}

QString unknown_field(const QString& text) {
  for (auto match = field_pattern().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch name = match.next();
    if (find_field(name.captured(1)) == nullptr) {
      return name.captured(0);
    }
  }
  return {};
}

}  // namespace feedscope::ui
