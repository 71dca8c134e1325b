// Drafts on disk: each program that edits a list has a file of its own for it, locked while it runs, so that
// two windows on one list do not overwrite each other, and what a program that is gone has left is told from
// what is still being worked on. Looks at the disk; any thread, one at a time.
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
  /// Nothing is on disk before the first write(). `folder` is made then.
  DraftFile(QString folder, const DraftIdentity& of);
  /// Lets go of the lock; the file stays.
  ~DraftFile() = default;

  /// Whole and durably, or not at all; nullopt = written, else why not.
  std::optional<Fault> write(const QByteArray& bytes);
  /// Nothing is left of it; nullopt = so it is, else why not.
  std::optional<Fault> remove();
  QString path() const { return path_; }

 private:
  QString folder_, path_;
  std::unique_ptr<QLockFile> lock_;
};

/// A draft that was left behind. It is locked as long as this is held.
struct LeftDraft {
  QString path;
  QByteArray bytes;
  std::shared_ptr<QLockFile> lock;
};

struct LeftDrafts {
  std::vector<LeftDraft> drafts;  // the newest first
  std::vector<Fault> notes;       // what could not be read
};

/// The drafts of `of` that no running program works on.
LeftDrafts leftDrafts(const QString& folder, const DraftIdentity& of);
/// It is taken up or not wanted; nullopt = it is gone, else why not.
std::optional<Fault> removeDraft(LeftDraft draft);
/// It cannot be understood: it is renamed, for people to look at, and not met again. What to tell people.
Fault setAside(LeftDraft draft);

}  // namespace mapwright::edit
