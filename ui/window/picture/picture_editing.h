// The picture of the map on screen while it is edited: its cells, what is undone, what is saved, and what is
// chosen to paint with. GUI-thread object; what takes long happens on the crew.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
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

/// A change to be made, and undone, and what it makes of the count of changed cells: reckoned with it where
/// that takes long.
struct PictureStep {
  picture::Patch patch;
  picture::DifferenceCount::Tiles before, after;
  quint64 of_saved = 0;  // which saved state they were counted against; 0 = they are not known
};

/// What tidying up would change, to be looked at before it is done.
struct TidyPreview {
  Tidying what = Tidying::Specks;
  picture::Tidied found;
  PictureStep step;
  std::shared_ptr<const picture::EditedGrid> cells;  // as they would be
  picture::Changes changes;                          // as far as they can be marked
  /// What the step, which is complete, makes of the grid as it is now.
  void show(const picture::EditedGrid& now);
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

  // Painting. Positions are world metres; each of them is one change to undo, a stroke as a whole. What may
  // touch very many cells is reckoned on the crew: reckoning() until it is on the map. What is asked for
  // meanwhile waits for it, strokes as well; undoing anything, and stop(), end it.
  void beginStroke(bool eraser);
  void strokeTo(const Eigen::Vector2d& world_m);
  void endStroke();
  bool stroking() const { return stroke_.has_value() || stroke_waits_; }
  void drawLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void drawRectangle(const picture::CellRect& rect);
  void drawPolygon(const std::vector<Eigen::Vector2d>& corners_m);
  /// tooLarge(): it would reach too far.
  void fill(const Eigen::Vector2d& at_m);
  bool reckoning() const { return reckoning_ != nullptr; }
  /// Nothing comes of what is under way, nor of what waits for it.
  void stop();

  // The selection: a rectangle of cells.
  const picture::CellRect& selection() const { return selection_; }
  void select(const picture::CellRect& rect);
  bool hasCopy() const { return clip_ != nullptr; }
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

  /// What undoing may take, bytes: of more the oldest steps are forgotten, never the last one.
  void setUndoBudget(std::size_t bytes) { undo_budget_ = bytes; }
  std::size_t undoBytes() const { return held_.bytes(); }

  // What is saved.
  std::int64_t changedCells() const { return count_.cells; }
  bool unsaved() const { return count_.cells > 0; }
  std::shared_ptr<const picture::EditedGrid> snapshot() const;
  const std::shared_ptr<const picture::EditedGrid>& saved() const { return saved_; }
  /// A change that was made elsewhere for the grid as it stands.
  void takeUp(picture::Patch patch, const QString& text);
  /// What is kept is this now (snapshot()).
  void noteSaved(const std::shared_ptr<const picture::EditedGrid>& saved);
  /// All as it is saved; can be undone.
  void revert();
  /// Somebody else has made `theirs` of what is saved, which makes it that revision. Looked at on the crew,
  /// and put together once the hand is up and nothing is being reckoned; mergeDone() follows. Of several that
  /// come meanwhile the last one counts. It lies under all that was done here: undoing takes back nothing of
  /// it.
  void takeIn(std::shared_ptr<const grids::GridPyramid> theirs, std::string revision);
  bool merging() const { return merging_ != nullptr; }
  /// Something of it is from here, or under way: it cannot simply be opened anew.
  bool touched() const;
  /// Cells that both have changed, differently, and nobody has decided about.
  std::int64_t conflicts() const { return conflicts_; }
  geometry::WorldRect whereConflicts() const;
  void decide(bool take_theirs);

  picture::CellRect cellsBetween(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const;
  Eigen::Vector2d cellAt(const Eigen::Vector2d& world_m) const { return reference_.cellFromWorld(world_m); }
  geometry::WorldRect worldOf(const picture::CellRect& rect) const;

 Q_SIGNALS:
  void cellsChanged(const mapwright::geometry::WorldRect& where);
  void stateChanged();    // choices, counts, selection, preview, conflicts
  void previewChanged();  // another grid is to be shown
  void mergeDone(qint64 taken, const std::string& revision);  // takeIn() has ended
  void tooLarge();
  void stepsForgotten(int steps);  // they took more than setUndoBudget()

 private:
  class Command;
  using StopFlag = std::shared_ptr<std::atomic<bool>>;
  /// On the crew: what it writes is one change. False: it would reach too far.
  using Make = std::function<bool(picture::Canvas& canvas, const std::atomic<bool>& stop)>;
  struct Taken;
  struct Coming {
    std::shared_ptr<const grids::GridPyramid> cells;
    std::string revision;
  };
  void reset();
  void change(const QString& text, std::int64_t most_cells, Make make, std::function<void()> then = {});
  void reckon(const QString& text, Make make, std::function<void()> then);
  void land(std::optional<PictureStep> step, const QString& text, const std::function<void()>& then);
  bool waits(std::function<void()> operation);
  void startStroke(bool eraser, const picture::Brush& brush);
  void forgetOldest();
  picture::Ink ink() const;
  picture::Ink groundInk() const;
  void push(PictureStep step, const QString& text);
  void note(PictureStep step, const QString& text);
  void exchange(PictureStep& step, bool forward);
  void setSaved(std::shared_ptr<const picture::EditedGrid> saved);
  void mergeNext();
  void landMerge();
  void landMergeSoon();
  void rebase(picture::Rebase& rebase);
  std::vector<picture::Patch> stepsSoFar() const;
  void recountConflicts();
  void stopLooking();

  std::shared_ptr<picture::EditedGrid> grid_;
  std::shared_ptr<const picture::EditedGrid> saved_;
  map::GridReference reference_;
  bool holds_unknown_ = true;
  picture::Kind kind_ = picture::Kind::Occupied;
  int across_ = 3;
  std::optional<picture::Stroke> stroke_;
  bool erasing_ = false, stroke_waits_ = false;
  quint64 stroke_of_saved_ = 0;
  picture::CellRect selection_;
  std::shared_ptr<const picture::Clip> clip_;
  picture::DifferenceCount count_;
  std::optional<TidyPreview> preview_;
  picture::CellSet met_;  // that both have changed; of these, those that are not as they are saved:
  std::int64_t conflicts_ = 0;
  picture::CellRect where_conflicts_;
  StopFlag looking_, merging_, reckoning_;  // set to stop it; null: nothing of the kind is under way
  std::optional<Coming> coming_;            // theirs, to be looked at next
  std::shared_ptr<Taken> taken_;            // looked at, and not on the map yet
  std::vector<std::function<void()>> waiting_;
  quint64 saved_number_ = 1;  // of states that were saved
  std::size_t undo_budget_ = std::size_t(256) << 20;
  picture::PatchMemory held_;  // by the steps; goes after them
  QUndoStack undo_;
  work::Share share_;  // last
};

}  // namespace mapwright::window
