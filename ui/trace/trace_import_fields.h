#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/trace/trace_columns.h"

class QCheckBox;
class QComboBox;
class QGridLayout;

namespace feedscope::ui {

class NumberBox;
class WholeNumberBox;

/// Fields for reading a table of samples: for each quantity column, unit, sign and offset; separators of
/// columns and decimals, the rate, and lines to skip.
class TraceImportFields : public QWidget {
  Q_OBJECT

 public:
  explicit TraceImportFields(QWidget* parent = nullptr);

  /// Titles of the columns; "" for a column without one.
  void set_titles(const std::vector<QString>& titles);
  /// Shows a specification; columns that are not among the titles are not shown.
  void set_columns(const TraceColumns& columns);
  /// Specification for parse_trace_columns(); "" if everything is to be detected from the file.
  QString specification() const;

 signals:
  void changed();

 private:
  struct Row {
    QComboBox* column = nullptr;
    QComboBox* unit = nullptr;      ///< null: without a unit
    QCheckBox* mirrored = nullptr;  ///< null: without a sign
    NumberBox* offset = nullptr;    ///< null: without an offset
  };

  void add_row(TraceQuantity quantity, const QString& title, QGridLayout& grid);
  QComboBox* add_choice(const std::vector<std::pair<QString, QString>>& choices);

  std::array<Row, trace_quantity_count> rows_;
  std::vector<QString> titles_;
  QComboBox* separator_;
  QComboBox* decimal_;
  NumberBox* rate_;
  WholeNumberBox* skip_;
};

}  // namespace feedscope::ui
