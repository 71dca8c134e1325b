#include "app/cloud_wish.h"

#include <QCoreApplication>

#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"

namespace mapwright::app {
namespace {

class CloudWishText {
  Q_DECLARE_TR_FUNCTIONS(CloudWish)
};

/// Higher and deeper than any building.
constexpr double kTallM = 2000;

}  // namespace

void CloudWish::ask(const geometry::WorldRect& seen) {
  if (asked_) return;
  asked_ = true;
  robot::Robot& robot = session_.robot();
  if (!robot.mapDispatch()) {
    answer_->problem =
        sentences::whyAbsent(robot::Capability::Dispatch, robot.whyNot(robot::Capability::Dispatch));
    return;
  }
  map::CloudRegion region;
  region.centre_m = {seen.center().x(), seen.center().y(), 0};
  region.size_m = {seen.width(), seen.height(), kTallM};
  robot.mapDispatch()->cloud(
      robot::CloudKind::Points, region,
      [answer = answer_, region](const robot::Outcome<std::shared_ptr<const map::SpatialCloud>>& outcome) {
        if (outcome && *outcome) {
          answer->came = clouds::CloudPiece{*outcome, false, region};
        } else if (outcome) {
          answer->problem = CloudWishText::tr("The robot sent an empty cloud of the map.");
        } else {
          answer->problem = QString::fromStdString(sentences::sentenceOf(outcome.error()));
        }
      });
}

}  // namespace mapwright::app
