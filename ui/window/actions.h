// All actions of the window, in one list: menus, tool bar, command palette and shortcut sheet are made from
// it.
#pragma once

#include <vector>

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QString>

class QWidget;

namespace mapwright::window {

/// Where a shortcut works.
enum class Reach {
  Everywhere,   // in the whole window (has Ctrl, Alt or is a function key)
  OutsideText,  // everywhere but where text is typed: a single key, which a text field takes for itself
  Map,          // while the map has the focus: a key that means something else in other places
};

class Actions : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QString menu;  // "View": the menu it stands in, and its heading in the shortcut sheet
    QAction* action;
    Reach reach;
  };

  explicit Actions(QObject* parent = nullptr) : QObject(parent) {}

  /// `id` is the object name. The tooltip gets the shortcut appended.
  QAction* add(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
               const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  QAction* addToggle(const QString& menu, const QString& id, const QString& text, const QString& icon_name,
                     const QList<QKeySequence>& shortcuts, Reach reach, const QString& tip);
  /// Lists an action that something else owns and that has no shortcuts.
  void list(const QString& menu, QAction* action) { entries_.push_back({menu, action, Reach::Everywhere}); }
  const std::vector<Entry>& entries() const { return entries_; }
  QAction* find(const QString& id) const;  // null = none

  /// Makes the shortcuts work: those of Reach::Map on `map`, the rest on `window`.
  void attach(QWidget* window, QWidget* map);

 private:
  std::vector<Entry> entries_;
};

/// "Fit (F)": an action's text without mnemonics, dots and the like.
QString plainActionText(const QAction& action);
/// "F", "Ctrl+K", "+ or =".
QString shortcutsText(const QAction& action);

}  // namespace mapwright::window
