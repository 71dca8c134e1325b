// The drafts of one map's picture: saves unsaved changes and offers earlier drafts. GUI-thread object; disk
// access is on separate threads.
#pragma once

#include <memory>
#include <vector>

#include <QObject>

#include "edit/draft_keeper.h"
#include "edit/open_waypoints.h"
#include "ui/picture/picture_draft.h"
#include "ui/picture/picture_editing.h"

namespace mapwright::window {

class PictureDrafts : public QObject {
  Q_OBJECT
 public:
  /// Looks for earlier drafts at once. `editing` must outlive this, with its map open.
  PictureDrafts(PictureEditing* editing, edit::DraftIdentity of, edit::EditOptions options,
                const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~PictureDrafts() override;

  /// Something has changed.
  void touch() { keeper_.touch(); }
  /// Writes the draft to disk; otherwise returns why not.
  std::optional<Fault> keep();
  /// Why it is not on disk; empty = nothing is wrong.
  QString trouble() const;

  bool offered() const { return !left_.empty(); }
  /// The offer as a sentence; empty = none.
  QString offer() const;
  void takeUp();
  void turnDown();

 Q_SIGNALS:
  void changed();
  void remarked(const QString& sentence);

 private:
  struct Left {
    edit::LeftDraft file;
    PictureDraft draft;
    std::int64_t cells = 0;
  };
  struct Found {
    std::vector<Left> drafts;
    QStringList remarks;
  };
  static Found look(const QString& folder, const edit::DraftIdentity& of, const picture::EditedGrid& grid);
  void forgetTakenUp();

  PictureEditing* editing_;
  edit::DraftIdentity of_;
  edit::EditOptions options_;
  std::vector<Left> left_;
  std::vector<edit::LeftDraft> taken_up_;  // until their content is in a new draft on disk
  edit::DraftKeeper keeper_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::window
