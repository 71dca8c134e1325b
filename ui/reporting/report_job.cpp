#include "ui/reporting/report_job.h"

#include <utility>

#include <QBuffer>
#include <QCoreApplication>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "sentences/fault_sentence.h"
#include "ui/reporting/gathering.h"

namespace mapwright::ui::reporting {
namespace {

using incident::Run;

constexpr QSize kBesidePx(660, 500);  // where two stand beside each other

std::optional<Eigen::Vector2d> placeOf(const Run& run) {
  const auto& pose = run.live.robot_pose;
  return pose ? std::optional(Eigen::Vector2d(pose->x_m, pose->y_m)) : std::nullopt;
}

}  // namespace

ReportJob::ReportJob(ReportOrder order, std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), order_(std::move(order)), workers_(std::move(workers)) {}

ReportJob::~ReportJob() = default;

void ReportJob::start() { gather(order_.run, {.at_s = order_.run.at_s}); }

void ReportJob::fail(const QString& sentence, map::FailureKind kind) {
  error_ = sentence;
  failure_ = kind;
  Q_EMIT ended();
}

void ReportJob::gather(const ReportOrder::Part& part, Wanted wanted) {
  auto robot = part.robot();
  if (!robot) return fail(robot.error());
  wanted.bag = part.bag;
  wanted.any_kind = part.any_kind;
  if (order_.against) wanted.picture_px = kBesidePx;
  gathering_ = std::make_unique<Gathering>(std::move(*robot), std::move(wanted), workers_);
  connect(gathering_.get(), &Gathering::progressed, this, &ReportJob::progressed);
  // Queued: the one that has ended is deleted.
  connect(gathering_.get(), &Gathering::ended, this, &ReportJob::onRun, Qt::QueuedConnection);
  gathering_->start();
}

void ReportJob::onRun() {
  if (!gathering_->error().isEmpty()) return fail(gathering_->error(), gathering_->failure());
  Run run = std::move(gathering_->run());
  const geometry::ViewTransform view = gathering_->view();
  if (std::exchange(first_done_, true)) {
    const auto here = placeOf(report_.run), there = placeOf(run);
    if (here && there) report_.against_m = (*here - *there).norm();
    report_.nearest = !order_.against->at_s;
    report_.against = std::move(run);
    return write();
  }
  report_.run = std::move(run);
  if (!order_.against) return write();
  Wanted wanted{.at_s = order_.against->at_s, .near_m = placeOf(report_.run)};
  if (!wanted.at_s && !wanted.near_m)
    return fail(QCoreApplication::translate("Incident",
                                            "The position at this time is unknown, so the same place cannot "
                                            "be found in the other run. Give its time instead."));
  // Both pictures show the same place.
  if (wanted.near_m && !report_.run.picture.isEmpty()) wanted.view = view;
  gather(*order_.against, std::move(wanted));
}

void ReportJob::write() {
  gathering_.reset();
  QByteArray html;
  QBuffer buffer(&html);
  buffer.open(QIODevice::WriteOnly);
  incident::writeReport(buffer, report_);
  if (const auto fault = disk::writeFile(order_.path.toStdString(),
                                         {html.constData(), std::size_t(html.size())}, order_.existing))
    return fail(sentences::wordsOf(disk::notWritten(*fault)));
  Q_EMIT ended();
}

}  // namespace mapwright::ui::reporting

#include "moc_report_job.cpp"
