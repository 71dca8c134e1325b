// The drafts of one document that is open: the one that is kept while there are unsaved changes, and those of
// programs that ended without saving, which are offered. GUI-thread object; the disk is accessed on other
// threads.
#pragma once

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QObject>

#include "edit/drafts.h"
#include "work/workers.h"

namespace mapwright::edit {

struct EditOptions {
  QString drafts_folder = {};  // empty = no drafts
  Later later = byTheClock();
  std::function<QDateTime()> now = [] { return QDateTime::currentDateTime(); };
  std::shared_ptr<work::Workers> workers = {};  // null = threads of its own
};

/// What a draft file holds.
struct Draft {
  QDateTime made;
  qint64 changes = 0;  // how many, in the unit of its kind
  std::any content = {};
};

class DocumentDrafts : public QObject {
  Q_OBJECT
 public:
  /// How a kind of document keeps its drafts.
  struct Kind {
    DraftIdentity of = {};
    std::function<bool()> unsaved = {};
    /// What to save; called while there are unsaved changes (DraftKeeper).
    std::function<DraftKeeper::Job()> content = {};
    /// Called on another thread; nullopt = not such a draft, or damaged.
    std::function<std::optional<Draft>(const QByteArray&)> read = {};
    /// What of it is not saved yet, when it is about to be offered: without changes it is removed. May be
    /// empty: all of it.
    std::function<void(Draft&)> removeSaved = {};
  };

  /// `options.drafts_folder` is not empty. Nothing is looked for before look().
  DocumentDrafts(const EditOptions& options, Kind kind);
  /// Waits until what is being written is on disk.
  ~DocumentDrafts() override;

  /// Looks for earlier drafts.
  void look();
  /// Something has changed.
  void touch() { keeper_.touch(); }
  /// Writes the draft to disk before it returns; otherwise returns why not.
  std::optional<Fault> keep() { return keeper_.flush(); }
  /// Why the draft is not on disk; None = nothing is wrong. What is saved needs none.
  Fault trouble() const { return kind_.unsaved() ? keeper_.trouble() : Fault(); }

  /// The one that is offered, the newest; null = none.
  const Draft* offered() const { return left_.empty() ? nullptr : &left_.front().draft; }
  /// `apply` makes its content changes of the document, or returns false. The file is removed once the
  /// changes are on disk again.
  void restore(const std::function<bool(const Draft&)>& apply);
  /// It is not wanted.
  void turnDown();

 Q_SIGNALS:
  void changed();  // what is offered, or the trouble
  /// A message for the user.
  void remarked(const mapwright::Fault& remark);

 private:
  struct Left {
    LeftDraft file;
    Draft draft;
  };
  struct Found {
    std::vector<Left> drafts;
    std::vector<Fault> remarks;
  };
  static Found find(const QString& folder, const Kind& kind);
  void offer(Found found);
  Left removeFirst();

  QString folder_;
  std::shared_ptr<work::Workers> workers_;
  Kind kind_;
  std::vector<Left> left_;
  DraftKeeper keeper_;
  work::Tasks looking_;  // last
};

}  // namespace mapwright::edit
