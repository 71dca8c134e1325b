// Drafts of the unsaved changes of a map's picture, which are offered again.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QObject>
#include <QString>

#include "edit/drafts.h"
#include "edit/open_waypoints.h"
#include "fault/fault.h"
#include "grids/grid_pyramid.h"
#include "picture/merge.h"
#include "ui/picture/picture_editing.h"

namespace mapwright::window {

/// The unsaved changes of a picture: each changed tile before and after.
struct PictureDraft {
  QDateTime made;
  int width = 0, height = 0;
  grids::CellCode code = grids::CellCode::Gray;
  struct Tile {
    int x = 0, y = 0;
    QByteArray was, is;  // cells, row-major
  };
  std::vector<Tile> tiles;
};

QByteArray pictureDraftBytes(const edit::DraftIdentity& of, const QDateTime& made,
                             const picture::EditedGrid& now, const picture::EditedGrid& saved);
/// nullopt: not such a draft, or damaged. Contains nothing larger than a tile.
std::optional<PictureDraft> pictureDraftFrom(const QByteArray& bytes);

class PictureDrafts : public QObject {
  Q_OBJECT
 public:
  /// Looks for earlier drafts at once. `editing` must outlive this, with its map open.
  PictureDrafts(PictureEditing* editing, edit::DraftIdentity of, edit::EditOptions options,
                const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);

  /// Something has changed.
  void touch() { keeper_.touch(); }
  /// Writes the draft to disk; otherwise returns why not.
  std::optional<Fault> keep() { return keeper_.flush(); }
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

  PictureEditing* editing_;
  edit::DraftIdentity of_;
  edit::EditOptions options_;
  std::vector<Left> left_;
  edit::DraftKeeper keeper_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::window
