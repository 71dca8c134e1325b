// The overlays that are edited, with what is selected and what the hand is doing, shared by the tool, the
// list and the form. GUI thread.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <QObject>
#include <QUndoStack>

#include "geometry/rect.h"
#include "overlays/editing_document.h"
#include "overlays/overlay_edits.h"

namespace mapwright::edit {

class OverlayEditing : public QObject {
  Q_OBJECT
 public:
  /// Features as they would be.
  using Preview = std::map<overlays::FeatureKey, overlays::Feature>;
  /// What is done with one gesture is one step; 0 = a step of its own.
  using Gesture = quint64;

  explicit OverlayEditing(QObject* parent = nullptr);
  ~OverlayEditing() override;

  void open(overlays::OverlayDocument held);
  void close();
  bool isOpen() const { return open_; }
  const overlays::EditingDocument& document() const { return document_; }
  QUndoStack& undoStack() { return undo_; }
  /// Nothing can be changed at present; what is undone or redone follows afterwards.
  void setLocked(bool locked);
  /// The overlays are in a file, not on a robot: texts say so.
  void setInFile(bool in_file) { in_file_ = in_file; }
  bool inFile() const { return in_file_; }
  bool editable() const { return open_ && !locked_; }

  const std::set<overlays::FeatureKey>& selected() const { return selected_; }
  void select(std::set<overlays::FeatureKey> keys);
  void toggle(overlays::FeatureKey key);
  /// nullopt: none, or several.
  std::optional<overlays::FeatureKey> only() const;
  /// As shown: of the preview, otherwise of the document; null = it is not there.
  const overlays::Feature* find(overlays::FeatureKey key) const;

  void setPreview(Preview preview);
  const Preview& preview() const { return preview_; }
  /// Makes a step of it.
  void applyPreview(const QString& text);

  Gesture newGesture() { return ++last_gesture_; }
  void set(overlays::FeatureKey key, const overlays::Feature& feature, const QString& text,
           Gesture gesture = 0);
  /// What it makes of each that is selected.
  void changeSelected(const QString& text,
                      const std::function<overlays::Feature(const overlays::Feature&)>& how,
                      Gesture gesture = 0);
  void removeSelected();
  /// Deleted ones, as the robot holds them.
  void restore(const std::set<overlays::FeatureKey>& keys);
  void duplicateSelected();
  /// New ones as they are, which are selected then, and others in the place of present ones: one step.
  std::vector<overlays::FeatureKey> put(const std::vector<overlays::Feature>& added,
                                        const std::map<overlays::FeatureKey, overlays::Feature>& changed,
                                        const QString& text);
  std::string newId() const;
  /// A new one, which is selected then.
  overlays::FeatureKey add(overlays::Shape shape, const std::vector<Eigen::Vector2d>& points, int type);
  /// As a GeoJSON collection; empty: nothing is selected.
  std::string copied() const;
  /// As new ones: in their place, or around another. Ids that are taken become new ones.
  void paste(const std::vector<overlays::Feature>& features, const std::optional<Eigen::Vector2d>& at_m);
  /// Bounds of the selected ones, as shown.
  geometry::WorldRect bounds() const;
  /// "move virtual wall W17", "move 3 features".
  QString saying(const QString& pattern) const;

  // What the robot holds (overlays/editing_document.h).
  /// `saved`: what is here was sent and is there now.
  void rebase(const overlays::OverlayDocument& theirs, bool saved);
  void keepMine(const overlays::EditingDocument::Conflict& conflict);
  void useTheirs(const overlays::EditingDocument::Conflict& conflict);
  void restoreDraft(const overlays::OverlayDocument& base, const overlays::OverlayDocument& mine,
                    const QString& text);
  /// All as the robot holds it; can be undone.
  void revert();
  /// The features of `version`, as one step; those that are the same stay as they are.
  void become(const overlays::OverlayDocument& version, const QString& text);

 Q_SIGNALS:
  void opened();   // or closed
  void changed();  // features, their states, conflicts
  void editableChanged();
  void selectionChanged();
  void previewChanged();

 private:
  class Command;
  void record(const QString& text, const std::function<void()>& what);
  void change(std::vector<overlays::FeatureEdit> edits, const QString& text, Gesture gesture = 0);
  void step(bool forward);
  void prune();
  std::vector<overlays::Feature> madeFree(const std::vector<overlays::Feature>& features) const;

  overlays::EditingDocument document_;
  QUndoStack undo_;
  bool open_ = false, locked_ = false, in_file_ = false;
  int waiting_ = 0;  // steps to redo once it can be changed; < 0: to undo
  std::set<overlays::FeatureKey> selected_;
  Preview preview_;
  Gesture gesture_ = 0, last_gesture_ = 0;
};

}  // namespace mapwright::edit
