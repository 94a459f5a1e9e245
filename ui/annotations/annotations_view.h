#pragma once

#include <QList>
#include <array>
#include <functional>
#include <optional>

#include "ui/annotations/annotation_table.h"
#include "ui/shared/cursor.h"
#include "ui/workbench/panel.h"

class QAction;
class QLabel;
class QPlainTextEdit;
class QTableView;
class QToolButton;

namespace feedscope::ui {

class AnnotationOverlay;
class WholeNumberBox;

/// The annotations of the program: adds one at the cursor, changes its text, colour and size, removes it.
class AnnotationsView : public Panel {
  Q_OBJECT

 public:
  /// Both outlive this.
  AnnotationsView(AnnotationList& annotations, Cursor& cursor, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  using Stretch = std::optional<std::array<double, 2>>;
  /// Sets the source of the two times [s] that a new dimension or region spans; without it, it spans the
  /// block at the cursor.
  void set_stretch(std::function<Stretch()> stretch) { stretch_ = std::move(stretch); }
  void set_toolpath(std::shared_ptr<const Toolpath> toolpath);
  /// The picture whose texts the list shows; it outlives this.
  void set_picture(const AnnotationOverlay& picture);
  /// Selects the annotation and moves the keyboard focus to its text.
  void edit(int id);

  QTableView* table() { return table_; }
  QPlainTextEdit* text() { return text_; }
  /// An action to add each kind, in the order of annotation_kinds, and one to remove the selected annotation.
  QList<QAction*> panel_actions() const override { return actions_; }

 signals:
  /// The user has chosen a row; the views should show its time [s].
  void time_chosen(double time);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_actions();
  void make_layout();
  QAction* add_action(const QString& text, const QString& tip, const QKeySequence& key);
  void add(AnnotationKind kind);
  void show_selected();
  void show_hint();
  void choose_colour();
  /// Changes the selected annotation.
  void change(const QString& name, const std::function<void(Annotation&)>& edit);

  AnnotationList& annotations_;
  Cursor& cursor_;
  std::function<Stretch()> stretch_;
  AnnotationTable* model_;
  QTableView* table_;
  QPlainTextEdit* text_;
  QToolButton* colour_;
  WholeNumberBox* size_;
  QLabel* hint_;
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
