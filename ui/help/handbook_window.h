#pragma once

#include <QWidget>
#include <optional>

#include "core/handbook/handbook.h"

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QTextBrowser;
class QUrl;

namespace feedscope::ui {

/// The handbook in a separate window: pages on the left, with a search, the page on the right.
class HandbookWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HandbookWindow(QWidget* parent = nullptr);

  /// Shows the window with a page of the handbook in the current language; an unknown name shows the index.
  void show_page(const QString& name);

 private:
  void load();
  void list_pages();
  void open(const QString& name, const QString& anchor);
  void follow(const QUrl& link);
  /// Goes to the next occurrence of the searched words, on this page and then on the following ones.
  void find_next();
  void mark_words();

  std::optional<Handbook> handbook_;
  QString page_;  ///< shown
  QLineEdit* search_;
  QListWidget* list_;
  QTextBrowser* text_;
};

}  // namespace feedscope::ui
