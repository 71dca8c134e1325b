// Finds any action by name: type a few letters, press Enter.
#pragma once

#include <optional>

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace mapwright::window {

class Actions;

/// How well `pattern` (letters in order, gaps allowed, case-insensitive) matches `text`: higher is better,
/// nullopt = not at all. Matches at word starts and contiguous runs count more. An empty pattern matches
/// everything equally.
std::optional<int> fuzzyScore(const QString& pattern, const QString& text);

class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  CommandPalette(const Actions& actions, QWidget* parent);
  QLineEdit* field() const { return field_; }
  QListWidget* list() const { return list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void run();

  const Actions& actions_;
  QLineEdit* field_;
  QListWidget* list_;
};

}  // namespace mapwright::window
