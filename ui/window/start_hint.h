#pragma once

#include <QFrame>

#include "ui/workbench/workbench.h"

class QLabel;

namespace feedscope::ui {

/// What to do first, while no program is open: open one, drop one, a sample, a lesson.
class StartHint : public QFrame {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit StartHint(const Workbench& workbench, QWidget* parent = nullptr);

  QLabel* text() { return text_; }

 signals:
  void shown(bool on);
  void program_wanted();
  void sample_wanted();
  void lesson_wanted();

 private:
  void follow();
  void choose(const QString& link);

  const Workbench& workbench_;
  QLabel* text_;
};

}  // namespace feedscope::ui
