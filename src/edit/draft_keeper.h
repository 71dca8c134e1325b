// Writes the draft of one document as it changes. GUI-thread object; the disk is touched on a thread beyond
// the crew: a slow one holds up nobody.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <QObject>

#include "edit/draft_shelf.h"
#include "work/workers.h"

namespace mapwright::edit {

/// Calls back once, after a while, on the thread that asked.
using Later = std::function<void(std::chrono::milliseconds, std::function<void()>)>;
/// By the clock.
Later byTheClock();

class DraftKeeper : public QObject {
  Q_OBJECT
 public:
  /// How long after a change the draft is written; so it is on disk within a second.
  static constexpr std::chrono::milliseconds kWait{400};
  /// How long after a failure it is tried again.
  static constexpr std::chrono::milliseconds kRetry{5'000};

  /// Makes the bytes of the draft, on another thread.
  using Job = std::function<QByteArray()>;
  /// `content`: what is to be kept now; null = nothing is, the draft goes.
  DraftKeeper(QString folder, const DraftIdentity& of, std::function<Job()> content, Later later,
              std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// Waits until what is being written is on disk.
  ~DraftKeeper() override;

  /// Something has changed.
  void touch();
  /// Writes (or removes) it now and waits for it; nullopt = it is on disk, else why not.
  std::optional<Fault> flush();
  /// Why the draft of what is there now is not on disk; None = nothing is wrong.
  const Fault& trouble() const { return trouble_; }

 Q_SIGNALS:
  void troubleChanged();
  void written();  // what was there when it began is on disk, or gone from there

 private:
  void beginAfter(std::chrono::milliseconds wait);
  void begin();
  void setTrouble(Fault trouble);

  std::function<Job()> content_;
  Later later_;
  DraftFile file_;  // of whoever writes: never two at a time
  Fault trouble_;
  bool waiting_ = false, writing_ = false, again_ = false;
  work::Share share_;  // last: it waits for what is being written
};

}  // namespace mapwright::edit
