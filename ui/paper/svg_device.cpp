#include "ui/paper/svg_device.h"

#include <QBuffer>
#include <QGlyphRun>
#include <QImage>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPen>
#include <QPixmap>
#include <QRawFont>
#include <QTextLayout>
#include <cmath>

namespace feedscope::ui {

namespace {

constexpr int dots_per_inch = 96;

/// Rounds to thousandths of a unit, without trailing zeros.
QByteArray number(double value) {
  const double rounded = std::round(value * 1000) / 1000;
  return QByteArray::number(rounded == 0 ? 0.0 : rounded, 'g', 10);
}

/// Whether a path has the form of QPainterPath::addRect.
bool is_rectangle(const QPainterPath& path) {
  if (path.elementCount() != 5) {
    return false;
  }
  for (int i = 1; i < 5; ++i) {
    if (path.elementAt(i).type != QPainterPath::LineToElement) {
      return false;
    }
  }
  const auto at = [&](int i) { return QPointF(path.elementAt(i)); };
  return at(0) == at(4) && at(0).y() == at(1).y() && at(1).x() == at(2).x() && at(2).y() == at(3).y() &&
         at(3).x() == at(0).x();
}

/// A point in whole thousandths of a unit, so that rounding errors do not add up.
struct Place {
  long long x = 0;
  long long y = 0;
};

/// Directions from a point in which a line passes all previous points within a thickness.
class Sector {
 public:
  explicit Sector(Place from) : from_(from) {}

  /// Whether a line to `to` passes all previous points, none of which is farther away.
  bool takes(Place to) {
    const QPointF way(static_cast<double>(to.x - from_.x), static_cast<double>(to.y - from_.y));
    const double distance = std::hypot(way.x(), way.y());
    if (distance < reached_) {
      return false;
    }
    reached_ = distance;
    if (distance <= thickness) {
      return true;
    }
    if (known_ && (cross(low_, way) < 0 || cross(way, high_) < 0 || QPointF::dotProduct(low_, way) < 0)) {
      return false;
    }
    const double sine = thickness / distance;
    const double cosine = std::sqrt(1 - sine * sine);
    const QPointF low(way.x() * cosine + way.y() * sine, way.y() * cosine - way.x() * sine);
    const QPointF high(way.x() * cosine - way.y() * sine, way.y() * cosine + way.x() * sine);
    low_ = known_ && cross(low_, low) < 0 ? low_ : low;
    high_ = known_ && cross(high, high_) < 0 ? high_ : high;
    known_ = true;
    return true;
  }

 private:
  static constexpr double thickness = 5;  // [thousandths], invisible on screen and paper
  static double cross(const QPointF& a, const QPointF& b) { return a.x() * b.y() - a.y() * b.x(); }

  Place from_;
  double reached_ = 0;
  bool known_ = false;
  QPointF low_;
  QPointF high_;
};

/// A path as steps from the end of the previous one, in the fewest characters: points on a straight line are
/// omitted.
class RelativeSteps {
 public:
  QByteArray of(const QPainterPath& path) {
    for (int i = 0; i < path.elementCount(); ++i) {
      if (path.elementAt(i).isCurveTo()) {
        write('c', {place(path, i), place(path, i + 1), place(path, i + 2)});
        i += 2;
      } else if (path.elementAt(i).isMoveTo()) {
        write('m', {place(path, i)});
      } else {
        i = last_of_line(path, i);
        line_to(place(path, i));
      }
    }
    return data_;
  }

 private:
  static Place place(const QPainterPath& path, int i) {
    const QPainterPath::Element& element = path.elementAt(i);
    return {std::llround(element.x * thousand), std::llround(element.y * thousand)};
  }
  int last_of_line(const QPainterPath& path, int i) const {
    Sector sector(at_);
    sector.takes(place(path, i));
    while (i + 1 < path.elementCount() && path.elementAt(i + 1).isLineTo() &&
           sector.takes(place(path, i + 1))) {
      ++i;
    }
    return i;
  }
  void line_to(Place to) {
    if (to.y == at_.y) {
      command('h');
      add(to.x - at_.x);
    } else if (to.x == at_.x) {
      command('v');
      add(to.y - at_.y);
    } else {
      write('l', {to});
    }
    at_ = to;
  }
  void write(char name, std::initializer_list<Place> places) {
    command(name);
    for (const Place& to : places) {
      add(to.x - at_.x);
      add(to.y - at_.y);
    }
    at_ = *(places.end() - 1);
  }
  /// Omits a command that previous numbers imply: after a move, further numbers are lines.
  void command(char name) {
    if (name == 'm' || (name != command_ && !(name == 'l' && command_ == 'm'))) {
      data_ += name;
      number_.clear();
    }
    command_ = name;
  }
  void add(long long step) {
    QByteArray text = QByteArray::number(static_cast<double>(step) / thousand, 'g', 12);
    if (text.startsWith("0.") || text.startsWith("-0.")) {
      text.remove(text.indexOf('0'), 1);
    }
    const bool ends_itself =
        number_.isEmpty() || text.front() == '-' || (text.front() == '.' && number_.contains('.'));
    data_ += (ends_itself ? "" : " ") + text;
    number_ = text;
  }

