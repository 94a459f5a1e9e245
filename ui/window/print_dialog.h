#pragma once

#include <QDialog>
#include <QList>
#include <QPrinter>
#include <QTemporaryDir>

#include "ui/report/command_process.h"
#include "ui/report/recorded_pages.h"
#include "ui/window/print_subject.h"

class QAction;
class QComboBox;
class QPrintPreviewWidget;
class QPushButton;

namespace feedscope::ui {

class StateLine;

/// Asks what of the window is to be printed, shows its pages and prints them: 3D view, charts, sheet, report,
/// hand-outs of the open lesson, tables of panels. Pages are vectors, as in PDF files. All but tables are
/// laid out by the command line in a process of its own.
class PrintDialog : public QDialog {
  Q_OBJECT

 public:
  /// `executable`: as of CommandProcess. What `subject` points to outlives this.
  PrintDialog(PrintSubject subject, const QString& executable, QWidget* parent = nullptr);

  /// What can be printed.
  QComboBox& choice() { return *choice_; }
  QPrintPreviewWidget& preview() { return *preview_; }
  /// How large the preview shows its pages: fit the page, fit its width, larger, smaller.
  const QList<QAction*>& zoom_actions() const { return zooms_; }
  /// What the preview shows; no pages while they are made.
  const RecordedPages& pages() const { return pages_; }
  bool busy() const { return making_.busy(); }
  /// What went wrong last, or how many pages there are.
  QString state() const;
  QPrinter& printer() { return printer_; }
  /// Prints the pages with printer() as it is.
  void print();

 signals:
  /// For the status bar.
  void printed(const QString& message);

 private:
  struct Item {
    QString title;
    QStringList command;  ///< of the command line, without its output; empty: a table
    PrintedTable table;
  };

  void list_items();
  void make_zooms();
  void make_layout();
  void make_pages();
  void read_pages();
  void show_pages(RecordedPages pages);
  void ask_and_print();

  PrintSubject subject_;
  QTemporaryDir folder_;
  QList<Item> items_;
  RecordedPages pages_;
  QPrinter printer_;
  QComboBox* choice_;
  QPrintPreviewWidget* preview_;
  QList<QAction*> zooms_;
  StateLine* state_;
  QPushButton* print_;
  CommandProcess making_;
};

}  // namespace feedscope::ui
