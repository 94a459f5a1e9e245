#pragma once

#include <QDialog>
#include <filesystem>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/identification/identification_program.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace feedscope::ui {

class NumberBox;

/// Asks for control, work space and feed of the test program, shows the numbers that each of its parts
/// identifies, and writes it.
class TestProgramDialog : public QDialog {
  Q_OBJECT

 public:
  /// `dialect`: initial choice, if it has a test program. `setup`: for its times. `folder`: initial folder of
  /// files.
  TestProgramDialog(Dialect dialect, Setup setup, const std::filesystem::path& folder,
                    QWidget* parent = nullptr);

  IdentificationProgramRequest request() const;
  /// "feedscope-test.mpf".
  QString proposed_name() const;
  /// If it cannot be written, returns false, and state() has the reason.
  bool write(const std::filesystem::path& file);
  /// The written file and what to do with it, or the error.
  QString state() const;

  QComboBox& dialect() { return *dialect_; }
  NumberBox& side() { return *side_; }
  NumberBox& feed() { return *feed_; }
  QTreeWidget& parts() { return *parts_; }
  QPushButton& open_button() { return *open_; }

 signals:
  /// Requests to open the written file.
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
