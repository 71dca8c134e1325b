#include "jobs/fetch_cloud.h"

#include <utility>

#include <QCoreApplication>
#include <QObject>

#include "clouds/crop.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"

namespace mapwright::jobs {
namespace {

class FetchCloudText {
  Q_DECLARE_TR_FUNCTIONS(FetchCloud)
};

using Cloud = std::shared_ptr<const map::SpatialCloud>;

/// A child of the dispatcher, so that it ends with it; deletes itself.
class Cropping : public QObject {
 public:
  Cropping(QObject* dispatch, std::shared_ptr<work::Workers> workers)
      : QObject(dispatch), share_(work::orOwn(std::move(workers))) {}

  void crop(Cloud cloud, const map::CloudRegion& region, std::function<void(FetchedCloud)> done) {
    share_.start(work::Urgency::Wanted,
                 [this, cloud = std::move(cloud), region, done = std::move(done)]() mutable {
                   clouds::CroppedCloud part = clouds::cropped(std::move(cloud), region);
                   QMetaObject::invokeMethod(
                       this,
                       [this, fetched = FetchedCloud{std::move(part.cloud), part.beyond}, done] {
                         deleteLater();
                         done(fetched);
                       },
                       Qt::QueuedConnection);
                 });
  }

 private:
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace

QStringList FetchedCloud::notes() const {
  QStringList notes;
  const auto add = [&notes](const QString& plural, std::uint64_t count) {
    if (count > 0) notes << sentences::counted(plural, qint64(count));
  };
  const auto form = [](std::uint64_t count) { return sentences::formOf(qint64(count)); };
  add(FetchCloudText::tr("%1 points that the robot announced did not arrive: its answer is cut off.", nullptr,
                         form(cloud->missing)),
      cloud->missing);
  for (const Fault& note : cloud->notes) notes << sentences::sentenceOf(note);
  add(FetchCloudText::tr("%1 points lie outside the requested region and were left out.", nullptr,
                         form(beyond)),
      beyond);
  add(FetchCloudText::tr("%1 more points have invalid or absurdly large coordinates and were left out.",
                         nullptr, form(cloud->left_out)),
      cloud->left_out);
  return notes;
}

robot::Call fetchCloud(robot::MapDispatch& dispatch, robot::CloudKind kind,
                       const std::optional<map::CloudRegion>& region, std::shared_ptr<work::Workers> workers,
                       robot::OutcomeTo<FetchedCloud> reply) {
  const auto state = std::make_shared<robot::Call::State>();
  const auto end = [state, reply = std::move(reply)](robot::Outcome<FetchedCloud> outcome) {
    state->over = true;
    reply(std::move(outcome));
  };
  const robot::Call asked = dispatch.cloud(
      kind, region, [&dispatch, region, workers = std::move(workers), end](robot::Outcome<Cloud> came) {
        if (!came) return end(robot::fail(std::move(came.error())));
        if (!*came) *came = std::make_shared<const map::SpatialCloud>();
        if (!region || (*came)->points.empty()) return end(FetchedCloud{std::move(*came)});
        auto* const cropping = new Cropping(&dispatch, workers);
        cropping->crop(std::move(*came), *region, end);
      });
  state->cancel = [asked] { asked.cancel(); };
  // Weak, because the state already holds the request: each would keep the other alive.
  asked.onProgress([heard = std::weak_ptr(state)](const robot::Progress& progress) {
    const auto asking = heard.lock();
    if (!asking) return;
    asking->progress = progress;
    if (asking->on_progress) asking->on_progress(progress);
  });
  return robot::Call(state);
}

}  // namespace mapwright::jobs
