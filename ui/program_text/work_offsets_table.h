#pragma once

#include <QTableWidget>

#include "core/program/program.h"

namespace feedscope::ui {

/// Zero points of the work offsets that a program uses, for its import options: one row each, with empty
/// cells without a value.
class WorkOffsetsTable : public QTableWidget {
  Q_OBJECT

 public:
  /// `program`: as read; null: not read yet.
  WorkOffsetsTable(const WorkOffsets& given, const Program* program, QWidget* parent = nullptr);

  /// Offsets with a coordinate; usable while fault() is empty.
  WorkOffsets offsets() const;
  /// The first cell that is not a number, in a sentence; empty if there is none.
  QString fault() const;
  void clear_offsets();

 private:
  void add(const std::string& name, const Vec3* zero, const QString& use);
};

}  // namespace feedscope::ui
