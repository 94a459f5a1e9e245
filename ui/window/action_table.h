#pragma once

#include <QAbstractTableModel>
#include <QAction>
#include <QList>

namespace feedscope::ui {

/// A command with the menu it stands in.
struct ListedAction {
  QString place;  ///< "View › Standard views"
  QAction* action = nullptr;
};

/// Every command of the window: menu, name, keys. What the command palette searches and the list of keys
/// shows.
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
