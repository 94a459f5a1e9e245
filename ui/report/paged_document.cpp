#include "ui/report/paged_document.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextObjectInterface>
#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <utility>

#include "ui/report/template_pictures.h"
#include "ui/report/whole_units.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

/// Pictures of the report where the text has them.
class PagedDocument::Pictures : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  Pictures(const ReportPictures& pictures, double raster_ratio)
      : pictures_(pictures), raster_ratio_(raster_ratio) {}

  QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat& format) override {
    const QTextImageFormat image = format.toImageFormat();
    QSizeF size(image.width(), image.height());
    const InlinePicture* inside = inside_of(image.name());
    if (inside != nullptr && !(size.width() > 0 && size.height() > 0)) {
      const double scale = size.width() > 0    ? size.width() / inside->size().width()
                           : size.height() > 0 ? size.height() / inside->size().height()
                                               : 1;
      size = inside->size() * scale;
    }
    const double fitted = std::min({1.0, report_width / size.width(), page_contents_height / size.height()});
    return fitted < 1 ? size * fitted : size;
  }
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int,
                  const QTextFormat& format) override {
    const bool touches_only = place.intersected(page_).height() < 1;
    if (failure_ || touches_only) {
      return;
    }
    const QString name = format.toImageFormat().name();
    if (const InlinePicture* inside = inside_of(name)) {
      inside->draw(*painter, place);
      return;
    }
    const auto found = pictures_.all().find(name.section(':', 1));
    if (found == pictures_.all().end()) {
      return;
    }
    painter->save();
    painter->translate(place.topLeft());
    painter->setClipRect(QRectF(QPointF(), found->second.size), Qt::IntersectClip);
    try {
      pictures_.paint(found->first, *painter, raster_ratio_);
    } catch (...) {
      failure_ = std::current_exception();  // QTextDocument passes no exceptions on
    }
    painter->restore();
  }

  /// The part of the text that is drawn now: QTextDocument draws what only touches it too.
  void set_page(const QRectF& page) { page_ = page; }
  /// Throws what painting a picture threw.
  void check() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  const InlinePicture* inside_of(const QString& name) {
    if (!name.startsWith(QStringLiteral("data:"))) {
      return nullptr;
    }
    auto found = inside_.find(name);
    if (found == inside_.end()) {
      found = inside_.emplace(name, InlinePicture::from_url(name)).first;
    }
    return found->second ? &*found->second : nullptr;
  }

  const ReportPictures& pictures_;
  double raster_ratio_;
  std::map<QString, std::optional<InlinePicture>> inside_;
  QRectF page_;
  std::exception_ptr failure_;
};

void set_on_paper(QTextDocument& document, QString html) {
  document.setDefaultFont(paper_font(11));
  document.setUseDesignMetrics(true);
  document.setDocumentMargin(0);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  document.setDefaultTextOption(option);
  document.setHtml(
      with_whole_units(std::move(html)).replace(QStringLiteral("<wbr>"), QStringLiteral("&#8203;")));
  document.setTextWidth(report_width);
}

PagedDocument::PagedDocument(QString html, const ReportPictures& pictures, double raster_ratio)
    : pictures_(std::make_unique<Pictures>(pictures, raster_ratio)) {
  document_.documentLayout()->registerHandler(QTextFormat::ImageObject, pictures_.get());
  set_on_paper(document_, std::move(html));
  parts_ = page_parts(document_, page_contents_height);
}

PagedDocument::~PagedDocument() = default;

PagedDocument::Place PagedDocument::place_of(double top) const {
  constexpr double rounding = 0.5;
  const auto next = std::ranges::upper_bound(parts_, top + rounding, {}, &PagePart::top);
  const auto found = next == parts_.begin() ? next : std::prev(next);
  return {static_cast<int>(found - parts_.begin()), found->head() + std::max(0.0, top - found->top)};
}

void PagedDocument::draw_part(QPainter& painter, double from, double to, double at) {
  const QRectF part(0, from, report_width, to - from);
  pictures_->set_page(part);
  painter.save();
  painter.translate(0, at - from);
  painter.setClipRect(part);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = part;
  context.palette.setColor(QPalette::Text, Qt::black);
  document_.documentLayout()->draw(&painter, context);
  painter.restore();
  pictures_->check();
}

void PagedDocument::draw(QPainter& painter, int page) {
  const PagePart& part = parts_[static_cast<std::size_t>(page)];
  if (part.head() > 0) {
    draw_part(painter, part.head_top, part.head_bottom, 0);
  }
  if (part.bottom > part.top) {
    draw_part(painter, part.top, part.clip_bottom, part.head());
  }
}

}  // namespace feedscope::ui

#include "paged_document.moc"
