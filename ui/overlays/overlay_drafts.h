// Drafts of the unsaved changes of a map's overlays, which are offered again.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QObject>

#include "edit/drafts.h"
#include "edit/open_waypoints.h"
#include "overlays/overlay_document.h"
#include "work/workers.h"

namespace mapwright::window {

/// What the robot held, and what was made of it.
struct OverlayDraft {
  QDateTime made;
  overlays::OverlayDocument base, mine;
};
QByteArray overlayDraftBytes(const edit::DraftIdentity& of, const OverlayDraft& draft);
/// nullopt: not such a draft, or damaged.
std::optional<OverlayDraft> overlayDraftFrom(const QByteArray& bytes);

class OverlayDrafts : public QObject {
  Q_OBJECT
 public:
  /// Base and mine as they are now; nullopt: nothing is unsaved.
  using Content = std::function<std::optional<OverlayDraft>()>;

  /// Looks for earlier drafts at once.
  OverlayDrafts(edit::DraftIdentity of, edit::EditOptions options, Content content,
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
  /// The first one. Its file goes once its changes are on disk again.
  OverlayDraft take();
  void turnDown();

 Q_SIGNALS:
  void changed();
  void remarked(const QString& sentence);

 private:
  struct Left {
    edit::LeftDraft file;
    OverlayDraft draft;
    qsizetype changes = 0;
  };
  struct Found {
    std::vector<Left> drafts;
    QStringList remarks;
  };
  static Found look(const QString& folder, const edit::DraftIdentity& of);

  edit::DraftIdentity of_;
  edit::EditOptions options_;
  std::vector<Left> left_;
  edit::DraftKeeper keeper_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::window
