#include "ui/language/unreachable_feed_text.h"

#include <QCoreApplication>

#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

QString unreachable_feed_text(const UnreachableFeed& feed) {
  return QCoreApplication::translate("texts",
                                     "Line %1 asks for a feed of %2; all axes of this machine together reach "
                                     "%3: what is lost against "
                                     "the programmed feed tells little there.")
      .arg(QString::number(feed.programmed.line), amount_text(feed.programmed.feed, Dimension::feed, 0),
           amount_text(feed.reachable, Dimension::feed, 0));
}

}  // namespace feedscope::ui
