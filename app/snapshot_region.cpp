// SnapshotRun: the picture of a region.
#include <algorithm>

#include <QCoreApplication>
#include <QJsonArray>

#include "app/exit_code.h"
#include "app/snapshot_content.h"
#include "app/snapshot_run.h"
#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"
#include "sentences/plural.h"
#include "sentences/region_sentence.h"

namespace mapwright::app {
namespace {

class SnapshotRegionText {
  Q_DECLARE_TR_FUNCTIONS(SnapshotRun)
};

constexpr double kOffersWithinS = 12;  // after connecting: a slow robot is asked twice
constexpr double kPixelsDrawnInASecond = 2e6;
constexpr double kMostOfTimeToDraw = 0.4;

}  // namespace

void SnapshotRun::lookAtRegion() {
  robot::Robot& robot = session_.robot();
  robot::MapDispatch* const dispatch = robot.mapDispatch();
  if (!fetch_) {
    if (dispatch && dispatch->offered(robot::DispatchService::GridRegion)) {
      regions::RegionFetch::Options options;
      options.retry_after = regions::Millis(300);
      fetch_ = std::make_unique<regions::RegionFetch>(*dispatch, *options_.region, options);
      connect(fetch_.get(), &regions::RegionFetch::finished, this, &SnapshotRun::look);
      fetch_->start();
    } else if (seconds() - connected_s_ > std::min(kOffersWithinS, options_.timeout_s / 2)) {
      const QString why = dispatch ? SnapshotRegionText::tr("It only sends its map as a whole.")
                                   : sentences::whyAbsent(robot::Capability::Dispatch,
                                                          robot.whyNot(robot::Capability::Dispatch));
      fail(exitCodeOf(map::FailureKind::Unsupported),
           SnapshotRegionText::tr("%1: it does not offer its map by region. %2").arg(options_.robot, why));
    }
    return;
  }
  const auto resolution = fetch_->map().regions().plan().resolution();
  if (resolution || options_.scale_m_per_px > 0) {
    const auto size =
        pixelsOf(*options_.region, options_.scale_m_per_px > 0 ? options_.scale_m_per_px : *resolution);
    if (!size) return fail(kUsage, tooManyPixels());
    // Drawing takes a while, too: what has arrived by then is drawn within the remaining time.
    const double draw_s = double(size->width()) * double(size->height()) / kPixelsDrawnInASecond;
    const double until_s = options_.timeout_s - std::min(draw_s, options_.timeout_s * kMostOfTimeToDraw);
    if (!fetch_->over() && fetch_->counts().answered > 0 && seconds() > until_s) {
      notes_ << SnapshotRegionText::tr("Not everything had arrived within %1 s (--timeout).")
                    .arg(options_.timeout_s);
      return paint(false);
    }
  }
  if (fetch_->over() && topicsIn() && cloudIn()) paint(true);
}

QString SnapshotRun::tooManyPixels() const {
  return SnapshotRegionText::tr("--region is too large for one picture: choose a coarser --scale.");
}

bool SnapshotRun::sizeRegion() {
  const QString trouble = fetch_ ? sentences::sentenceOf(fetch_->trouble()) : QString();
  const regions::RegionCounts counts = fetch_ ? fetch_->counts() : regions::RegionCounts{};
  if (fetch_ && fetch_->tooLarge()) {
    fail(kUsage, SnapshotRegionText::tr(
                     "--region is too large: it has more cells than can be fetched for one picture."));
    return false;
  }
  const bool some_came = fetch_ && fetch_->map().regions().holdsAnyOf(*options_.region);
  if (counts.answered == 0 && !some_came) {
    const map::FailureKind kind =
        fetch_ && fetch_->over() && fetch_->trouble().kind == regions::RegionTrouble::Kind::Failed
            ? fetch_->trouble().failure.kind
            : map::FailureKind::TimedOut;
    fail(exitCodeOf(kind), SnapshotRegionText::tr("%1: no part of the region could be fetched. %2")
                                   .arg(options_.robot, trouble) +
                               whatOfTheLink());
    return false;
  }
  const auto resolution = fetch_->map().regions().plan().resolution();
  if (options_.scale_m_per_px <= 0) {
    if (!resolution) {
      fail(kIncomplete, SnapshotRegionText::tr("%1: the map is empty in this region, so the size of its "
                                               "cells is unknown. Pass --scale to set the size of a pixel.")
                            .arg(options_.robot));
      return false;
    }
    options_.scale_m_per_px = *resolution;
  }
  const auto size = pixelsOf(*options_.region, options_.scale_m_per_px);
  if (!size) {
    fail(kUsage, tooManyPixels());
    return false;
  }
  options_.size_px = *size;
  if (const std::int64_t odd = fetch_->map().regions().oddCells(); odd > 0) {
    notes_ << SnapshotRegionText::tr(
                  "%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as "
                  "100, values below -1 as unknown.",
                  nullptr, sentences::formOf(qint64(odd)))
                  .arg(odd);
  }
  if (counts.smaller > 0 && counts.answered == counts.in_view) {
    notes_ << SnapshotRegionText::tr(
                  "Some of its answers are smaller than requested (%1 of %2): the missing parts are blank.")
                  .arg(QString::number(counts.smaller), QString::number(counts.in_view));
  } else if (!fetch_->complete()) {
    notes_ << SnapshotRegionText::tr("Parts of the region are missing (%1 of %2 arrived). %3")
                  .arg(QString::number(counts.answered), QString::number(counts.in_view), trouble);
  }
  return true;
}

void SnapshotRun::takeRegion(SnapshotContent& content) {
  fetch_->map().standStill();
  content.regions = &fetch_->map();
  content.whole = false;
  if (!options_.raw) return;
  const regions::FetchedGrid fetched =
      regions::cutOut(fetch_->map().regions().sheets(), *options_.region, regions::CutEdge::Touched);
  content.whole = true;
  if (fetched.cells) content.grid = render::PlacedGrid{fetched.cells, fetched.reference};
  if (fetched.other_lattices > 0) {
    complete_ = false;
    notes_ << SnapshotRegionText::tr(
        "Some of its answers have cells of another size or orientation and were left out.");
  }
}

std::optional<QJsonObject> SnapshotRun::regionJson() const {
  if (!options_.region) return std::nullopt;
  const geometry::WorldRect& rect = *options_.region;
  QJsonObject json{
      {QStringLiteral("center"), QJsonArray{rect.center().x(), rect.center().y()}},
      {QStringLiteral("lengths"), QJsonArray{rect.width(), rect.height()}},
  };
  if (!fetch_) return json;
  const regions::RegionCounts counts = fetch_->counts();
  json[QStringLiteral("parts")] = counts.in_view;
  json[QStringLiteral("answered")] = counts.answered;
  json[QStringLiteral("empty")] = counts.nothing;
  json[QStringLiteral("failed")] = counts.failed;
  const auto resolution = fetch_->map().regions().plan().resolution();
  json[QStringLiteral("resolution")] = resolution ? QJsonValue(*resolution) : QJsonValue();
  json[QStringLiteral("frame")] = QString::fromStdString(fetch_->map().regions().frame());
  return json;
}

}  // namespace mapwright::app
