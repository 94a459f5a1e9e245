#pragma once

#include <QDialog>
#include <filesystem>
#include <vector>

#include "core/analysis/run.h"
#include "core/identification/identification_program.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace feedscope::ui {

class NumberBox;

/// Asks for control, room and feed of the test program, shows what each of its parts tells, and writes it.
class TestProgramDialog : public QDialog {
  Q_OBJECT

 public:
  /// `dialect`: proposed, if there is a test program for it. `setup`: that its times are of. `folder`: where
  /// files are proposed.
  TestProgramDialog(Dialect dialect, Setup setup, const std::filesystem::path& folder,
                    QWidget* parent = nullptr);

  IdentificationProgramRequest request() const;
  /// "feedscope-test.mpf".
  QString proposed_name() const;
  /// False, and state() says why, if it cannot be written.
  bool write(const std::filesystem::path& file);
  /// What has been written and what to do with it, or what went wrong.
  QString state() const;

  QComboBox& dialect() { return *dialect_; }
  NumberBox& side() { return *side_; }
  NumberBox& feed() { return *feed_; }
  QTreeWidget& parts() { return *parts_; }
  QPushButton& open_button() { return *open_; }

 signals:
  /// The file that was written is to be opened.
  void open_wanted(const std::filesystem::path& file);

 private:
  void make_layout();
  void refresh();
  std::vector<QString> times_of(const IdentificationProgram& program) const;
  void ask_and_write();

  Setup setup_;
  std::filesystem::path folder_;
  std::filesystem::path written_;
  QComboBox* dialect_;
  NumberBox* side_;
  NumberBox* feed_;
  QLabel* room_;
  QTreeWidget* parts_;
  QLabel* state_;
  QPushButton* write_;
  QPushButton* open_;
};

}  // namespace feedscope::ui
