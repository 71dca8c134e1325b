// The picture of the map on screen while it is edited: its cells, what is undone, what is saved, and what is
// chosen to paint with. GUI-thread object; what takes long happens on the crew.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QUndoStack>

#include "map/grid_reference.h"
#include "picture/clip.h"
#include "picture/draw.h"
#include "picture/merge.h"
#include "picture/tidy.h"
#include "work/workers.h"

namespace mapwright::window {

enum class Tidying { Specks, Gaps, Edges };

/// What tidying up would change, to be looked at before it is done.
struct TidyPreview {
  Tidying what = Tidying::Specks;
  picture::Tidied found;
  picture::Patch patch;
  std::shared_ptr<const picture::EditedGrid> cells;  // as they would be
  std::vector<picture::CellRect> runs;               // what would change, as far as it can be marked
};

class PictureEditing : public QObject {
  Q_OBJECT
 public:
  explicit PictureEditing(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~PictureEditing() override;

  /// `cells`: complete. Nothing is changed yet. `holds_unknown`: unknown ground can be kept in its picture.
  void open(std::shared_ptr<const grids::GridPyramid> cells, const map::GridReference& reference,
            bool holds_unknown);
  void close();
  bool isOpen() const { return grid_ != nullptr; }
  const std::shared_ptr<picture::EditedGrid>& grid() const { return grid_; }
  const map::GridReference& reference() const { return reference_; }
  QUndoStack& undoStack() { return undo_; }

  // What is painted with.
  picture::Kind kind() const { return kind_; }
  void setKind(picture::Kind kind);
  bool holds(picture::Kind kind) const;
  int across() const { return across_; }  // of the brush, cells
  void setAcross(int cells);

  // Painting. Positions are world metres; each of them is one change to undo, a stroke as a whole.
  void beginStroke(bool eraser);
  void strokeTo(const Eigen::Vector2d& world_m);
  void endStroke();
  bool stroking() const { return stroke_.has_value(); }
  void drawLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void drawRectangle(const picture::CellRect& rect);
  void drawPolygon(const std::vector<Eigen::Vector2d>& corners_m);
  /// False: it would reach too far.
  bool fill(const Eigen::Vector2d& at_m);

  // The selection: a rectangle of cells.
  const picture::CellRect& selection() const { return selection_; }
  void select(const picture::CellRect& rect);
  bool hasCopy() const { return clip_.has_value(); }
  bool copySelection();
  void pasteAt(int left, int top);
  /// Where it was becomes unknown (free, where the picture holds no unknown).
  void moveSelection(int columns, int rows, bool leaves_copy);
  void paintSelection();

  // Tidying up, in the selection or everywhere: looked for on the crew, then shown, then done.
  void lookFor(Tidying what, int cells);
  bool looking() const { return looking_ != nullptr; }
  const std::optional<TidyPreview>& preview() const { return preview_; }
  void applyPreview();
  void dropPreview();

  // What is saved.
  std::int64_t changedCells() const { return count_.cells; }
  bool unsaved() const { return count_.cells > 0; }
  std::shared_ptr<const picture::EditedGrid> snapshot() const;
  const std::shared_ptr<const picture::EditedGrid>& saved() const { return saved_; }
  /// A change that was made elsewhere for the grid as it stands.
  void takeUp(picture::Patch patch, const QString& text) { push(std::move(patch), text); }
  /// What is kept is this now (snapshot()).
  void noteSaved(const std::shared_ptr<const picture::EditedGrid>& saved);
  /// All as it is saved; can be undone.
  void revert();
  /// Somebody else has made `theirs` of what is saved. Looked at on the crew; mergeDone() follows.
  void takeIn(std::shared_ptr<const grids::GridPyramid> theirs);
  /// Cells that both have changed, differently, and nobody has decided about.
  std::int64_t conflicts() const { return conflict_ ? conflict_->cells : 0; }
  geometry::WorldRect whereConflicts() const;
  void decide(bool take_theirs);

  picture::CellRect cellsBetween(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const;
  Eigen::Vector2d cellAt(const Eigen::Vector2d& world_m) const { return reference_.cellFromWorld(world_m); }
  geometry::WorldRect worldOf(const picture::CellRect& rect) const;

 Q_SIGNALS:
  void cellsChanged(const mapwright::geometry::WorldRect& where);
  void stateChanged();           // choices, counts, selection, preview, conflicts
  void previewChanged();         // another grid is to be shown
  void mergeDone(qint64 taken);  // takeIn() has ended

 private:
  class Command;
  void reset();
  struct Conflict {
    picture::Patch theirs;
    std::shared_ptr<const picture::EditedGrid> base;
    std::int64_t cells = 0;
    picture::CellRect where;
  };
  picture::Ink ink() const;
  picture::Ink groundInk() const;
  void push(picture::Patch patch, const QString& text);
  void take(picture::Canvas& canvas, const QString& text);
  void exchange(const picture::Patch& patch, bool forward);
  void noteTouched(const picture::Patch& patch);
  void takeDifference(const std::shared_ptr<const picture::EditedGrid>& base, const picture::Patch& theirs);
  void stopLooking();

  std::shared_ptr<picture::EditedGrid> grid_;
  std::shared_ptr<const picture::EditedGrid> saved_;
  map::GridReference reference_;
  bool holds_unknown_ = true;
  picture::Kind kind_ = picture::Kind::Occupied;
  int across_ = 3;
  std::optional<picture::Stroke> stroke_;
  bool erasing_ = false;
  picture::CellRect selection_;
  std::optional<picture::Clip> clip_;
  picture::DifferenceCount count_;
  std::optional<TidyPreview> preview_;
  std::optional<Conflict> conflict_;
  std::shared_ptr<std::atomic<bool>> looking_, merging_;  // set to stop it; null: nothing is looked for
  QUndoStack undo_;
  work::Share share_;  // last
};

}  // namespace mapwright::window
