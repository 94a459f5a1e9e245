#pragma once

#include <QComboBox>

namespace feedscope::ui {

/// Asks for the language of a page or picture, each by its own name; initially that of the window.
class LanguageBox : public QComboBox {
  Q_OBJECT

 public:
  explicit LanguageBox(QWidget* parent = nullptr);

  /// The code, "fr".
  QString language() const { return currentData().toString(); }
  /// Ignores a language that is not offered.
  void choose(const QString& code);
};

/// A language's name for itself, with a capital: "Français".
QString own_name_of_language(const QString& code);

}  // namespace feedscope::ui
