#include "ui/report/kinematics_picture.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/units.h"
#include "ui/paper/picture_file.h"
#include "ui/theme/offscreen_application.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

constexpr double width = 900;       // [pixels]
constexpr double height = 760;      // [pixels]
constexpr double head = 70;         // above the drawing
constexpr double foot = 120;        // below it
constexpr double shown_tool = 100;  // of a tool of unknown length [mm]

/// Projection with X to the lower right, Y to the upper right, Z up.
QPointF flat(const Vec3& point) {
  return {std::sqrt(0.75) * (point.x() + point.y()), 0.5 * (point.x() - point.y()) - point.z()};
}

struct KinematicsPicture {
  Q_DECLARE_TR_FUNCTIONS(KinematicsPicture)
};

QString number(double value) {
  return QLocale().toString(value, 'g', 6);
}

QString travel_text(const RotaryAxis& axis) {
  if (!axis.minimum && !axis.maximum) {
    return KinematicsPicture::tr("turns without end");
  }
  const auto end = [](const std::optional<double>& angle) {
    return angle ? KinematicsPicture::tr("%1°").arg(number(units::to_deg(*angle)))
                 : KinematicsPicture::tr("no end");
  };
  return KinematicsPicture::tr("%1 to %2").arg(end(axis.minimum), end(axis.maximum));
}

class Drawing {
 public:
  Drawing(QPainter& painter, const Machine& machine)
      : painter_(painter),
        machine_(machine),
        kinematics_(machine.kinematics),
        colours_(theme_colours(QGuiApplication::palette())) {
    tool_ = Vec3(0, 0, -kinematics_.tool_length.value_or(shown_tool));
    std::vector<Vec3> content{Vec3::Zero(), tool_};
    for (const RotaryAxis& axis : kinematics_.rotary) {
      content.push_back(axis.point);
    }
    double extent = tool_.norm();
    for (const Vec3& point : content) {
      extent = std::max(extent, point.norm());
    }
    reach_ = 0.32 * extent;
    for (const RotaryAxis& axis : kinematics_.rotary) {
      const Vec3 along = reach_ * axis.direction.normalized();
      content.push_back(axis.point + 1.25 * along);
      content.push_back(axis.point - along);
    }
    QRectF box(flat(Vec3::Zero()), QSizeF());
    for (const Vec3& point : content) {
      const QPointF at = flat(point);
      box.setLeft(std::min(box.left(), at.x()));
      box.setRight(std::max(box.right(), at.x()));
      box.setTop(std::min(box.top(), at.y()));
      box.setBottom(std::max(box.bottom(), at.y()));
    }
    constexpr double labels = 190;  // room at the sides of the drawing
    constexpr double margin = 30;
    const QRectF room(labels, head + margin, width - 2 * labels, height - head - foot - 2 * margin);
    scale_ =
        std::min(room.width() / std::max(box.width(), 1e-9), room.height() / std::max(box.height(), 1e-9));
    shift_ = room.center() - scale_ * box.center();
  }

  void draw() {
    painter_.setRenderHint(QPainter::Antialiasing);
    draw_title();
    draw_tool();
    for (std::size_t i = 0; i < kinematics_.rotary.size(); ++i) {
      draw_rotary(kinematics_.rotary[i], colours_.axes[i % colours_.axes.size()]);
    }
    draw_linear();
    draw_chain();
  }

 private:
  QPointF at(const Vec3& point) const { return scale_ * flat(point) + shift_; }

  void font(double size, bool bold = false) {
    QFont font = painter_.font();
    font.setPixelSize(static_cast<int>(size));
    font.setBold(bold);
    painter_.setFont(font);
  }

  enum class Side { right, left };

  /// Writes a label on a side of `place`, at its height.
  void label(const QPointF& place, const QStringList& lines, const QColor& colour, Side side = Side::right) {
    font(13);
    const double line = painter_.fontMetrics().height();
    double y = place.y() - line * static_cast<double>(lines.size()) / 2;
    for (const QString& text : lines) {
      const double wide = painter_.fontMetrics().horizontalAdvance(text) + 4.0;
      const double x = std::clamp(side == Side::right ? place.x() : place.x() - wide, 4.0, width - wide);
      painter_.setPen(colour);
      painter_.drawText(QRectF(x, y, wide, line), Qt::AlignLeft | Qt::AlignVCenter, text);
      y += line;
    }
  }