  static constexpr double thousand = 1000;
  QByteArray data_;
  QByteArray number_;  ///< the last number, unless a command follows it
  char command_ = 0;
  Place at_;
};

QByteArray path_data(const QPainterPath& path) {
  if (is_rectangle(path)) {
    const QPointF corner = path.elementAt(0);
    const QPointF opposite = path.elementAt(2);
    return 'M' + number(corner.x()) + ' ' + number(corner.y()) + 'H' + number(opposite.x()) + 'V' +
           number(opposite.y()) + 'H' + number(corner.x()) + 'z';
  }
  return RelativeSteps().of(path);
}

QByteArray colour_of(const char* name, const QColor& colour) {
  QByteArray text = QByteArray(" ") + name + "=\"" + colour.name().toLatin1() + '"';
  if (colour.alpha() < 255) {
    text += QByteArray(" ") + name + "-opacity=\"" + number(colour.alphaF()) + '"';
  }
  return text;
}

QByteArray transform_of(const QTransform& t) {
  if (t.isIdentity()) {
    return {};
  }
  QByteArray text = " transform=\"matrix(";
  for (const double value : {t.m11(), t.m12(), t.m21(), t.m22(), t.dx()}) {
    text += QByteArray::number(value, 'g', 8) + ' ';
  }
  return text + QByteArray::number(t.dy(), 'g', 8) + ")\"";
}

QByteArray fill_of(const QBrush& brush) {
  return brush.style() == Qt::NoBrush ? QByteArray(" fill=\"none\"") : colour_of("fill", brush.color());
}

/// Line colour, written for each element, because it may change from one line to the next.
QByteArray stroke_colour_of(const QPen& pen) {
  return pen.style() == Qt::NoPen ? QByteArray() : colour_of("stroke", pen.color());
}

/// All other attributes of a pen.
QByteArray stroke_of(const QPen& pen) {
  if (pen.style() == Qt::NoPen) {
    return {};
  }
  const double width = pen.widthF() > 0 ? pen.widthF() : 1;
  QByteArray text = " stroke-width=\"" + number(width) + '"';
  if (pen.isCosmetic()) {
    text += " vector-effect=\"non-scaling-stroke\"";
  }
  text += pen.capStyle() == Qt::RoundCap    ? " stroke-linecap=\"round\""
          : pen.capStyle() == Qt::SquareCap ? " stroke-linecap=\"square\""
                                            : "";
  text += pen.joinStyle() == Qt::RoundJoin   ? " stroke-linejoin=\"round\""
          : pen.joinStyle() == Qt::BevelJoin ? " stroke-linejoin=\"bevel\""
                                             : "";
  if (pen.style() != Qt::SolidLine) {
    QByteArray dashes;
    for (const double dash : pen.dashPattern()) {
      dashes += (dashes.isEmpty() ? "" : ",") + number(dash * width);
    }
    text += " stroke-dasharray=\"" + dashes + '"';
  }
  return text;
}

QByteArray path_element(const QPen& pen, const QPainterPath& path) {
  return "<path" + stroke_colour_of(pen) + " d=\"" + path_data(path) + "\"/>";
}

}  // namespace

/// Writes text as outlines of its letters, each letter once; clipped text is left to QPaintEngine, which
/// fills its outlines. Invisible text, made for searching and copying, is written as text.
class SvgDevice::Engine : public QPaintEngine {
 public:
  explicit Engine(QByteArray head) : QPaintEngine(features), head_(std::move(head)) {}

