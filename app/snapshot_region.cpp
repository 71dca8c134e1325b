#include "app/snapshot_region.h"

#include <utility>

#include <QJsonArray>

#include "app/command_text.h"
#include "app/snapshot.h"
#include "regions/region_sentence.h"
#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"
#include "sentences/plural.h"
#include "words/listed.h"

namespace mapwright::app {

std::optional<CommandFailure> RegionSnapshot::begin(robot::Robot& robot, double online_for_s, double within_s,
                                                    std::function<void()> finished) {
  robot::MapDispatch* const dispatch = robot.mapDispatch();
  if (dispatch && dispatch->offered(robot::DispatchService::GridRegion)) {
    regions::RegionFetch::Options options;
    options.retry_after = regions::Millis(300);
    fetch_ = std::make_unique<regions::RegionFetch>(*dispatch, rect_, options);
    QObject::connect(fetch_.get(), &regions::RegionFetch::finished, fetch_.get(), std::move(finished));
    fetch_->start();
    return std::nullopt;
  }
  if (online_for_s <= within_s) return std::nullopt;
  const QString why =
      dispatch && dispatch->offered(robot::DispatchService::Grid)
          ? Text::tr("It only sends its map as a whole.")
      : dispatch ? Text::tr("It has no map in the plane, only a 3D map: pass --map projected_map_0 instead.")
                 : sentences::absenceReason(robot::Capability::Dispatch,
                                            robot.unavailableReason(robot::Capability::Dispatch));
  return CommandFailure{exitCodeOf(map::FailureKind::Unsupported),
                        Text::tr("%1: it does not offer its map by region. %2").arg(robot_, why)};
}

double RegionSnapshot::scale() const {
  if (scale_m_per_px_ > 0) return scale_m_per_px_;
  return fetch_ ? regions().plan().resolution().value_or(0) : 0;
}

CommandResult<std::optional<QSize>> RegionSnapshot::size() const {
  if (scale() <= 0) return std::optional<QSize>();
  const auto size = pixelsOf(rect_, scale());
  if (!size) return wrong(Text::tr("--region is too large for one picture: choose a coarser --scale."));
  return size;
}

CommandResult<QStringList> RegionSnapshot::notes(const QString& link) const {
  const auto fail = [](int exit_code, const QString& sentence) {
    return tl::make_unexpected(CommandFailure{exit_code, sentence});
  };
  if (fetch_ && fetch_->tooLarge())
    return wrong(Text::tr("--region is too large: it has more cells than can be fetched for one picture."));
  const QString trouble = fetch_ ? regions::sentenceOf(fetch_->trouble()) : QString();
  const regions::RegionCounts counts = fetch_ ? fetch_->counts() : regions::RegionCounts{};
  if (counts.answered == 0 && !(fetch_ && regions().holdsAnyOf(rect_))) {
    const bool failed = over() && fetch_->trouble().kind == regions::RegionTrouble::Kind::Failed;
    return fail(exitCodeOf(failed ? fetch_->trouble().failure.kind : map::FailureKind::TimedOut),
                words::paragraph(
                    {Text::tr("%1: no part of the region could be fetched. %2").arg(robot_, trouble), link}));
  }
  if (scale() <= 0) {
    return fail(kIncomplete, Text::tr("%1: the map is empty in this region, so the size of its cells is "
                                      "unknown. Pass --scale to set the size of a pixel.")
                                 .arg(robot_));
  }
  if (const auto fits = size(); !fits) return passOn(fits);
  QStringList notes;
  if (const std::int64_t odd = regions().oddCells(); odd > 0) {
    notes << Text::tr(
                 "%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as "
                 "100, values below -1 as unknown.",
                 nullptr, sentences::formOf(qint64(odd)))
                 .arg(odd);
  }
  if (counts.smaller > 0 && counts.answered == counts.in_view) {
    notes << Text::tr(
                 "Some of its answers are smaller than requested (%1 of %2): the missing parts are blank.")
                 .arg(QString::number(counts.smaller), QString::number(counts.in_view));
  } else if (!fetch_->complete()) {
    notes << Text::tr("Parts of the region are missing (%1 of %2 arrived). %3")
                 .arg(QString::number(counts.answered), QString::number(counts.in_view), trouble);
  }
  return notes;
}

regions::RegionMap* RegionSnapshot::still() {
  fetch_->map().standStill();
  return &fetch_->map();
}

std::optional<QString> RegionSnapshot::putInto(ui::shot::RawContent& content) {
  still();
  const regions::FetchedGrid fetched = regions::cutOut(regions().sheets(), rect_, regions::CutEdge::Touched);
  if (fetched.cells) content.grid = render::PlacedGrid{fetched.cells, fetched.reference};
  if (fetched.other_lattices <= 0) return std::nullopt;
  return Text::tr("Some of its answers have cells of another size or orientation and were left out.");
}

QJsonObject RegionSnapshot::json() const {
  QJsonObject json{
      {QStringLiteral("center"), QJsonArray{rect_.center().x(), rect_.center().y()}},
      {QStringLiteral("lengths"), QJsonArray{rect_.width(), rect_.height()}},
  };
  if (!fetch_) return json;
  const regions::RegionCounts counts = fetch_->counts();
  json[QStringLiteral("parts")] = counts.in_view;
  json[QStringLiteral("answered")] = counts.answered;
  json[QStringLiteral("empty")] = counts.nothing;
  json[QStringLiteral("failed")] = counts.failed;
  const auto resolution = regions().plan().resolution();
  json[QStringLiteral("resolution")] = resolution ? QJsonValue(*resolution) : QJsonValue();
  json[QStringLiteral("frame")] = QString::fromStdString(regions().frame());
  return json;
}

}  // namespace mapwright::app
