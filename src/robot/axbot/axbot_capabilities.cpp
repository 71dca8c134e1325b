#include "robot/axbot/axbot_capabilities.h"

#include <utility>

#include <QPointer>

#include "robot/axbot/stream_topics.h"

namespace mapwright::robot::axbot {
namespace {

const map::Subject kList(map::SubjectKind::Catalogue, map::kMapsPart);

}  // namespace

Submaps::Submaps(Line line) : line_(line) {
  QObject::connect(line_.link, &AxbotLink::answered, line_.asker,
                   [this](quint64 ticket, const map::SubmapAnswer& answer) {
                     auto entry = waiting_.extract(ticket);
                     if (entry.empty()) return;
                     entry.mapped().state->over = true;
                     entry.mapped().state->cancel = nullptr;
                     entry.mapped().reply(answer);
                   });
}

Submaps::~Submaps() {
  for (auto& [ticket, waiting] : waiting_) {
    waiting.state->over = true;
    waiting.state->cancel = nullptr;
  }
}

Call Submaps::fetch(const map::SubmapKey& key, Reply reply) {
  const quint64 ticket = ++last_;
  auto state = std::make_shared<Call::State>();
  state->cancel = [line = line_, ticket] {
    line.run([ticket](AxbotLink& link) { link.cancelFetch(ticket); });
  };
  waiting_.emplace(ticket, Waiting{std::move(reply), state});
  line_.run([ticket, key](AxbotLink& link) { link.fetch(ticket, key); });
  return Call(std::move(state));
}

void Submaps::cancelAll() {
  line_.run([](AxbotLink& link) { link.cancelAll(); });
}

void Submaps::cancel(const map::SubmapKey& key) {
  line_.run([key](AxbotLink& link) { link.cancel(key); });
}

void Submaps::discard(const map::SubmapKey& key, std::int32_t answered_version) {
  line_.run([key, answered_version](AxbotLink& link) { link.discard(key, answered_version); });
}

Call Catalogue::list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  return wire::askAcross(
      line_.asker, line_.link, lists_, kList, std::move(reply),
      [](AxbotLink& link, auto errand, auto answer) { link.maps().list(errand, std::move(answer)); });
}

Call Catalogue::describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  return wire::askAcross(line_.asker, line_.link, descriptions_, map::subjectOf(key), std::move(reply),
                         [key](AxbotLink& link, auto errand, auto answer) {
                           link.maps().describe(errand, key, std::move(answer));
                         });
}

Call Catalogue::thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) {
  return wire::askAcross(line_.asker, line_.link, thumbnails_, map::subjectOf(key), std::move(reply),
                         [key](AxbotLink& link, auto errand, auto answer) {
                           link.maps().thumbnail(errand, key, std::move(answer));
                         });
}

void Catalogue::discardThumbnail(const map::MapKey& key) {
  line_.run([key](AxbotLink& link) { link.maps().discardThumbnail(key); });
}

Call WholeMaps::fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  return wire::askAcross(line_.asker, line_.link, maps_, map::subjectOf(key), std::move(reply),
                         [key](AxbotLink& link, auto errand, auto answer) {
                           link.maps().fetch(errand, key, std::move(answer));
                         });
}

void WholeMaps::discardPicture(const std::string& fingerprint) {
  line_.run([fingerprint](AxbotLink& link) { link.discardPicture(fingerprint); });
}

Call Overview::fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) {
  return wire::askAcross(line_.asker, line_.link, maps_, map::Subject(map::SubjectKind::Overview),
                         std::move(reply), [resolution_m](AxbotLink& link, auto errand, auto answer) {
                           link.fetchOverview(errand, resolution_m, std::move(answer));
                         });
}

std::optional<Obstacle> Administration::obstacle(MapChange change, const map::CatalogueEntry* map) const {
  if (change != MapChange::Rename && change != MapChange::Load) return Obstacle::NotOffered;
  if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
  return change == MapChange::Load && map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
}

Call Administration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  const map::Subject subject = map::subjectOf(order.key);
  if (order.change != MapChange::Rename && order.change != MapChange::Load) {
    return wire::endLater<map::CatalogueEntry>(
        line_.asker, changes_, std::move(reply),
        tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                         .subject = subject,
                                         .asked_for = map::AskedFor::Change,
                                         .reason = map::FailureReason::NotOffered}));
  }
  return wire::askAcross(
      line_.asker, line_.link, changes_, subject, telling(std::move(reply)),
      [order](AxbotLink& link, auto errand, auto answer) {
        if (order.change == MapChange::Rename) {
          link.maps().rename(errand, order.key, order.name, std::move(answer));
        } else {
          link.maps().load(errand, order.key, std::move(answer));
        }
      },
      wire::Stopping::AsItStands);
}

OutcomeTo<map::CatalogueEntry> Administration::telling(OutcomeTo<map::CatalogueEntry> reply) const {
  return [asker = QPointer<QObject>(line_.asker), changed = changed_,
          reply = std::move(reply)](Outcome<map::CatalogueEntry> outcome) {
    if (outcome || outcome.error().applied != map::Applied::No) changed();
    if (asker) reply(std::move(outcome));
  };
}

QStringList Topics::topicsOf(map::Stream stream) const {
  const StreamTopics topics = axbot::topicsOf(stream);
  return topics.usual + topics.older;
}

void Topics::setWanted(const map::Streams& streams, const QStringList& topics) {
  line_.run([streams, topics](AxbotLink& link) { link.setWanted(streams, topics); });
}

void Topics::setBasics(const Basics& basics) {
  line_.run([basics](AxbotLink& link) { link.setBasics(basics); });
}

void Topics::setWatching(bool on) {
  line_.run([on](AxbotLink& link) { link.setWatching(on); });
}

}  // namespace mapwright::robot::axbot
