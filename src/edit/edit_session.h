// What belongs to one map and is open for editing: read from where it is stored, merged when it changes
// there, kept as a draft while unsaved, and saved. What the window needs to know of any of them. GUI-thread
// object.
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "edit/document_drafts.h"
#include "map/failure.h"

namespace mapwright::edit {

class EditSession : public QObject {
  Q_OBJECT
 public:
  enum class Phase { Reading, Ready, Failed };

  using QObject::QObject;

  Phase phase() const { return phase_; }
  /// Why the last read failed; nullopt if it succeeded.
  const std::optional<map::Failure>& failure() const { return failure_; }
  virtual bool unsaved() const = 0;
  /// Something is on its way to or from the store that has to end before anything is sent.
  virtual bool saving() const = 0;
  /// Something was changed both here and elsewhere: the user has to decide before it is saved.
  virtual bool inConflict() const = 0;
  /// It is not known whether what was sent was applied. Ends when it has been read again and shows it.
  virtual bool inDoubt() const = 0;

  /// Makes the draft that is offered one step called `text`, merged with what is stored now. Without an offer
  /// nothing happens.
  virtual void restoreDraft(const QString& text) = 0;
  /// null: none are kept.
  DocumentDrafts* drafts() const { return drafts_.get(); }
  /// The draft is written to disk as it is, and no more is kept. Before the document goes, because it is what
  /// is written. Returns why it was not written.
  std::optional<Fault> closeDrafts();

 Q_SIGNALS:
  void changed();  // its phase, what is in progress, its drafts; the document signals its own changes
  /// All of it is stored.
  void saved();
  /// A message for the user.
  void remarked(const mapwright::Fault& remark);

 protected:
  /// Keeps a draft from now on. Without a folder for drafts: none.
  void keepDrafts(const EditOptions& options, DocumentDrafts::Kind kind);

  Phase phase_ = Phase::Reading;
  std::optional<map::Failure> failure_;

 private:
  std::unique_ptr<DocumentDrafts> drafts_;
};

}  // namespace mapwright::edit
