#include "excerpt/excerpt_job.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "disk/file_error.h"
#include "excerpt/recording_slice.h"
#include "map/failure.h"

namespace mapwright::excerpt {
namespace {

constexpr int kOpenTries = 3;

}  // namespace

ExcerptJob::ExcerptJob(Source source, Order order, std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      source_(std::move(source)),
      order_(std::move(order)),
      share_(work::orOwn(std::move(workers))) {}

ExcerptJob::~ExcerptJob() { cancelled_ = true; }

void ExcerptJob::start() {
  if (order_.kind == Kind::Mcap && !source_.recording.empty()) return slice();
  replay::Reading::Options options;
  options.chunks.look_back = false;
  options.whole_texts = wantsWholeTexts(order_.kind);
  reading_ = std::make_unique<replay::Reading>(*source_.library, source_.key, std::move(options));
  connect(reading_.get(), &replay::Reading::opened, this, &ExcerptJob::begun);
  connect(reading_.get(), &replay::Reading::changed, this, &ExcerptJob::proceed);
  connect(reading_.get(), &replay::Reading::failed, this, [this](const map::Failure& failure) {
    if (map::mayPass(failure) && ++opened_ < kOpenTries) return reading_->open();
    Ended ended;
    ended.not_read = failure;
    end(std::move(ended));
  });
  reading_->open();
}

void ExcerptJob::slice() {
  busy_ = true;
  share_.startLong([this] {
    auto sliced = sliceRecording(source_.recording, order_, [this](double share) {
      QMetaObject::invokeMethod(
          this, [this, share] { Q_EMIT progressed(share); }, Qt::QueuedConnection);
      return !cancelled_;
    });
    QMetaObject::invokeMethod(
        this,
        [this, sliced = std::move(sliced)] {
          Ended ended;
          if (sliced) ended.written = *sliced;
          if (!sliced) ended.not_written = sliced.error();
          end(std::move(ended));
        },
        Qt::QueuedConnection);
  });
}

void ExcerptJob::begun() {
  walk_.emplace(*reading_, readsFrom(order_), order_.span.to_s);
  proceed();
}

void ExcerptJob::proceed() {
  if (!walk_ || busy_ || over_) return;
  if (walk_->over()) return work(nullptr);
  if (const replay::ChunkPtr chunk = walk_->next()) {
    Q_EMIT progressed(walk_->share());
    return work(chunk);
  }
  if (walk_->over()) return work(nullptr);  // the rest is lost
  const replay::Cell* const cell = walk_->waitsFor();
  if (!cell || cell->tries == 0 || !replay::isFinal(*cell)) return;
  Ended ended;
  ended.not_read = cell->failure;
  ended.range = TimeSpan{replay::secondsOf(cell->from), replay::secondsOf(cell->until)};
  end(std::move(ended));
}

void ExcerptJob::work(const replay::ChunkPtr& chunk) {
  busy_ = true;
  share_.startLong([this, chunk] {
    std::optional<disk::FileError> fault;
    std::optional<Written> written;
    if (!writing_) {
      auto begun = begin(order_);
      if (!begun) fault = begun.error();
      if (begun) writing_ = std::move(*begun);
    }
    if (!fault && chunk && !cancelled_) fault = writing_->add(*chunk);
    if (!fault && !chunk && !cancelled_) {
      auto placed = writing_->place();
      if (!placed) fault = placed.error();
      if (placed) written = std::move(*placed);
    }
    if (fault || written || cancelled_) writing_.reset();
    QMetaObject::invokeMethod(
        this, [this, fault, written] { worked(fault, written); }, Qt::QueuedConnection);
  });
}

void ExcerptJob::worked(const std::optional<disk::FileError>& fault, const std::optional<Written>& written) {
  busy_ = false;
  Ended ended;
  if (fault) ended.not_written = disk::notWritten(*fault);
  ended.written = written;
  if (written && reading_) {
    ended.holes =
        reading_->chunks().holes(readsFrom(order_).value_or(-HUGE_VAL), order_.span.to_s.value_or(HUGE_VAL));
  }
  if (fault || written || cancelled_) return end(std::move(ended));
  proceed();
}

void ExcerptJob::cancel() {
  if (cancelled_.exchange(true) || busy_ || over_) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (!busy_) end({});
      },
      Qt::QueuedConnection);
}

void ExcerptJob::end(Ended ended) {
  if (std::exchange(over_, true)) return;
  walk_.reset();
  writing_.reset();
  // It may be the sender of this signal.
  if (reading_) {
    reading_->disconnect(this);
    replay::Reading* const reading = reading_.release();
    reading->setParent(this);
    reading->deleteLater();
  }
  Q_EMIT this->ended(ended);
}

}  // namespace mapwright::excerpt

#include "moc_excerpt_job.cpp"