  bool begin(QPaintDevice*) override {
    body_.clear();
    clips_.clear();
    letters_.clear();
    group_.clear();
    return true;
  }
  bool end() override {
    close();
    return true;
  }
  Type type() const override { return User; }
  void updateState(const QPaintEngineState&) override {}

  void drawPath(const QPainterPath& path) override {
    const QPen pen = painter()->pen();
    const bool even = path.fillRule() == Qt::OddEvenFill;
    const Clipped shown = clipped(path, pen);
    if (!shown.path.isEmpty()) {
      add(fill_of(painter()->brush()) + (even ? " fill-rule=\"evenodd\"" : "") + stroke_of(pen),
          path_element(pen, shown.path), shown.clip);
    }
  }
  void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
    QPainterPath path;
    path.setFillRule(mode == WindingMode ? Qt::WindingFill : Qt::OddEvenFill);
    for (int i = 0; i < count; ++i) {
      i == 0 ? path.moveTo(points[i]) : path.lineTo(points[i]);
    }
    if (mode != PolylineMode) {
      path.closeSubpath();
      drawPath(path);
      return;
    }
    const Clipped shown = clipped(path, painter()->pen());
    if (!shown.path.isEmpty()) {
      add(" fill=\"none\"" + stroke_of(painter()->pen()), path_element(painter()->pen(), path), shown.clip);
    }
  }
  void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override {
    drawImage(target, pixmap.toImage(), source, Qt::AutoColor);
  }
  void drawTextItem(const QPointF& place, const QTextItem& item) override {
    if (painter()->pen().color().alpha() > 0) {
      painter()->hasClipping() ? QPaintEngine::drawTextItem(place, item) : draw_letters(place, item);
      return;
    }
    const QFont font = item.font();
    add(" fill=\"none\"",
        "<text x=\"" + number(place.x()) + "\" y=\"" + number(place.y()) + "\" font-family=\"" +
            font.family().toHtmlEscaped().toUtf8() + "\" font-size=\"" + number(font.pixelSize()) + "\">" +
            item.text().toHtmlEscaped().toUtf8() + "</text>",
        false);
  }
  void drawImage(const QRectF& target, const QImage& image, const QRectF& source,
                 Qt::ImageConversionFlags) override {
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    image.copy(source.toRect()).save(&png, "PNG");
    add({},
        "<image x=\"" + number(target.x()) + "\" y=\"" + number(target.y()) + "\" width=\"" +
            number(target.width()) + "\" height=\"" + number(target.height()) +
            "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," + png.data().toBase64() +
            "\"/>",
        true);
  }

  QByteArray file() const {
    QByteArray clips;
    for (qsizetype i = 0; i < clips_.size(); ++i) {
      clips += "<clipPath id=\"c" + QByteArray::number(i) + "\"><path d=\"" + clips_[i] + "\"/></clipPath>\n";
    }
    QByteArray letters;
    for (qsizetype i = 0; i < letters_.size(); ++i) {
      letters += "<path id=\"l" + QByteArray::number(i) + "\" d=\"" + letters_[i] + "\"/>\n";
    }
    const QByteArray used = clips + letters;
    return head_ + (used.isEmpty() ? "" : "<defs>\n" + used + "</defs>\n") + body_ + "</svg>\n";
  }

 private:
  static constexpr PaintEngineFeatures features{PrimitiveTransform | PixmapTransform | PainterPaths |
                                                AlphaBlend | ConstantOpacity | Antialiasing |
                                                PaintOutsidePaintEvent};

  void draw_letters(const QPointF& place, const QTextItem& item) {
    QTextLayout layout(item.text(), item.font(), paintDevice());
    layout.beginLayout();
    const QTextLine line = layout.createLine();
    layout.endLayout();
    const QPointF start = place - QPointF(0, line.ascent());
    const QByteArray style = colour_of("fill", painter()->pen().color());
    for (const QGlyphRun& run : layout.glyphRuns()) {
      const QList<QPointF> places = run.positions();
      for (qsizetype i = 0; i < places.size(); ++i) {
        const QPainterPath outline = run.rawFont().pathForGlyph(run.glyphIndexes()[i]);
        if (!outline.isEmpty()) {
          const QPointF at = start + places[i];
          add(style,
              "<use xlink:href=\"#l" + QByteArray::number(index_in(letters_, RelativeSteps().of(outline))) +
                  "\" x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) + "\"/>",
              false);
        }
      }
    }
  }

