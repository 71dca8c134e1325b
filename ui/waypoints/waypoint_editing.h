// The operations on the waypoints on screen, shared by the tool, the table and the form, and the selection.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <QObject>
#include <QPointer>

#include "edit/document.h"
#include "placing/arrange.h"

namespace mapwright::ui {

/// Where waypoints are during a drag: only positions and headings, so that thousands cost little.
using WaypointPreview = std::map<edit::Key, placing::Spot>;
/// It moves these, and no others. `keys`: sorted.
bool areSame(const std::vector<edit::Key>& keys, const WaypointPreview& preview);

class WaypointEditing : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// The list to edit; null = none. `unavailable_reason`: why it is read-only; empty = it is editable.
  /// `keeps`: what the store can keep.
  void setDocument(edit::WaypointDocument* document, const QString& unavailable_reason,
                   const robot::KeptFields& keeps = {});
  /// The distance of a nudge.
  void setCell(double cell_m) { cell_m_ = cell_m; }
  edit::WaypointDocument* document() const { return document_; }
  bool editable() const { return document_ && unavailable_reason_.isEmpty(); }
  QString unavailableReason() const { return unavailable_reason_; }
  const robot::KeptFields& keeps() const { return keeps_; }
  double cell() const { return cell_m_; }
  const map::Waypoint* find(const edit::Key& key) const { return document_ ? document_->find(key) : nullptr; }

  const std::set<edit::Key>& selected() const { return selected_; }
  /// The only one selected; null = none or several.
  const map::Waypoint* only() const { return selected_.size() == 1 ? find(*selected_.begin()) : nullptr; }
  /// In the order in which they were selected; those selected at once by name, as people count.
  std::vector<edit::Key> inOrder() const;
  void select(std::set<edit::Key> keys);
  void toggle(const edit::Key& key);
  void selectAll();
  void invertSelection();

  /// A drag that becomes one command.
  edit::Gesture newGesture() { return ++last_gesture_; }

  /// A new one with a unique name; it is selected.
  edit::Key add(const Eigen::Vector2d& world_m, edit::Gesture gesture = 0);
  /// New ones as one command: assigns ids, and names where missing. They are selected.
  std::set<edit::Key> addAll(std::vector<map::Waypoint> points, const QString& what,
                             edit::Gesture gesture = 0);
  /// The names that are in use.
  std::set<std::string> names() const;
  void rename(const edit::Key& key, const QString& name, edit::Gesture gesture = 0);
  /// The same of several, as one command.
  void renameAll(const std::vector<std::pair<edit::Key, QString>>& names);
  /// The new state of one item; `what`: the name of the command.
  void set(const edit::Key& key, const map::Waypoint& to, const QString& what, edit::Gesture gesture = 0);
  /// The same change of all that are selected, as one command; `what` names it, with %1 for what it is about.
  void changeSelected(const QString& what, const std::function<void(map::Waypoint&)>& change,
                      edit::Gesture gesture = 0);
  /// Restores those of these that I deleted, as stored.
  void restore(const std::vector<edit::Key>& keys);
  /// The changes as one command; those that are there afterwards are selected.
  void make(std::vector<edit::Change> changes, const QString& what);
  /// Why the selected ones cannot be deleted; empty: they can be.
  QString notRemovedReason() const;
  /// Says why not, where it cannot.
  void removeSelected();
  void moveSelected(const Eigen::Vector2d& by_m, edit::Gesture gesture = 0);

  /// Where they are drawn during a drag; empty = where they are.
  const WaypointPreview& preview() const { return preview_; }
  /// Where it is now, dragged or not; nullopt = there is none.
  std::optional<placing::Spot> spotOf(const edit::Key& key) const;
  /// Where these are, whatever is being dragged.
  std::vector<placing::Spot> spots(const std::vector<edit::Key>& keys) const;
  void setPreview(WaypointPreview preview);
  /// Applies the preview, as one command.
  void applyPreview(const QString& what);
  /// Moves several items there, as one command.
  void apply(const WaypointPreview& to, const QString& what, edit::Gesture gesture = 0);

 Q_SIGNALS:
  void opened();  // another document, or none
  void selectionChanged();
  void previewChanged();
  void removalRefused(const QString& why);
  void renameWanted(const std::string& key, quint64 gesture);  // by typing, where the list is on screen
  void renameSeveralWanted();                                  // those that are selected

 private:
  void onChange(const edit::DocumentChange& change);
  void selectAllBut(const std::set<edit::Key>& others);

  QPointer<edit::WaypointDocument> document_;
  QString unavailable_reason_;
  robot::KeptFields keeps_;
  double cell_m_ = 0.05;
  std::set<edit::Key> selected_;
  std::map<edit::Key, std::uint64_t> since_;  // since which selection each has been selected
  std::uint64_t selections_ = 0;
  WaypointPreview preview_;
  edit::Gesture last_gesture_ = 0;
};

}  // namespace mapwright::ui
