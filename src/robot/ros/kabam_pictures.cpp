#include "robot/ros/kabam_pictures.h"

#include <algorithm>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/kabam_failures.h"
#include "robot/ros/kabam_results.h"
#include "robot/ros/ros_calls.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;
using std::chrono::milliseconds;

/// The expected minimum speed.
constexpr std::int64_t kBytesPerMs = 1024;

map::Failure unfit(const map::Subject& subject, Fault cause) {
  map::Failure failure;
  failure.kind = map::FailureKind::Unsupported;
  failure.subject = subject;
  failure.asked_for = map::AskedFor::Change;
  failure.reason = map::FailureReason::Unfit;
  failure.cause = std::move(cause);
  return failure;
}

milliseconds timeFor(const grids::GridPyramid& cells) {
  return milliseconds(std::int64_t(cells.width()) * cells.height() / kBytesPerMs);
}

}  // namespace

KabamPictures::KabamPictures(Means means, KabamPatience patience, QObject* parent)
    : QObject(parent), means_(std::move(means)), patience_(patience) {
  connect(&means_.live_map, &LiveMap::came, this, &KabamPictures::look);
}

void KabamPictures::write(const wire::ErrandPtr& errand, const PictureChange& change,
                          OutcomeTo<PictureReceipt> reply) {
  const auto writing = std::make_shared<Writing>();
  writing->change = change;
  writing->reply = std::move(reply);
  writing->errand = errand;
  means_.requests.describe(errand, change.map, [this, writing](Outcome<map::CatalogueEntry> entry) {
    if (!entry) {
      entry.error().asked_for = map::AskedFor::Change;
      return end(writing, fail(std::move(entry.error())));
    }
    writing->name = entry->name;
    if (!entry->is_current)
      return end(writing, fail(unfit(writing->subject(), {fault::OnlyCurrentMapTaken})));
    readAgain(writing);
  });
}

void KabamPictures::readAgain(const WritingPtr& writing) {
  // If it is already subscribed, there may be no further message: request it again.
  means_.live_map.forget();
  means_.ask_again();
  writing->listening = means_.live_map.listen();
  means_.live_map.fetch(
      writing->errand, writing->change.map, writing->name,
      [this, writing](Outcome<map::WholeMap> now) {
        if (!now) {
          now.error().asked_for = map::AskedFor::Change;
          now.error().subject = writing->subject();
          return end(writing, fail(std::move(now.error())));
        }
        if (auto failure = conflict(*writing)) return end(writing, fail(std::move(*failure)));
        send(writing);
      },
      timeFor(*writing->change.cells));
}

/// What is on the robot now is not what the change was made of, or is no more the map that the robot sends.
/// Of what is not known now (on a connection that is new) nothing is said.
std::optional<map::Failure> KabamPictures::conflict(const Writing& writing) const {
  const KabamBook& book = means_.requests.book();
  if (book.current() && !book.isCurrent(writing.change.map.id))
    return unfit(writing.subject(), {fault::OnlyCurrentMapTaken});
  const auto& last = means_.live_map.last();
  const grids::GridPyramid& cells = *writing.change.cells;
  const bool fits = !last || (last->fingerprint == writing.change.revision &&
                              last->grid.width == cells.width() && last->grid.height == cells.height());
  if (fits) return std::nullopt;
  map::Failure failure;
  failure.kind = map::FailureKind::Conflict;
  failure.subject = writing.subject();
  failure.asked_for = map::AskedFor::Change;
  failure.cause = {fault::PictureChangedMeanwhile, {writing.name}};
  return failure;
}

bool KabamPictures::shows(const std::string& fingerprint) const {
  const auto& last = means_.live_map.last();
  return last && last->fingerprint == fingerprint;
}

void KabamPictures::send(const WritingPtr& writing) {
  KabamBook& book = means_.requests.book();
  const KabamMap map = book.find(writing->change.map.id).value_or(KabamMap{});
  writing->args =
      std::make_shared<PictureArgs>(map, writing->change.cells, [this, asked = std::weak_ptr(writing)] {
        const WritingPtr now = asked.lock();
        // Changes by others during the upload are not overwritten silently.
        if (now) now->changed_meanwhile = conflict(*now).has_value();
        return now && !now->changed_meanwhile;
      });
  net::rosbridge::CallRequest request;
  request.service = book.place() + "/update_map_image";
  request.made_while_sent = writing->args;
  request.travelled = [errand = writing->errand](qint64 bytes, qint64 of_bytes) {
    errand->tell({bytes, of_bytes});
  };
  request.large = true;
  request.patience = patience_.call + timeFor(*writing->change.cells);
  call(writing->errand, means_.client, std::move(request),
       [this, writing](const CallAnswer& answer) { takeAnswer(writing, answer); });
}

