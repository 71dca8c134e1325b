// Drafts of the unsaved changes of a map that is edited, which are offered again. GUI thread.
#pragma once

#include <any>
#include <functional>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QString>

#include "edit/drafts.h"
#include "ui/shell/window_context.h"

class QDockWidget;

namespace mapwright::window {

class MapDrafts : public QObject {
  Q_OBJECT
 public:
  /// What a file holds.
  struct Draft {
    QDateTime made;
    QString amount;  // of the changes
    std::any content;
    bool needless = false;  // it has been saved after all
  };
  struct Left {
    edit::LeftDraft file;
    Draft draft;
  };
  /// How a feature keeps its drafts, and speaks of them.
  struct Kind {
    edit::DraftIdentity of = {};
    std::function<edit::DraftKeeper::Job()> content = {};  // as for edit::DraftKeeper
    /// On another thread; nullopt: not such a draft, or damaged.
    std::function<std::optional<Draft>(const QByteArray&)> read = {};
    std::function<bool()> unsaved = {};
    QString offer = {};       // %1: when it was made, %2: Draft::amount
    QString not_backed = {};  // %1: why it is not on disk
    QString lost = {};        // %1: likewise
  };

  /// Looks for earlier drafts at once. `dock`: shows what is offered.
  MapDrafts(WindowContext& context, QDockWidget* dock, Kind kind);

  /// Something has changed.
  void touch() { keeper_.touch(); }
  /// Writes the draft to disk; otherwise returns why not.
  std::optional<Fault> keep() { return keeper_.flush(); }
  /// Before the map is left: the user is told of changes that cannot be kept.
  void keepOrTell();
  /// Why it is not on disk; empty = nothing is wrong.
  QString trouble() const;

  bool offered() const { return !left_.empty(); }
  /// The offer as a sentence; empty = none.
  QString offer() const;
  /// The first that is offered.
  Left take();
  /// Its changes are those of the map now: its file goes once they are on disk again.
  void replace(edit::LeftDraft file);
  void turnDown();

 Q_SIGNALS:
  void changed();

 private:
  struct Found {
    std::vector<Left> drafts;
    QStringList remarks;
  };
  static Found look(const QString& folder, const Kind& kind);
  void tell();
  void remark(const QString& sentence);

  WindowContext& context_;
  QDockWidget* dock_;
  Kind kind_;
  std::vector<Left> left_;
  edit::DraftKeeper keeper_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::window
