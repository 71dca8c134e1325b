// Writes the draft of one document as it changes. GUI-thread object; disk access happens on a thread of its
// own, so that a slow disk blocks nobody.
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
  /// Delay between a change and writing the draft; so it is on disk within a second.
  static constexpr std::chrono::milliseconds kWait{400};
  /// Delay before a retry after a failure.
  static constexpr std::chrono::milliseconds kRetry{5'000};

  /// Makes the bytes of the draft, on another thread.
  using Job = std::function<QByteArray()>;
  /// `content`: what to save now; null = nothing, the draft is removed.
  DraftKeeper(QString folder, const DraftIdentity& of, std::function<Job()> content, Later later,
              std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// Waits until the write in progress is on disk.
  ~DraftKeeper() override;

  /// Something has changed.
  void touch();
  /// Writes (or removes) it now and waits; nullopt = done, otherwise why not.
  std::optional<Fault> flush();
  /// Why the current draft is not on disk; None = nothing is wrong.
  const Fault& trouble() const { return trouble_; }

 Q_SIGNALS:
  void troubleChanged();
  void written();  // the state at the start of the write is on disk, or removed

 private:
  void beginAfter(std::chrono::milliseconds wait);
  void begin();
  void setTrouble(Fault trouble);

  std::function<Job()> content_;
  Later later_;
  DraftFile file_;  // used by the writer: never two at a time
  Fault trouble_;
  bool waiting_ = false, writing_ = false, again_ = false;
  work::Tasks share_;  // last member: waits for the write in progress
};

}  // namespace mapwright::edit
