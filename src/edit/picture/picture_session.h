// The picture of one map that is open for editing: merged when it changes where it is stored, saved, and in
// doubt after a lost answer until it is read again. No widgets. GUI thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "edit/edit_session.h"
#include "edit/picture/picture_editing.h"
#include "robot/picture_store.h"
#include "work/workers.h"

namespace mapwright::edit {

class PictureSession : public EditSession {
  Q_OBJECT
 public:
  /// As it was read.
  struct Picture {
    std::shared_ptr<const grids::GridPyramid> cells;
    map::GridReference reference;
    std::string revision;
    bool holds_unknown = true;  // its format has unknown cells
  };
  /// What a picture that was sent with an unknown result turned out to be.
  enum class DoubtEnd { Stored, AsBefore, Other };
  /// Null while nothing can be saved.
  using StoreNow = std::function<robot::PictureStore*()>;

  /// Opens `picture` in `editing`, which outlives this object.
  PictureSession(StoreNow store, map::MapKey map, QString address, Picture picture, PictureEditing& editing,
                 EditOptions options);
  /// Unsaved changes stay as a draft. Closes the document.
  ~PictureSession() override;

  const map::MapKey& map() const { return map_; }
  /// Of what is saved.
  const std::string& revision() const { return revision_; }

  bool unsaved() const override { return editing_.unsaved(); }
  bool saving() const override { return saving_; }
  bool inConflict() const override { return editing_.conflicts() > 0; }
  bool inDoubt() const override { return doubt_.has_value(); }
  /// Whether what was sent was stored does not matter any more.
  void endDoubt() { doubt_.reset(); }

  /// The same map was read: saved here, or changed by someone else. Ignored while saving.
  void onRead(Picture picture);
  /// Saves. Before that, what is stored is copied to `copy` (empty: it is not), and without the copy nothing
  /// is overwritten. While something is being merged it is saved once that is done.
  void send(const QString& copy);
  void cancelSaving() { write_call_.cancel(); }
  /// Then restored() says how many of its cells others changed, too.
  void restoreDraft(const QString& text) override;

 Q_SIGNALS:
  void progressed(double share);
  void notCopied(const mapwright::Fault& trouble);
  /// A write ended; without a `failure` the picture is stored, and what it replaced is in `copy`.
  void ended(const std::optional<mapwright::map::Failure>& failure, const QString& copy);
  /// `cells` of others are here now; `again`: saving waited for that.
  void merged(qint64 cells, bool again);
  /// By one of another size or position: the unsaved changes to `lost` cells are gone.
  void replaced(qint64 lost);
  void doubtSettled(mapwright::edit::PictureSession::DoubtEnd end);
  /// `elsewhere`: cells of the draft that others have changed differently since.
  void restored(qint64 elsewhere);

 private:
  struct Doubt {
    std::shared_ptr<const picture::EditedGrid> sent, before;
  };
  void open(Picture picture);
  void write();
  void onWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                 const std::shared_ptr<const picture::EditedGrid>& before,
                 const robot::Outcome<robot::PictureReceipt>& outcome);
  void onMerged(qint64 cells, const std::string& revision);
  void settleDoubt();

  StoreNow store_;
  map::MapKey map_;
  QString address_;
  PictureEditing& editing_;
  EditOptions options_;
  robot::Call write_call_;
  std::shared_ptr<const grids::GridPyramid> seen_;  // of the last picture read
  std::string revision_;
  std::set<std::string> past_revisions_;  // replaced by saving here; may still be on their way
  bool saving_ = false, again_ = false;   // again: saves once more after merging theirs
  std::optional<Doubt> doubt_;
  QString copy_;
  quint64 opened_ = 0;  // results about earlier pictures are ignored
  work::Tasks share_;   // last
};

}  // namespace mapwright::edit
