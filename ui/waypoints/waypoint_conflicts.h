// Conflicts between changes of waypoints made here and elsewhere: one after the other in the dock, or on the
// map from its menu. GUI thread.
#pragma once

#include <functional>
#include <optional>

#include <QFrame>

#include "edit/document.h"

class QLabel;
class QMenu;
class QPushButton;

namespace mapwright::ui {

class WaypointEditing;

enum class ConflictChoice {
  Mine,
  Theirs,
  Both,  // theirs stays, and mine becomes another one with its own name
};

/// The conflict whose version (mine or theirs) is nearest to the cursor, within `reach_m`.
std::optional<edit::Key> conflictAt(const edit::WaypointDocument& document, const Eigen::Vector2d& world_m,
                                    double reach_m);
/// Its description and the choices.
void fillConflictMenu(QMenu& menu, const edit::WaypointDocument& document, const edit::Key& key,
                      const std::function<void(ConflictChoice)>& decided);
/// Ends the conflict. Taking theirs, with its effect on mine, can be undone.
void decideConflict(WaypointEditing& editing, const edit::Key& key, ConflictChoice choice);

/// One conflict after the other, with both versions.
class ConflictBox : public QFrame {
  Q_OBJECT
 public:
  explicit ConflictBox(QWidget* parent = nullptr);

  /// Shows those of `document`, hides if there are none; it is about a selected one if that is among them.
  /// null = none.
  void refresh(const edit::WaypointDocument* document, const std::set<edit::Key>& selected);

  QPushButton* mineButton() const { return mine_; }
  QPushButton* theirsButton() const { return theirs_; }
  QPushButton* bothButton() const { return both_; }
  QPushButton* locateButton() const { return locate_; }
  QPushButton* nextButton() const { return next_; }
  QString shown() const;  // empty = nothing

 Q_SIGNALS:
  void decided(const std::string& key, mapwright::ui::ConflictChoice choice);
  void locateWanted(const std::string& key);

 private:
  void step(int by);
  void show(const edit::WaypointDocument& document);

  QLabel* text_;
  QPushButton *mine_, *theirs_, *both_, *locate_, *previous_, *next_;
  std::vector<edit::Key> keys_;
  edit::Key current_;
  const edit::WaypointDocument* document_ = nullptr;
};

}  // namespace mapwright::ui