  void arrow(const QPointF& from, const QPointF& to, const QColor& colour, double pen) {
    painter_.setPen(QPen(colour, pen));
    painter_.drawLine(from, to);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1) {
      return;
    }
    const QPointF along = way / length;
    const QPointF across(-along.y(), along.x());
    constexpr double size = 10;
    painter_.setBrush(colour);
    painter_.setPen(Qt::NoPen);
    painter_.drawPolygon(
        QPolygonF({to, to - size * along + 0.4 * size * across, to - size * along - 0.4 * size * across}));
  }

  void draw_title() {
    painter_.setPen(colours_.text);
    font(18, true);
    painter_.drawText(QRectF(20, 14, width - 40, 26), Qt::AlignLeft | Qt::AlignVCenter,
                      QString::fromStdString(machine_.name));
    font(13);
    painter_.drawText(
        QRectF(20, 40, width - 40, 20), Qt::AlignLeft | Qt::AlignVCenter,
        KinematicsPicture::tr("All axes at zero; lengths in mm; arrows: positive directions of the tool "
                              "against the part (ISO 841)"));
  }

  void draw_tool() {
    painter_.setPen(
        QPen(colours_.muted, 7, kinematics_.tool_length ? Qt::SolidLine : Qt::DashLine, Qt::FlatCap));
    painter_.drawLine(at(Vec3::Zero()), at(tool_));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colours_.text);
    painter_.drawEllipse(at(Vec3::Zero()), 5, 5);
    const QPointF beside(-14, 0);
    label(at(Vec3::Zero()) + beside, {KinematicsPicture::tr("gauge point (0, 0, 0)")}, colours_.text,
          Side::left);
    label(
        at(tool_) + beside,
        {kinematics_.tool_length ? KinematicsPicture::tr("tool, %1 mm").arg(number(*kinematics_.tool_length))
                                 : KinematicsPicture::tr("tool, length not given")},
        colours_.text, Side::left);
  }

  /// Draws the line, its point, and a circle about it with an arrow in the positive sense.
  void draw_rotary(const RotaryAxis& axis, const QColor& colour) {
    const Vec3 direction = axis.direction.normalized();
    const Vec3 along = reach_ * direction;
    painter_.setPen(QPen(colour, 1.5, Qt::DashDotLine));
    painter_.drawLine(at(axis.point - along), at(axis.point + along));
    arrow(at(axis.point + along), at(axis.point + 1.25 * along), colour, 2.5);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawEllipse(at(axis.point), 4.5, 4.5);

    const Vec3 aside = std::abs(direction.x()) < 0.9 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    const Vec3 u = (aside - aside.dot(direction) * direction).normalized();
    const Vec3 v = direction.cross(u);
    const Vec3 middle = axis.point + 0.75 * along;
    constexpr int steps = 40;
    constexpr double turn = 1.6 * units::pi;
    QPolygonF circle;
    for (int i = 0; i <= steps; ++i) {
      const double angle = turn * i / steps;
      circle.append(at(middle + 0.3 * reach_ * (std::cos(angle) * u + std::sin(angle) * v)));
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(colour, 2));
    painter_.drawPolyline(circle);
    arrow(circle[steps - 2], circle[steps], colour, 2);

    const QString point = KinematicsPicture::tr("(%1, %2, %3)")
                              .arg(number(axis.point.x()), number(axis.point.y()), number(axis.point.z()));
    label(at(axis.point + 1.25 * along) + QPointF(14, 0),
          {QStringLiteral("%1, %2").arg(QLatin1Char(axis.name)).arg(carrier(axis.name)), travel_text(axis),
           KinematicsPicture::tr("%1 rev/min").arg(number(units::to_turns_min(axis.velocity))),
           KinematicsPicture::tr("through %1").arg(point)},
          colour);
  }

  QString carrier(char axis) const {
    const std::string& chain = kinematics_.chain;
    return chain.find(axis) < chain.find("frame") ? KinematicsPicture::tr("turns the part")
                                                  : KinematicsPicture::tr("turns the tool");
  }

  void draw_linear() {
    const QPointF corner(70, height - foot - 60);
    constexpr double length = 44;
    for (int axis = 0; axis < 3; ++axis) {
      const QPointF way = length * flat(Vec3::Unit(axis));
      arrow(corner, corner + way, colours_.text, 1.5);
      font(13, true);
      painter_.setPen(colours_.text);
      const QPointF place = corner + 1.3 * way;
      painter_.drawText(QRectF(place.x() - 10, place.y() - 10, 20, 20), Qt::AlignCenter,
                        QString(QLatin1Char("XYZ"[axis])));
    }
  }

  /// Draws boxes from the part to the tool.
  void draw_chain() {
    std::vector<QString> boxes{KinematicsPicture::tr("part")};
    std::istringstream words(kinematics_.chain);
    for (std::string word; words >> word;) {
      boxes.push_back(word == "frame" ? KinematicsPicture::tr("frame") : QString::fromStdString(word));
    }
    boxes.push_back(KinematicsPicture::tr("tool"));
    constexpr double box_height = 34;
    constexpr double gap = 26;
    font(15, true);
    std::vector<double> widths;
    double sum = gap * static_cast<double>(boxes.size() - 1);
    for (const QString& text : boxes) {
      widths.push_back(painter_.fontMetrics().horizontalAdvance(text) + 28.0);
      sum += widths.back();
    }
    double x = (width - sum) / 2;
    const double y = height - foot + 40;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const QRectF box(x, y, widths[i], box_height);
      const RotaryAxis* rotary = boxes[i].size() == 1 ? kinematics_.find(boxes[i][0].toLatin1()) : nullptr;
      const QColor colour =
          rotary != nullptr
              ? colours_
                    .axes[static_cast<std::size_t>(rotary - kinematics_.rotary.data()) % colours_.axes.size()]
              : colours_.text;
      painter_.setBrush(Qt::NoBrush);
      painter_.setPen(QPen(colour, rotary != nullptr ? 2.5 : 1.2));
      painter_.drawRoundedRect(box, 5, 5);
      painter_.drawText(box, Qt::AlignCenter, boxes[i]);
      x += widths[i];
      if (i + 1 < boxes.size()) {
        painter_.setPen(QPen(colours_.text, 1.2));
        painter_.drawLine(QPointF(x, y + box_height / 2), QPointF(x + gap, y + box_height / 2));
        x += gap;
      }
    }
    font(13);
    painter_.setPen(colours_.text);
    painter_.drawText(
        QRectF(0, y - 28, width, 20), Qt::AlignCenter,
        KinematicsPicture::tr("Chain: axes before the frame carry the part, those behind it the tool"));
  }

  QPainter& painter_;
  const Machine& machine_;
  const MachineKinematics& kinematics_;
  const ThemeColours colours_;
  Vec3 tool_;         ///< its tip [mm]
  double reach_ = 0;  ///< half the length of the lines of rotary axes [mm]
  double scale_ = 1;
  QPointF shift_;
};

}  // namespace

std::string kinematics_picture(const std::string& name, const Machine& machine, const QString& language) {
  PictureSpec spec;
  spec.format = picture_format_of(name);
  if (machine.kinematics.empty()) {
    throw InputError(message(NC_("core",
                                 "machine '{}' has no rotary axes to draw; choose a machine with "
                                 "[kinematics], such as five-axis-table-ac"),
                             machine.id));
  }
  chain_of(machine.kinematics);
  const OffscreenApplication application;
  if (language != languages().front()) {
    speak(language);
  }
  spec.size = QSizeF(width, height);
  spec.title = QString::fromStdString(machine.name);
  return make_picture(spec, [&machine](QPainter& painter) { Drawing(painter, machine).draw(); });
}

}  // namespace feedscope::ui
