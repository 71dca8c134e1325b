#include "app/map_request.h"

#include <utility>

#include "app/command_text.h"
#include "app/report.h"
#include "grids/grid_pyramid.h"
#include "map/world.h"
#include "regions/region_fetch.h"
#include "robot/map_dispatch.h"
#include "robot/sends_map.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

using Phase = session::MapSlot::Phase;
using robot::DispatchService;

QString byRegionsOnly() { return Text::tr("It sends its map by region: pass --region X,Y,LX,LY."); }

}  // namespace

tl::expected<map::GridRegion, QString> gridRegionFrom(const std::string& typed) {
  const auto given = numbersFrom(typed);
  const std::vector<double> numbers = given && given->size() == 4 ? *given : std::vector<double>(4);
  if (!(numbers[2] > 0) || !(numbers[3] > 0)) {
    return tl::make_unexpected(Text::tr("--region %1: give the centre and the side lengths in "
                                        "metres, X,Y,LX,LY, for example 10,-5,40,30.")
                                   .arg(QString::fromStdString(typed)));
  }
  return map::GridRegion{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

MapRequest::MapRequest(session::Session& session, QString id, bool with_points)
    : session_(session),
      id_(std::move(id)),
      with_points_(with_points),
      present_(std::make_shared<const bool>(true)) {}

bool MapRequest::local() const { return session_.robot().isLocal(); }

void MapRequest::fail(int exit_code, const QString& sentence) {
  failed_ = true;
  failure_ = {exit_code, sentence};
}

void MapRequest::open(const map::MapKey& key) {
  key_ = key;
  session_.openMap(key);
}

MapRequest::State MapRequest::look(double online_for_s) {
  if (failed_) return State::Failed;
  if (!key_) choose();
  if (!key_) return failed_ ? State::Failed : State::Waiting;
  const session::MapSlot& slot = session_.wholeMap();
  if (key_->kind == map::MapKind::Live && slot.phase() == Phase::Fetching && !asked_for_whole_) {
    // The dispatcher may be found a moment later than the robot itself.
    if (robot::givesByRegion(session_.robot())) {
      askForWhole();
    } else if (online_for_s > live_within_s_) {
      chooseInsteadOfLive();
    }
  } else if (slot.key() == *key_ && slot.phase() == Phase::Failed && !shown()) {
    fail(local() ? kUsage : exitCodeOf(slot.failure()), sentences::sentenceOf(slot.remark()));
  }
  if (failed_) return State::Failed;
  // The catalogue tells which map the waypoints belong to.
  const bool whose = with_points_ && key_->kind == map::MapKind::Live && session_.robot().waypointSource();
  if (whose && !session_.catalogue().asked()) session_.catalogue().refresh();
  if (whose && session_.catalogue().loading()) return State::Waiting;
  const bool here = slot.settled() && shown() && !(with_points_ && slot.waypointsAwaited());
  return here ? State::Here : State::Waiting;
}

void MapRequest::choose() {
  if (id_.isEmpty() && !sendsMaps()) {
    chooseCurrent();
    return;
  }
  const std::string id = id_.toStdString();
  const map::MapKey key = id_.isEmpty() ? map::MapKey{map::MapKind::Live, {}} : map::mapKeyFromText(id);
  if (key.kind == map::MapKind::Live && !sendsMaps()) {
    fail(local() ? kUsage : kRobotError,
         Text::tr("It sends no live map. Request one of its stored maps by id (see mapwright maps list)."));
  } else if (local()) {
    // The names of a folder's maps are known once its list has arrived.
    if (!catalogueIn()) return;
    const map::CatalogueEntry* const entry = session_.catalogue().called(id);
    open(entry ? entry->key : key);
  } else {
    open(key);
  }
}

void MapRequest::askForWhole() {
  if (!whole_agreed_) {
    fail(kRobotError,
         words::paragraph(
             {byRegionsOnly(), Text::tr("To get the whole map, whatever its size, pass --mode whole.")}));
    return;
  }
  asked_for_whole_ = true;
  if (!session_.robot().mapDispatch()->offered(DispatchService::Grid)) {
    session_.robot().wholeMapSource()->fetch(*key_, [this, here = std::weak_ptr(present_)](
                                                        const robot::Outcome<map::WholeMap>& outcome) {
      if (here.expired()) return;
      if (outcome) return session_.wholeMap().show(*outcome);
      fail(exitCodeOf(outcome.error().kind), QString::fromStdString(sentences::sentenceOf(outcome.error())));
    });
    return;
  }
  session_.robot().mapDispatch()->grid(
      std::nullopt, [this, here = std::weak_ptr(present_)](const robot::Outcome<map::GridPart>& outcome) {
        if (!here.expired()) onWhole(outcome);
      });
}

void MapRequest::onWhole(const robot::Outcome<map::GridPart>& outcome) {
  if (!outcome) {
    fail(exitCodeOf(outcome.error().kind), QString::fromStdString(sentences::sentenceOf(outcome.error())));
    return;
  }
  const map::GridPart& part = *outcome;
  const bool none = part.grid.width <= 0 || part.grid.height <= 0;
  if (regions::flawOf(part) != regions::Misfit::None) {
    fail(none ? kIncomplete : kRobotError,
         none ? Text::tr("Its map is empty.") : Text::tr("Its whole map cannot be used."));
    return;
  }
  for (const Fault& note : part.notes) notes_ << sentences::wordsOf(note);
  map::WholeMap map;
  map.key = *key_;
  for (const robot::DispatchOffer& offer : session_.robot().mapDispatch()->offers()) {
    if (offer.service == DispatchService::Grid) map.name = offer.name;
  }
  map.grid = part.grid;
  map.reading = {map::CellReading::Mode::Raw};
  map.cells = part.cells;
  session_.wholeMap().show(map);
}

void MapRequest::chooseCurrent() {
  if (!catalogueIn()) return;
  const session::Catalogue& catalogue = session_.catalogue();
  const map::CatalogueEntry* entry = catalogue.current();
  if (!entry && catalogue.entries().size() == 1) entry = &catalogue.entries().front();
  if (entry) {
    open(entry->key);
  } else {
    fail(kRobotError,
         catalogue.entries().empty()
             ? noMapSentence(session_.world().live.map_info)
             : Text::tr("None of its %1 maps is the current one. Pass an id (see mapwright maps list).")
                   .arg(catalogue.entries().size()));
  }
}

QStringList MapRequest::liveTroubles() const {
  if (!sendsMaps()) return {};
  const QStringList topics = session_.robot().liveTopics()->topicsOf(map::Stream::WholeMap);
  QStringList grave, others;
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    const map::Subject& subject = row.problem.subject;
    const bool of_map =
        subject.kind == map::SubjectKind::Topic && topics.contains(QString::fromStdString(subject.id));
    if (row.resolved || !of_map) continue;
    (row.problem.code == map::ProblemCode::Unreadable ? grave : others) << problemLine(row.problem);
  }
  return grave + others;
}

QString noMapSentence(const std::optional<map::MapInfo>& named) {
  return (QStringList(Text::tr("There are no maps.")) + namedMapSentence(named)).join(QLatin1Char(' '));
}

QStringList namedMapSentence(const std::optional<map::MapInfo>& named) {
  if (!named || (named->name.empty() && named->uid.empty())) return {};
  const QString name = words::plainName(named->name.empty() ? named->uid : named->name);
  return {named->name.empty() || named->uid.empty()
              ? Text::tr("Its messages name the map \"%1\".").arg(name)
              : Text::tr("Its messages name the map \"%1\" (%2).").arg(name, words::plainName(named->uid))};
}

void MapRequest::failWithoutLive(const QString& sentence) {
  fail(kRobotError,
       words::paragraph(QStringList(sentence) + namedMapSentence(session_.world().live.map_info) +
                        liveTroubles().mid(0, 1)));
}

QString MapRequest::noMapNow() const {
  return robot::givesByRegion(session_.robot()) ? byRegionsOnly()
                                                : Text::tr("It is sending no map at the moment.");
}

void MapRequest::chooseInsteadOfLive() {
  if (!id_.isEmpty()) {
    failWithoutLive(noMapNow());
    return;
  }
  if (!catalogueIn()) return;
  const map::CatalogueEntry* const current = session_.catalogue().current();
  // For a robot without stored maps the current one is the live map, which does not come.
  if (!current || current->key.kind == map::MapKind::Live) {
    const bool none = local() && session_.catalogue().entries().empty();
    failWithoutLive(
        none ? Text::tr("There are no maps.")
        : current
            ? noMapNow()
            : Text::tr(
                  "It is sending no map at the moment, and none of its stored maps is the current one."));
    return;
  }
  live_broken_ |= !liveTroubles().isEmpty();
  notes_ << (live_broken_
                 ? Text::tr("The live map of the robot cannot be read. Its current stored map is shown.")
                 : Text::tr("The robot is sending no map at the moment. Its current stored map is shown."));
  open(current->key);
}

bool MapRequest::catalogueIn() {
  session::Catalogue& catalogue = session_.catalogue();
  if (!catalogue.offered()) {
    fail(local() ? kUsage : kRobotError,
         sentences::absenceReason(robot::Capability::Catalogue,
                                  session_.robot().unavailableReason(robot::Capability::Catalogue)));
    return false;
  }
  if (!catalogue.asked()) catalogue.refresh();
  if (catalogue.loading()) return false;
  if (!catalogue.failure()) return catalogue.asOf().has_value();
  fail(local() ? kUsage : exitCodeOf(catalogue.failure()->kind),
       QString::fromStdString(sentences::sentenceOf(*catalogue.failure())));
  return false;
}

bool MapRequest::shown() const {
  const session::MapSlot& slot = session_.wholeMap();
  return key_ && slot.cells() && slot.shown().key == *key_;
}

std::optional<render::PlacedGrid> MapRequest::grid() const {
  if (!shown()) return std::nullopt;
  return render::PlacedGrid{session_.wholeMap().cells(), session_.wholeMap().reference()};
}

bool MapRequest::complete() const {
  const session::MapSlot& slot = session_.wholeMap();
  return shown() && slot.key() == *key_ && slot.phase() == Phase::Ready && slot.isWhole() && !live_broken_;
}

}  // namespace mapwright::app
