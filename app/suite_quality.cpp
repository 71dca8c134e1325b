#include "app/suite_quality.h"

#include <chrono>
#include <utility>

#include <QThread>

#include "agreement/survey.h"
#include "app/command_text.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/submaps_complete.h"
#include "submap/submap_store.h"
#include "words/listed.h"

namespace mapwright::app {
namespace {

static_assert(suite::Quality::kMostTolerance == agreement::kMostTolerance);

void takeClosures(const session::Session& session, suite::Examined& examined) {
  const session::PoseGraphSlot& graph = session.poseGraph();
  examined.closures = graph.closures();
  if (examined.closures) return;
  QString why = Text::tr("Loop closures could not be judged: the pose graph was not read.");
  if (!graph.offered()) {
    const auto absence = session.robot().unavailableReason(robot::Capability::PoseGraph);
    why = words::paragraph({Text::tr("Loop closures could not be judged."),
                            sentences::absenceReason(robot::Capability::PoseGraph, absence)});
  } else if (graph.failure()) {
    why = words::paragraph({why, QString::fromStdString(sentences::failureReason(*graph.failure()))});
  }
  examined.lacks << why;
}

QString notComparedText(const QString& why) {
  return Text::tr("Whether submaps contradict each other could not be judged: %1").arg(why);
}

/// All submaps, placed. The error is a sentence.
tl::expected<std::shared_ptr<agreement::Survey>, QString> surveyOf(const session::Session& session,
                                                                   int tolerance_cells) {
  const session::SubmapCounts counts = session.counts();
  if (!counts.list_received) return tl::make_unexpected(Text::tr("there is no list of submaps here."));
  if (!session::submapsComplete(counts, session.problems()) || session.lostPictures() > 0)
    return tl::make_unexpected(
        Text::tr("%1 of %2 submaps are here.").arg(counts.shown + counts.without_slice).arg(counts.listed));
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session.submaps().rows()) {
    if (const auto placement = session.submaps().placement(id, session.slice()))
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
  }
  if (textures.empty()) return tl::make_unexpected(Text::tr("there are no submaps."));
  agreement::Rules rules;
  rules.tolerance_cells = tolerance_cells;
  const auto survey = std::make_shared<agreement::Survey>(rules);
  if (const auto fault = survey->setSubmaps(textures))
    return tl::make_unexpected(sentences::sentenceOf(*fault));
  if (!survey->unplaceable().empty())
    return tl::make_unexpected(Text::tr("submap %1 lies too far away.")
                                   .arg(QString::fromStdString(map::toText(survey->unplaceable().front()))));
  return survey;
}

void addDisagreement(const agreement::Disagreement& found, suite::Examined& examined) {
  examined.disagreement = suite::DisagreementFact{found.tolerance_cells, std::int64_t(found.occupied_cells),
                                                  std::int64_t(found.contradicted_cells)};
  for (const agreement::Place& place : found.places)
    examined.squares.push_back(
        {{place.x, place.y}, std::int64_t(place.cells), agreement::idsOf(place.submaps)});
}

}  // namespace

void examine(const suite::Quality& asked, const session::Session& session, const ExaminingMeans& means,
             QObject* context, std::function<void(suite::Examined)> done) {
  suite::Examined examined;
  if (asked.closures_over_m) takeClosures(session, examined);
  if (!asked.disagreement_over) return done(std::move(examined));
  const auto survey = surveyOf(session, asked.tolerance_cells);
  if (!survey) {
    examined.lacks << notComparedText(survey.error());
    return done(std::move(examined));
  }
  const auto in_time = std::make_shared<bool>(false);
  // A thread of its own: other views wait for their robots on this one.
  QThread* const thread = QThread::create([survey = *survey, means, in_time] {
    const auto begun = std::chrono::steady_clock::now();
    *in_time = survey->makeAll(means.workers, *means.dense, [&](std::size_t, std::size_t) {
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
      return took.count() <= means.timeout_s;
    });
  });
  QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
  QObject::connect(thread, &QThread::finished, context,
                   [&session, survey = *survey, in_time, timeout_s = means.timeout_s,
                    examined = std::move(examined), done = std::move(done)]() mutable {
                     if (*in_time && session.lostPictures() == 0) {
                       addDisagreement(survey->disagreement(), examined);
                     } else {
                       examined.lacks << notComparedText(
                           *in_time ? Text::tr("some could not be read back from the disk.")
                                    : Text::tr("comparing them took longer than %1 s.").arg(timeout_s));
                     }
                     done(std::move(examined));
                   });
  thread->start();
}

}  // namespace mapwright::app
