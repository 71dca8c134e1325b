// Drafts: the unsaved changes of a document on disk, each changed item before and after, which is all that a
// three-way merge needs. Each program that edits a list has its own file for it, locked while it runs, so
// that two windows on one list do not overwrite each other, and abandoned drafts can be told from those in
// use. Functions and DraftFile access the disk from any thread, one at a time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QJsonArray>
#include <QLockFile>
#include <QObject>

#include "edit/merge.h"
#include "fault/fault.h"
#include "work/workers.h"

namespace mapwright::edit {

/// Which list of which robot or file a draft belongs to.
struct DraftIdentity {
  QString address, map, kind;  // kind: "waypoints", "picture"
  bool operator==(const DraftIdentity&) const = default;
};

/// A draft whose changes may be of any kind.
struct DraftFrame {
  DraftIdentity of;
  QDateTime made;
  QJsonArray changes;
};
QByteArray toBytes(const DraftFrame& frame);
/// nullopt = not a draft, or written by a later version.
std::optional<DraftFrame> draftFrame(const QByteArray& bytes);

struct WaypointDraft {
  DraftIdentity of;
  QDateTime made;
  std::vector<Change> changes;
};
QByteArray toBytes(const WaypointDraft& draft);
/// nullopt = not such a draft: something is missing, has the wrong type or is not finite.
std::optional<WaypointDraft> waypointDraftFrom(const QByteArray& bytes);

/// A draft file that this program writes. When this object goes the lock is released; the file stays.
class DraftFile {
 public:
  /// Nothing is on disk before the first write(), which also creates `folder`.
  DraftFile(QString folder, const DraftIdentity& of);
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

/// Calls back once, after a while, on the thread that asked.
using Later = std::function<void(std::chrono::milliseconds, std::function<void()>)>;
/// By the clock.
Later byTheClock();

/// Writes the draft of one document as it changes. GUI-thread object; disk access happens on a thread of its
/// own, so that a slow disk blocks nobody.
class DraftKeeper : public QObject {
  Q_OBJECT
 public:
  /// Delay between a change and writing the draft; so it is on disk within a second.
  static constexpr std::chrono::milliseconds kWait{400};
  /// Delay before a retry after a failure.
  static constexpr std::chrono::milliseconds kRetry{5'000};
  /// Makes the bytes of the draft, on another thread.
  using Job = std::function<QByteArray()>;

  /// `content`: what to save now; null = nothing, the draft is removed. The destructor waits until the write
  /// in progress is on disk.
  DraftKeeper(QString folder, const DraftIdentity& of, std::function<Job()> content, Later later,
              std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);

  /// Something has changed.
  void touch();
  /// Writes (or removes) it now and waits; nullopt = done, otherwise why not.
  std::optional<Fault> flush();
  /// Why the current draft is not on disk; None = nothing is wrong.
  const Fault& trouble() const { return trouble_; }
  /// The document has taken up the changes of this one: it is removed once they are on disk again.
  void replace(LeftDraft draft) { replaced_.push_back(std::move(draft)); }

 Q_SIGNALS:
  void troubleChanged();
  void written();  // the state at the start of the write is on disk, or removed

 private:
  void beginAfter(std::chrono::milliseconds wait);
  void begin();
  void setTrouble(const std::optional<Fault>& trouble);

  std::function<Job()> content_;
  Later later_;
  DraftFile file_;  // used by the writer: never two at a time
  Fault trouble_;
  std::vector<LeftDraft> replaced_;
  bool waiting_ = false, writing_ = false, again_ = false;
  work::Tasks share_;  // last member: waits for the write in progress
};

}  // namespace mapwright::edit
