// Drafts on disk: each program that edits a list has its own file for it, locked while it runs, so that two
// windows on one list do not overwrite each other, and abandoned drafts can be told from those in use.
// Accesses the disk; any thread, one at a time.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QLockFile>
#include <QString>

#include "edit/draft.h"
#include "fault/fault.h"

namespace mapwright::edit {

/// A draft file that this program writes.
class DraftFile {
 public:
  /// Nothing is on disk before the first write(), which also creates `folder`.
  DraftFile(QString folder, const DraftIdentity& of);
  /// Releases the lock; the file stays.
  ~DraftFile() = default;

  /// Completely and durably, or not at all; nullopt = written, otherwise why not.
  std::optional<Fault> write(const QByteArray& bytes);
  /// nullopt = removed, otherwise why not.
  std::optional<Fault> remove();
  QString path() const { return path_; }

 private:
  QString folder_, path_;
  std::unique_ptr<QLockFile> lock_;
};

/// An abandoned draft. Locked as long as this object exists.
struct LeftDraft {
  QString path;
  QByteArray bytes;
  std::shared_ptr<QLockFile> lock;
};

struct LeftDrafts {
  std::vector<LeftDraft> drafts;  // the newest first
  std::vector<Fault> notes;       // what could not be read
};

/// The drafts of `of` that no running program uses.
LeftDrafts leftDrafts(const QString& folder, const DraftIdentity& of);
/// Removes a draft that was restored or discarded; nullopt = it is gone, otherwise why not.
std::optional<Fault> removeDraft(LeftDraft draft);
/// Renames a draft that cannot be parsed, so that people can look at it and it is not found again. Returns
/// the message for the user.
Fault setAside(LeftDraft draft);

}  // namespace mapwright::edit
