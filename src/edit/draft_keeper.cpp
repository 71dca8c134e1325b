#include "edit/draft_keeper.h"

#include <QPointer>
#include <QTimer>

namespace mapwright::edit {

Later byTheClock() {
  return [](std::chrono::milliseconds wait, std::function<void()> then) {
    QTimer::singleShot(wait, std::move(then));
  };
}

DraftKeeper::DraftKeeper(QString folder, const DraftIdentity& of, std::function<Job()> content, Later later,
                         std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      content_(std::move(content)),
      later_(std::move(later)),
      file_(std::move(folder), of),
      share_(std::move(workers)) {}

DraftKeeper::~DraftKeeper() = default;

void DraftKeeper::touch() {
  if (writing_) again_ = true;
  if (!writing_) beginAfter(kWait);
}

void DraftKeeper::beginAfter(std::chrono::milliseconds wait) {
  if (std::exchange(waiting_, true)) return;
  later_(wait, [self = QPointer<DraftKeeper>(this)] {
    if (!self || !std::exchange(self->waiting_, false)) return;
    self->begin();
  });
}

void DraftKeeper::begin() {
  writing_ = true;
  again_ = false;
  share_.startLong([this, job = content_()] {
    const std::optional<Fault> trouble = job ? file_.write(job()) : file_.remove();
    QMetaObject::invokeMethod(
        this,
        [this, trouble] {
          writing_ = false;
          setTrouble(trouble.value_or(Fault()));
          Q_EMIT written();
          // What cannot be written now may work later.
          if (again_ || trouble) beginAfter(trouble ? kRetry : kWait);
        },
        Qt::QueuedConnection);
  });
}

std::optional<Fault> DraftKeeper::flush() {
  waiting_ = false;
  share_.waitForDone();
  const Job job = content_();
  const std::optional<Fault> trouble = job ? file_.write(job()) : file_.remove();
  setTrouble(trouble.value_or(Fault()));
  return trouble;
}

void DraftKeeper::setTrouble(Fault trouble) {
  if (trouble == trouble_) return;
  trouble_ = std::move(trouble);
  Q_EMIT troubleChanged();
}

}  // namespace mapwright::edit

#include "moc_draft_keeper.cpp"
