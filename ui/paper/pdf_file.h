#pragma once

#include <QRectF>
#include <QString>
#include <string>
#include <vector>

#include "ui/paper/pdf_tags.h"

namespace feedscope::ui {

/// A place in the outline of a PDF file.
struct PdfBookmark {
  int level = 1;  ///< 1: outermost
  QString title;
  int page = 0;    ///< from 0
  double top = 0;  ///< of the place, from the page's upper edge [points]
};

/// A rectangle of a page that links to a place.
struct PdfLink {
  int page = 0;  ///< from 0
  QRectF area;   ///< from the page's upper left corner [points]
  QString title;
  int to_page = 0;
  double to_top = 0;  ///< as PdfBookmark::top
};

struct PdfProperties {
  QString title;
  QString author;
  QString date;  ///< of creation, in PDF notation: "D:20250131120000Z"; empty: none
  std::vector<PdfBookmark> outline;
  QString language = {};  ///< code of the texts; empty: not set
  std::vector<PdfLink> links = {};
  std::vector<PdfTag> tags = {};  ///< marked by mark_tag() on the pages
};

/// During its lifetime, new hash tables have one order: QPdfWriter numbers its fonts by one.
class StableOrder {
 public:
  StableOrder();
  ~StableOrder();
  StableOrder(const StableOrder&) = delete;
  StableOrder& operator=(const StableOrder&) = delete;
};

/// The file of QPdfWriter with title, author, bookmarks, links and tags. Without a creation time unless
/// requested, and with an identifier derived from the contents: the same pages give the same bytes.
std::string finished_pdf(const std::string& pdf, const PdfProperties& properties);

}  // namespace feedscope::ui
