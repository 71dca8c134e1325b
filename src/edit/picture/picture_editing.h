// The picture of the map on screen while it is edited: its cells, undo history, saved state, and painting
// options. GUI-thread object; slow work is done on the thread pool.
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
#include "picture/draw.h"
#include "picture/merge.h"
#include "picture/tidy.h"
#include "work/workers.h"

namespace mapwright::edit {

/// "1,204 cells"
QString cellsText(std::int64_t cells);

enum class Tidying { Specks, Gaps, Edges };

/// A change with its undo data and its effect on the count of changed cells, computed together if that is
/// slow.
struct PictureStep {
  picture::Patch patch;
  picture::DifferenceCount::Tiles before, after;
  quint64 of_saved = 0;  // the saved state it was counted against; 0 = unknown
};

/// What a clean-up would change, shown before it is applied.
struct TidyPreview {
  Tidying what = Tidying::Specks;
  picture::Tidied found;
  PictureStep step;
  std::shared_ptr<const picture::EditedGrid> cells;  // as they would be
  picture::Changes changes;                          // as far as they can be marked
  /// Computes the effect of the step, which is complete, on the present grid.
  void show(const picture::EditedGrid& now);
};

class PictureEditing : public QObject {
  Q_OBJECT
 public:
  explicit PictureEditing(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~PictureEditing() override;

  /// `cells`: complete. Not changed yet. `holds_unknown`: unknown can be stored in its picture.
  void open(std::shared_ptr<const grids::GridPyramid> cells, const map::GridReference& reference,
            bool holds_unknown);
  void close();
  bool isOpen() const { return grid_ != nullptr; }
  const std::shared_ptr<picture::EditedGrid>& grid() const { return grid_; }
  const map::GridReference& reference() const { return reference_; }
  QUndoStack& undoStack() { return undo_; }

  // What to paint with.
  picture::Kind kind() const { return kind_; }
  void setKind(picture::Kind kind);
  bool holds(picture::Kind kind) const;
  int across() const { return across_; }  // of the brush, cells
  void setAcross(int cells);

  // Painting. Positions are world metres; each call is one undo step, a stroke as a whole. Changes that may
  // touch many cells are computed on the thread pool: reckoning() until they are on the map. Further input
  // waits for them, including strokes; undo and stop() cancel them.
  void beginStroke(bool eraser);
  void strokeTo(const Eigen::Vector2d& world_m);
  void endStroke();
  bool stroking() const { return stroke_.has_value() || stroke_waits_; }
  void drawLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void drawRectangle(const picture::CellRect& rect);
  void drawPolygon(const std::vector<Eigen::Vector2d>& corners_m);
  /// tooLarge(): it would extend too far.
  void fill(const Eigen::Vector2d& at_m);
  bool reckoning() const { return reckoning_ != nullptr; }
  /// Cancels the work in progress and everything that waits for it.
  void stop();

  // The selection: a rectangle of cells.
  const picture::CellRect& selection() const { return selection_; }
  void select(const picture::CellRect& rect);
  bool hasCopy() const { return clip_ != nullptr; }
  bool copySelection();
  void pasteAt(int left, int top);
  /// Its old place becomes unknown (free, if the picture cannot contain unknown).
  void moveSelection(int columns, int rows, bool leaves_copy);
  void paintSelection();

  // Clean-up, in the selection or everywhere: computed on the thread pool, previewed, then applied.
  void lookFor(Tidying what, int cells);
  bool looking() const { return looking_ != nullptr; }
  const std::optional<TidyPreview>& preview() const { return preview_; }
  void applyPreview();
  void dropPreview();

  /// Memory limit of the undo history in bytes: the oldest steps are dropped, but never the last one.
  void setUndoBudget(std::size_t bytes) { undo_budget_ = bytes; }
  std::size_t undoBytes() const { return held_.bytes(); }

  // What is saved.
  std::int64_t changedCells() const { return count_.cells; }
  bool unsaved() const { return count_.cells > 0; }
  std::shared_ptr<const picture::EditedGrid> snapshot() const;
  const std::shared_ptr<const picture::EditedGrid>& saved() const { return saved_; }
  /// A change made elsewhere to the present grid.
  void applyPatch(picture::Patch patch, const QString& text);
  /// This is the stored state now (snapshot()).
  void markSaved(const std::shared_ptr<const picture::EditedGrid>& saved);
  /// Restores the saved state; can be undone.
  void revert();
  /// Someone else has changed the saved state to `theirs`, with that revision. It is compared on the thread
  /// pool and merged when no stroke or computation is in progress; mergeDone() follows. Of several only the
  /// last one counts. It lies below all local changes: undo does not revert it.
  void mergeTheirs(std::shared_ptr<const grids::GridPyramid> theirs, std::string revision);
  bool merging() const { return merging_ != nullptr; }
  /// There are local changes, or some in progress: it cannot simply be reloaded.
  bool touched() const;
  /// Cells changed differently by both and not decided yet.
  std::int64_t conflicts() const { return conflicts_; }
  geometry::WorldRect whereConflicts() const;
  void decide(bool take_theirs);

  picture::CellRect cellsBetween(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const;
  Eigen::Vector2d cellAt(const Eigen::Vector2d& world_m) const { return reference_.cellFromWorld(world_m); }
  geometry::WorldRect worldOf(const picture::CellRect& rect) const;

 Q_SIGNALS:
  void cellsChanged(const mapwright::geometry::WorldRect& where);
  void stateChanged();    // choices, counts, selection, preview, conflicts
  void previewChanged();  // another grid should be shown
  void mergeDone(qint64 taken, const std::string& revision);  // mergeTheirs() has ended
  void tooLarge();
  void stepsForgotten(int steps);  // they exceeded setUndoBudget()

 private:
  class Command;
  using StopFlag = std::shared_ptr<std::atomic<bool>>;
  /// On the thread pool: everything it writes is one change. False: it would extend too far.
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
  void recordStep(PictureStep step, const QString& text);
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
  picture::CellSet met_;  // changed by both; of these, the ones that differ from the saved state:
  std::int64_t conflicts_ = 0;
  picture::CellRect where_conflicts_;
  StopFlag looking_, merging_, reckoning_;  // set to cancel; null: nothing in progress
  std::optional<Coming> coming_;            // theirs, compared next
  std::shared_ptr<Taken> taken_;            // compared, but not on the map yet
  std::vector<std::function<void()>> waiting_;
  quint64 saved_number_ = 1;  // counts saved states
  std::size_t undo_budget_ = std::size_t(256) << 20;
  picture::PatchMemory held_;  // memory of the steps; destroyed after them
  QUndoStack undo_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::edit
