#pragma once

#include <QImage>
#include <QWidget>
#include <filesystem>
#include <memory>
#include <vector>

#include "ui/lessons/lesson_desk.h"
#include "ui/scene/sampled_path.h"
#include "ui/shared/job.h"
#include "ui/workbench/workbench.h"

class QAbstractButton;
class QGridLayout;
class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace feedscope::ui {

/// A program supplied with Feedscope, in the start page.
struct SampleProgram {
  std::filesystem::path file;
  QString title;
  QString shows;
};
std::vector<SampleProgram> start_samples();

/// First actions, over the window while no program is open: open or drop one, continue with a recent program
/// or session, a sample with its picture, a lesson. Escape, or a request from another part of the window,
/// closes it until it is requested again; Tab stays within it.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  StartPage(const Workbench& workbench, LessonDesk& desk, QWidget* parent = nullptr);

  /// Makes it cover this part of its parent.
  void cover(const QRect& place);
  /// Shows it, even if a program is open.
  void open();
  /// Its buttons in tab order.
  std::vector<QAbstractButton*> buttons() const;
  bool busy() const { return sketching_.busy(); }

 signals:
  void program_wanted();
  void file_wanted(const std::filesystem::path& file);
  void lesson_wanted(const std::filesystem::path& file);
  void handbook_wanted();
  void shown(bool on);

 protected:
  bool focusNextPrevChild(bool next) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  using Paths = std::vector<std::shared_ptr<const SampledPath>>;

  void follow();
  QWidget* make_first_steps();
  QWidget* make_offers();
  void list_recent();
  void list_lessons();
  void sketch();
  void show_sketches();
  void place_samples();

  const Workbench& workbench_;
  LessonDesk& desk_;
  std::vector<SampleProgram> samples_;
  Paths paths_;  ///< of the samples; empty until they are read
  Job<Paths> sketching_;
  QScrollArea* scroll_;
  QVBoxLayout* recent_ = nullptr;
  QGridLayout* sample_grid_ = nullptr;
  QGridLayout* lesson_grid_ = nullptr;
  std::vector<QToolButton*> tiles_;
};

}  // namespace feedscope::ui