void KabamPictures::takeAnswer(const WritingPtr& writing, const CallAnswer& answer) {
  const map::Subject subject = writing->subject();
  const bool answered = answer.kind == CallAnswer::Kind::Answered;
  if (!answer.sent) {
    if (const auto cell = writing->args->cellBetween()) {
      return end(writing, fail(unfit(subject, {fault::CellBetweenKinds, {std::int64_t(*cell)}})));
    }
    if (writing->changed_meanwhile) {
      if (auto failure = conflict(*writing)) return end(writing, fail(std::move(*failure)));
    }
  }
  writing->doubt = answered ? updateMapResult(answer.values, subject)
                            : std::optional(failed(answer, subject, map::AskedFor::Change));
  const bool ends = writing->doubt &&
                    (writing->doubt->applied == map::Applied::No ||
                     answer.kind == CallAnswer::Kind::Cancelled || answer.kind == CallAnswer::Kind::LinkLost);
  if (!ends) return confirm(writing);
  // After a reconnect the map shows the result.
  if (writing->doubt->applied != map::Applied::No) Q_EMIT doubted(writing->change.map.id);
  end(writing, fail(*writing->doubt));
}

/// Waits for the map to show it; requests it once more half-way, in case it is not sent automatically.
void KabamPictures::confirm(const WritingPtr& writing) {
  writing->within = patience_.confirm + timeFor(*writing->change.cells);
  confirming_.push_back(writing);
  const auto timer = [this, &writing](milliseconds after, auto then) {
    auto made = std::make_unique<QTimer>();
    made->setSingleShot(true);
    connect(made.get(), &QTimer::timeout, this, [held = std::weak_ptr(writing), then] {
      if (const WritingPtr now = held.lock()) then(now);
    });
    made->start(after);
    return made;
  };
  writing->halfway = timer(writing->within / 2, [this](const WritingPtr&) { means_.ask_again(); });
  writing->patience = timer(writing->within, [this](const WritingPtr& now) { giveUp(now); });
  writing->number = writing->errand->begun([this, held = std::weak_ptr(writing)] {
    QMetaObject::invokeMethod(
        this,
        [this, held] {
          const WritingPtr now = held.lock();
          if (!now || !finishConfirming(now)) return;
          Q_EMIT doubted(now->change.map.id);
          end(now, fail(cancelled(now->subject())));
        },
        Qt::QueuedConnection);
  });
  look();
}

void KabamPictures::look() {
  const std::list<WritingPtr> now = confirming_;
  for (const WritingPtr& writing : now) {
    const std::string& wanted = writing->args->fingerprint();
    if (wanted.empty() || !shows(wanted) || !finishConfirming(writing)) continue;
    PictureReceipt receipt;
    receipt.revision = wanted;
    end(writing, std::move(receipt));
  }
}

void KabamPictures::giveUp(const WritingPtr& writing) {
  if (!finishConfirming(writing)) return;
  Q_EMIT doubted(writing->change.map.id);
  if (writing->doubt) return end(writing, fail(std::move(*writing->doubt)));
  const auto& last = means_.live_map.last();
  const bool other = last && last->png && !shows(writing->change.revision) &&
                     means_.requests.book().isCurrent(writing->change.map.id);
  const auto cells = other ? differingCells(*writing->change.cells, *last->png) : std::nullopt;
  if (!cells) return end(writing, fail(unconfirmed(writing->subject(), writing->within)));
  map::Failure failure = unfit(writing->subject(), {fault::PictureShownOtherwise, {*cells}});
  failure.kind = map::FailureKind::RejectedByRobot;
  failure.applied = map::Applied::Yes;
  end(writing, fail(std::move(failure)));
}

/// False: already finished.
bool KabamPictures::finishConfirming(const WritingPtr& writing) {
  const auto found = std::find(confirming_.begin(), confirming_.end(), writing);
  if (found == confirming_.end()) return false;
  confirming_.erase(found);
  for (std::unique_ptr<QTimer>* timer : {&writing->halfway, &writing->patience}) {
    (*timer)->stop();
    (*timer)->setParent(this);        // deleted with this at the latest
    timer->release()->deleteLater();  // it may be emitting the current signal
  }
  writing->errand->ended(writing->number);
  return true;
}

void KabamPictures::end(const WritingPtr& writing, Outcome<PictureReceipt> outcome) {
  if (!outcome && outcome.error().kind == map::FailureKind::Conflict) Q_EMIT doubted(writing->change.map.id);
  writing->reply(std::move(outcome));
  writing->listening.reset();
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_pictures.cpp"
