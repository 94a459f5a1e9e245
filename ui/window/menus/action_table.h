#pragma once

#include <QAbstractTableModel>
#include <QAction>
#include <QList>

namespace feedscope::ui {

/// A command with the menu that contains it.
struct ListedAction {
  QString place;  ///< "View › Standard views"
  QAction* action = nullptr;
};

/// All commands of the window: menu, name, keys. Source of the command palette and the list of keys.
class ActionTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { place, name, keys, columns };
  static constexpr int words_role = Qt::UserRole;  ///< set_everyday_words() of the command

  using QAbstractTableModel::QAbstractTableModel;

  void set_actions(QList<ListedAction> actions);
  QAction* action(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QList<ListedAction> actions_;
};

/// The text of a menu entry without mnemonic and dots.
QString plain_text(const QString& menu_text);

}  // namespace feedscope::ui
