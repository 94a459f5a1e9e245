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

/// The fields that say how a table of samples is read: for each quantity column, unit, sign and offset; how
/// columns and decimals are parted, the rate, and lines to skip.
class TraceImportFields : public QWidget {
  Q_OBJECT

 public:
  explicit TraceImportFields(QWidget* parent = nullptr);

  /// The columns that there are, by their titles; "" where a column has none.
  void set_titles(const std::vector<QString>& titles);
  /// Shows a specification; a column that is named there and not among the titles is not shown.
  void set_columns(const TraceColumns& columns);
  /// What is shown, as parse_trace_columns() reads it; "" where everything is to be found from the file.
  QString specification() const;

 signals:
  void changed();

 private:
  struct Row {
    QComboBox* column = nullptr;
    QComboBox* unit = nullptr;      ///< null: has none
    QCheckBox* mirrored = nullptr;  ///< null: has no sign
    NumberBox* offset = nullptr;    ///< null: has none
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
