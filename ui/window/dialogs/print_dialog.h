#pragma once

#include <QDialog>
#include <QList>
#include <QPrinter>
#include <QTemporaryDir>

#include "ui/paper/recorded_pages.h"
#include "ui/report/command_process.h"
#include "ui/window/dialogs/print_subject.h"

class QAction;
class QComboBox;
class QPrintPreviewWidget;
class QPushButton;

namespace feedscope::ui {

class StateLine;

/// Asks for the part of the window to print, shows its pages and prints them: 3D view, charts, sheet, report,
/// hand-outs of the open lesson, tables of panels. Pages are vectors, as in PDF files. All except tables are
/// laid out by the command line in a separate process.
class PrintDialog : public QDialog {
  Q_OBJECT

 public:
  /// `executable`: as of CommandProcess. Everything that `subject` points to outlives this.
  PrintDialog(PrintSubject subject, const QString& executable, QWidget* parent = nullptr);

  /// The choice of the part to print.
  QComboBox& choice() { return *choice_; }
  QPrintPreviewWidget& preview() { return *preview_; }
  /// Zoom commands of the preview: fit the page, fit its width, larger, smaller.
  const QList<QAction*>& zoom_actions() const { return zooms_; }
  /// Pages of the preview; none while they are made.
  const RecordedPages& pages() const { return pages_; }
  bool busy() const { return making_.busy(); }
  /// The last error, or the number of pages.
  QString state() const;
  QPrinter& printer() { return printer_; }
  /// Prints the pages with the settings of printer().
  void print();

 signals:
  /// Message for the status bar.
  void printed(const QString& message);

 private:
  struct Item {
    QString title;
    QStringList command;  ///< for the command line, without its output; empty: a table
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
