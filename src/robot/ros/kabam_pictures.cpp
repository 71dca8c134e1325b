#include "robot/ros/kabam_pictures.h"

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
  return {.kind = map::FailureKind::Unsupported,
          .subject = subject,
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Unfit,
          .cause = std::move(cause)};
}

milliseconds timeFor(const grids::GridPyramid& cells) {
  return milliseconds(std::int64_t(cells.width()) * cells.height() / kBytesPerMs);
}

}  // namespace

KabamPictures::KabamPictures(Means means, KabamPatience patience, milliseconds settles)
    : means_(std::move(means)), patience_(patience) {
  settle_.setSingleShot(true);
  settle_.setInterval(settles);
  connect(&settle_, &QTimer::timeout, this, &KabamPictures::compare);
  connect(&means_.live_map, &LiveMap::came, &waits_, &wire::WaitList::look);
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
  return map::Failure{.kind = map::FailureKind::Conflict,
                      .subject = writing.subject(),
                      .asked_for = map::AskedFor::Change,
                      .cause = {fault::PictureChangedMeanwhile, {writing.name}}};
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
  request.timeout = patience_.call + timeFor(*writing->change.cells);
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
  // Once there is a connection again, the map tells what has become of it.
  if (writing->doubt->applied != map::Applied::No) doubt(writing->change.map.id);
  end(writing, fail(*writing->doubt));
}

/// Waits for the map to show it; requests it once more half-way, in case it is not sent automatically.
void KabamPictures::confirm(const WritingPtr& writing) {
  writing->within = patience_.confirm + timeFor(*writing->change.cells);
  writing->confirming = true;
  QTimer::singleShot(writing->within / 2, this, [this, held = std::weak_ptr(writing)] {
    const WritingPtr now = held.lock();
    if (now && now->confirming) means_.ask_again();
  });
  waits_.await(
      writing->errand, writing->within,
      [this, writing] {
        const std::string& wanted = writing->args->fingerprint();
        return !wanted.empty() && shows(wanted);
      },
      [this, writing](wire::WaitList::End how) {
        writing->confirming = false;
        if (how == wire::WaitList::End::Held)
          return end(writing, PictureReceipt{writing->args->fingerprint()});
        doubt(writing->change.map.id);
        if (how == wire::WaitList::End::Cancelled) return end(writing, fail(cancelled(writing->subject())));
        giveUp(writing);
      });
}

void KabamPictures::giveUp(const WritingPtr& writing) {
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

void KabamPictures::doubt(const std::string& map_id) {
  doubted_.insert(map_id);
  settle_.start();
}

void KabamPictures::compare() {
  const KabamBook& book = means_.requests.book();
  const bool told = means_.known() && means_.requests.there() && book.current() && !book.isMapping();
  if (!told || book.current()->map.id.empty()) return;
  const std::string& id = book.current()->map.id;
  const auto& last = means_.live_map.last();
  bool other = doubted_.erase(id) > 0;
  if (last) {
    std::string& seen = seen_[id];
    other |= !seen.empty() && seen != last->fingerprint;
    seen = last->fingerprint;
  }
  if (other) Q_EMIT changed(QString::fromStdString(id));
}

void KabamPictures::end(const WritingPtr& writing, Outcome<PictureReceipt> outcome) {
  if (!outcome && outcome.error().kind == map::FailureKind::Conflict) doubt(writing->change.map.id);
  writing->reply(std::move(outcome));
  writing->listening.reset();
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_pictures.cpp"
