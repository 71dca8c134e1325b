// Resolves conflicts between changes made here and elsewhere, one waypoint after the other: shows both
// versions. GUI thread.
#pragma once

#include <QFrame>

#include "edit/document.h"

class QLabel;
class QPushButton;

namespace mapwright::window {

class ConflictBox : public QFrame {
  Q_OBJECT
 public:
  explicit ConflictBox(QWidget* parent = nullptr);

  /// Shows those of `document`, hides if there are none; a selected one comes first. null = none.
  void refresh(const edit::WaypointDocument* document, const std::set<edit::Key>& selected);

  QPushButton* mineButton() const { return mine_; }
  QPushButton* theirsButton() const { return theirs_; }
  QPushButton* nextButton() const { return next_; }
  QString shown() const;  // empty = nothing

 Q_SIGNALS:
  void decided(const std::string& key, bool mine);
  void locateWanted(const std::string& key);

 private:
  void step(int by);
  void show(const edit::WaypointDocument& document);

  QLabel* text_;
  QPushButton *mine_, *theirs_, *previous_, *next_, *locate_;
  std::vector<edit::Key> keys_;
  edit::Key current_;
  std::set<edit::Key> selected_;
  const edit::WaypointDocument* document_ = nullptr;
};

}  // namespace mapwright::window
