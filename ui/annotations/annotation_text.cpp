#include "ui/annotations/annotation_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

#include "core/analysis/run/quantity.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

struct Annotations {
  Q_DECLARE_TR_FUNCTIONS(Annotations)
};

using Values = AnnotationValues;

AnnotationField field_of(const QuantityInfo& quantity) {
  QString title = core_text(std::string(quantity.title));
  if (quantity.axis >= 0) {
    title = title.arg(QLatin1Char(coordinate_names[static_cast<std::size_t>(quantity.axis)]));
  }
  return {QString::fromStdString(std::string(quantity.key)), title, [&quantity](const Values& v) {
            const double value =
                quantity.of(Instant(v.at, v.actual ? &*v.actual : nullptr, v.load ? &*v.load : nullptr));
            return std::isnan(value) ? QStringLiteral("–") : amount_text(value, quantity.dimension);
          }};
}

const QRegularExpression& field_pattern() {
  static const QRegularExpression pattern(QStringLiteral("\\{([a-z_]+)\\}"));
  return pattern;
}

}  // namespace

std::vector<AnnotationField> annotation_fields() {
  std::vector<AnnotationField> fields;
  for (const QuantityInfo& quantity : all_quantities()) {
    if (quantity.axis < 0 || quantity.dimension == Dimension::length) {
      fields.push_back(field_of(quantity));
    }
  }
  const AnnotationField own[] = {
      {"programmed", Annotations::tr("programmed feed"),
       [](const Values& v) { return amount_text(v.at.programmed_feed, Dimension::feed); }},
      {"deviation", Annotations::tr("contour error"),
       [](const Values& v) { return amount_text(v.contour_error, Dimension::error); }},
      {"cause", Annotations::tr("limiting cause"), [](const Values& v) { return shown_cause(v.at.cause); }},
      {"distance", Annotations::tr("straight-line distance between the two places"),
       [](const Values& v) { return amount_text(v.distance, Dimension::length); }},
      {"duration", Annotations::tr("time between the two places"),
       [](const Values& v) { return amount_text(v.duration, Dimension::time); }},
      {"run", Annotations::tr("name of the run"), [](const Values& v) { return v.run; }},
  };
  fields.insert(fields.end(), std::begin(own), std::end(own));
  return fields;
}

QString with_values(const QString& text, const AnnotationValues& values) {
  const std::vector<AnnotationField> fields = annotation_fields();
  QString filled;
  qsizetype done = 0;
  for (auto match = field_pattern().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch name = match.next();
    const auto field = std::ranges::find(fields, name.captured(1), &AnnotationField::name);
    if (field != fields.end()) {
      filled += text.mid(done, name.capturedStart() - done) + field->value(values);
      done = name.capturedEnd();
    }
  }
  return filled + text.mid(done);
}

QString unknown_field(const QString& text) {
  const std::vector<AnnotationField> fields = annotation_fields();
  for (auto match = field_pattern().globalMatch(text); match.hasNext();) {
    const QRegularExpressionMatch name = match.next();
    if (std::ranges::find(fields, name.captured(1), &AnnotationField::name) == fields.end()) {
      return name.captured(0);
    }
  }
  return {};
}

}  // namespace feedscope::ui
