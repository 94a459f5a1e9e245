#pragma once

#include <QPlainTextEdit>
#include <cstdint>

namespace feedscope::ui {

/// The program's text, read only, with line numbers; one line is the current one.
class ProgramView : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit ProgramView(QWidget* parent = nullptr);

  void set_text(const QString& text);
  /// Makes a 1-based line the current one and brings it into sight; 0: none. Says nothing by line_chosen().
  void show_line(std::uint32_t line);
  std::uint32_t current_line() const { return current_; }

  int number_area_width() const;
  void paint_number_area(QPaintEvent* event);

 signals:
  /// The user went to a line, by mouse or keyboard.
  void line_chosen(std::uint32_t line);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void follow_text_cursor();
  void mark_current();
  void place_number_area();

  QWidget* number_area_;
  std::uint32_t current_ = 0;
  bool showing_ = false;  ///< the text cursor is moved by show_line() or set_text(), not by the user
};

}  // namespace feedscope::ui
