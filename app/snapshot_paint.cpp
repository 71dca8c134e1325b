// SnapshotRun: the final content of the picture, and the output.
#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QJsonArray>

#include "app/exit_code.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "app/snapshot_content.h"
#include "app/snapshot_run.h"
#include "replay/replay_robot.h"
#include "sentences/fault_sentence.h"
#include "ui/replay/track_on_map.h"

namespace mapwright::app {
namespace {

class SnapshotPaintText {
  Q_DECLARE_TR_FUNCTIONS(SnapshotRun)
};

}  // namespace

bool SnapshotRun::waypointsLost() const {
  if (options_.raw || !wantsWhole(options_) || !options_.layers.contains(scene::Layer::Waypoints))
    return false;
  const auto& rows = session_.problems().rows();
  return std::any_of(rows.begin(), rows.end(), [](const session::LoggedProblem& row) {
    return !row.resolved && row.problem.subject.kind == map::SubjectKind::Places &&
           row.problem.code == map::ProblemCode::Unavailable;
  });
}

void SnapshotRun::paint(bool settled) {
  if (done_ || chosen_) return;
  if (options_.region && !sizeRegion()) return;
  if (!options_.region && options_.mode == SnapshotMode::Whole && !map_.grid()) {
    const QString which =
        options_.map ? SnapshotPaintText::tr("map %1").arg(QString::fromStdString(map::toText(*options_.map)))
                     : SnapshotPaintText::tr("its map");
    fail(exitCodeOf(map::FailureKind::TimedOut),
         SnapshotPaintText::tr("%1: %2 had not arrived within %3 s (%4). There is nothing to draw.")
                 .arg(options_.robot, which, QString::number(options_.settle_s.value_or(options_.timeout_s)),
                      options_.settle_s ? QStringLiteral("--settle") : QStringLiteral("--timeout")) +
             whatOfTheLink() +
             (QStringList(QString()) + map_.liveTroubles().mid(0, 1)).join(QLatin1Char(' ')));
    return;
  }
  poll_.stop();
  settle_.stop();
  // Drawing takes a while. Messages that arrive meanwhile must change neither the picture nor the report.
  session_.standStill();
  // Closing drops everything read from a bag.
  const auto track = wantsTrack() ? window::trackOfBag(*replayed_->reading()) : nullptr;
  session_.close();
  chosen_ = std::make_unique<SnapshotChoice>();
  chosen_->counts = session_.counts();
  chosen_->problems = problemLines(session_.problems());
  chosen_->refused = anyRefused(session_.problems());
  if (const auto grid = wantsWhole(options_) ? map_.grid() : std::nullopt) {
    chosen_->map = mapJson(*map_.key(), session_.wholeMap().name(), grid->reference);
  }
  complete_ = settled && (!wantsSubmaps(options_) || submapsComplete(chosen_->counts)) &&
              (!wantsWhole(options_) || scans_alone_ || map_.complete()) && !waypointsLost() &&
              (!options_.region || fetch_->complete()) && (!wantsCloud() || cloud_.came()) &&
              bagLosses(session_.problems()).isEmpty();
  // Also printed to standard error although nothing is missing.
  const auto say = [this](const QString& note) {
    notes_ << note;
    shown_instead_ += (shown_instead_.isEmpty() ? QString() : QStringLiteral(" ")) + note;
  };
  if (wantsCloud() && !cloud_.problem().isEmpty()) notes_ << cloud_.problem();
  // Nothing may look as if it had been recorded.
  if (replayed_ && !options_.map && wantsWhole(options_) && map_.key() &&
      map_.key()->kind != map::MapKind::Live) {
    say(isLocal() ? SnapshotPaintText::tr(
                        "The bag contains no map up to this time: the one recorded with it is drawn.")
                  : SnapshotPaintText::tr(
                        "The bag contains no map up to this time: the robot's present map is drawn."));
  }
  if (lacksSubmaps())
    notes_ << SnapshotPaintText::tr(
        "The bag contains no submap list up to this time: there are no submaps to draw.");
  noteChosenTopics();
  for (const QString& topic : live_layers_.silent()) {
    // Nothing is requested for a bag: data that is not in it is not missing.
    if (replayed_) break;
    notes_ << SnapshotPaintText::tr("Nothing arrived on topic %1 within %2 s.")
                  .arg(topic, QString::number(options_.settle_s.value_or(kTopicsWithinS)));
  }
  for (const scene::Layer layer : live_layers_.unfillable()) {
    if (!options_.named.contains(layer)) continue;
    say((replayed_ ? SnapshotPaintText::tr("Layer %1 is empty: the bag has no topic for it.")
                   : SnapshotPaintText::tr("Layer %1 is empty: the robot has no topic for it."))
            .arg(scene::layerName(layer)));
  }
  const session::SubmapCounts& counts = chosen_->counts;
  if (counts.without_slice > 0 && counts.without_slice == counts.listed) {
    notes_ << SnapshotPaintText::tr("No submap has a slice %1 (--slice): the picture is empty.")
                  .arg(options_.slice);
  }
  view_ = viewOf(options_, session_, map_);
  noteStanding();
  Q_EMIT contentChosen();
  SnapshotContent content = contentOf(options_, session_, map_, view_);
  if (options_.region) takeRegion(content);
  if (wantsCloud()) content.cloud = cloud_.came();
  content.track = track;
  picture_ = options_.raw ? makeRawPicture(content, workers_)
                          : makeScenePicture(options_, session_, content, workers_);
  connect(picture_.get(), &SnapshotPicture::finished, this, &SnapshotRun::write);
  picture_->start();
  notes_ += picture_->notes();
}

void SnapshotRun::noteChosenTopics() {
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  if (!of || !of->offered()) return;
  for (const auto& [stream, topic] : options_.topics) {
    if (of->choicesFor(stream).contains(topic)) continue;
    QString fitting = of->choicesFor(stream).join(QLatin1String(", "));
    if (fitting.isEmpty()) fitting = SnapshotPaintText::tr("none");
    notes_ << SnapshotPaintText::tr(
                  "Topic %1 does not exist or its type does not fit the layer. Topics that fit: %2.")
                  .arg(topic, fitting);
    complete_ = false;
  }
}

void SnapshotRun::write() {
  if (done_) return;
  made_ = picture_->made();
  if (const auto grid = wantsWhole(options_) ? map_.grid() : std::nullopt;
      grid && grid->cells->trouble().any()) {
    complete_ = false;
    notes_.prepend(sentences::wordsOf(grid->cells->trouble()));
  }
  if (session_.lostPictures() > 0) {
    complete_ = false;
    notes_.prepend(SnapshotPaintText::tr(
                       "%1 submaps could not be read back from the disk: parts of the picture are empty.",
                       nullptr, int(session_.lostPictures()))
                       .arg(session_.lostPictures()));
  }
  if (const auto why = overItsSource()) {
    fail(kUsage, *why);
  } else if (const auto error = picture_->write(options_.output)) {
    fail(kUsage, *error);
  } else {
    finish(complete_ ? kDone : chosen_->refused ? exitCodeOf(map::FailureKind::Refused) : kIncomplete);
  }
}

std::optional<QString> SnapshotRun::overItsSource() const {
  if (options_.force) return std::nullopt;
  const session::MapSlot& slot = session_.wholeMap();
  return overOwnSource({options_.output, options_.report},
                       sourceFilesOf(options_.robot, slot.key().id, slot.shown().path));
}

QStringList SnapshotRun::warnings() const {
  QStringList all;
  if (!error_.isEmpty()) all << error_;
  all += chosen_ ? chosen_->problems : problemLines(session_.problems());
  return all + map_.notes() + notes_;
}

QJsonObject SnapshotRun::report() const {
  SnapshotFacts facts;
  facts.complete = complete_;
  facts.whole = options_.mode == SnapshotMode::Whole;
  facts.uuid = QString::fromStdString(session_.submaps().uuid());
  facts.counts = chosen_ ? chosen_->counts : session_.counts();
  facts.made = made_;
  facts.connected_s = connected_s_;
  facts.first_paint_s = first_paint_s_;
  facts.complete_s = complete_s_;
  facts.view = view_;
  facts.warnings = warnings();
  if (chosen_) facts.map = chosen_->map;
  facts.region = regionJson();
  return reportOf(facts);
}

}  // namespace mapwright::app