  /// Index of `data`, appended if it is new.
  static qsizetype index_in(QByteArrayList& list, const QByteArray& data) {
    const qsizetype known = list.indexOf(data);
    if (known < 0) {
      list.append(data);
    }
    return known < 0 ? list.size() - 1 : known;
  }

  /// A shape, and whether it still needs clipping.
  struct Clipped {
    QPainterPath path;
    bool clip = false;
  };

  /// Cuts shapes to a rectangular clip where that is simple: some SVG readers do not support clips.
  Clipped clipped(const QPainterPath& path, const QPen& pen) const {
    if (!painter()->hasClipping()) {
      return {path, false};
    }
    const QPainterPath clip = painter()->clipPath();
    const bool stroked = pen.style() != Qt::NoPen;
    const double reach = stroked ? std::max(1.0, pen.widthF()) : 0;
    const QRectF room = clip.boundingRect();
    const QRectF drawn = path.controlPointRect().adjusted(-reach, -reach, reach, reach);
    if (!room.intersects(drawn)) {
      return {};
    }
    if (is_rectangle(clip) && room.contains(drawn)) {
      return {path, false};
    }
    if (!is_rectangle(clip) || stroked) {
      return {path, true};
    }
    if (!is_rectangle(path)) {
      return {path.intersected(clip), false};
    }
    QPainterPath part;
    if (const QRectF common = path.boundingRect() & room; !common.isEmpty()) {
      part.addRect(common);
    }
    return {part, false};
  }

  /// Neighbours with the same clip and style share a group, even with different line colours.
  void add(const QByteArray& style, const QByteArray& element, bool may_be_cut) {
    const double opacity = painter()->opacity();
    const int clip = may_be_cut ? clip_now() : -1;
    QByteArray clipped;
    if (clip >= 0) {
      clipped = " clip-path=\"url(#c" + QByteArray::number(clip) + ")\"";
    }
    const QByteArray drawn = "<g" + style + transform_of(painter()->combinedTransform()) + '>';
    const QByteArray group = clipped.isEmpty() ? drawn : "<g" + clipped + '>' + drawn;
    if (opacity < 1) {
      close();
      body_ += "<g opacity=\"" + number(opacity) + "\">" + group + element + "</g></g>" +
               (clipped.isEmpty() ? "" : "</g>") + '\n';
      return;
    }
    if (group != group_) {
      close();
      body_ += group + '\n';
      group_ = group;
    }
    body_ += element + '\n';
  }

  void close() {
    body_ += QByteArray("</g>").repeated(group_.count('<')) + (group_.isEmpty() ? "" : "\n");
    group_.clear();
  }

  /// The index of the current clip; -1: none.
  int clip_now() {
    if (!painter()->hasClipping()) {
      return -1;
    }
    const QPainterPath path = painter()->combinedTransform().map(painter()->clipPath());
    return static_cast<int>(index_in(clips_, path_data(path)));
  }

  QByteArray head_;
  QByteArray body_;
  QByteArray group_;  ///< the open group
  QByteArrayList clips_;
  QByteArrayList letters_;
};

SvgDevice::SvgDevice(QSizeF size, const QString& title, const QString& width, const QString& height)
    : size_(size) {
  engine_ = std::make_unique<Engine>(
      QStringLiteral("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                     "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                     "width=\"%1\" height=\"%2\" viewBox=\"0 0 %3 %4\">\n<title>%5</title>\n")
          .arg(width, height, QString::fromLatin1(number(size.width())),
               QString::fromLatin1(number(size.height())), title.toHtmlEscaped())
          .toUtf8());
}

SvgDevice::~SvgDevice() = default;

QPaintEngine* SvgDevice::paintEngine() const {
  return engine_.get();
}

QByteArray SvgDevice::svg() const {
  return engine_->file();
}

int SvgDevice::metric(PaintDeviceMetric metric) const {
  switch (metric) {
    case PdmWidth:
      return static_cast<int>(std::ceil(size_.width()));
    case PdmHeight:
      return static_cast<int>(std::ceil(size_.height()));
    case PdmWidthMM:
      return static_cast<int>(std::lround(size_.width() / dots_per_inch * 25.4));
    case PdmHeightMM:
      return static_cast<int>(std::lround(size_.height() / dots_per_inch * 25.4));
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
      return dots_per_inch;
    case PdmDevicePixelRatio:
      return 1;
    default:
      return QPaintDevice::metric(metric);
  }
}

}  // namespace feedscope::ui
