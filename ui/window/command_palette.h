// Finds any action by name, and whatever else has one: type a few letters, press Enter.
#pragma once

#include <optional>
#include <vector>

#include <QDialog>

#include "ui/kit/findings.h"

class QLineEdit;
class QListWidget;

namespace mapwright::ui {

class Actions;

/// How well `pattern` (letters in order, gaps allowed, case-insensitive) matches `text`: higher is better,
/// nullopt = not at all. The whole text is best, then its beginning, then beginnings of its words, then any
/// part of it; letters with gaps come last. An empty pattern matches everything equally.
std::optional<int> fuzzyScore(const QString& pattern, const QString& text);

class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  /// Both must outlive this.
  CommandPalette(const Actions& actions, const Findings& findings, QWidget* parent);
  QLineEdit* field() const { return field_; }
  QListWidget* list() const { return list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void run();

  const Actions& actions_;
  std::vector<Findings::Search> searches_;
  std::vector<Finding> found_;  // listed after the commands, or before, as they match
  QLineEdit* field_;
  QListWidget* list_;
};

}  // namespace mapwright::ui
