#include "robot/aimdk/aimdk_robot.h"

#include <algorithm>
#include <utility>

namespace mapwright::robot::aimdk {

AimdkRobot::AimdkRobot(QString address, LinkOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      has_tf_(!options.tf.isEmpty()),
      link_(new AimdkLink(std::move(options))) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  identity_.model = QStringLiteral("Agibot (AimDK)");
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("aimdk link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  connect(link_, &AimdkLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    state_ = state;
    Q_EMIT connectionChanged();
  });
  connect(link_, &AimdkLink::problemFound, this, &Robot::problemFound);
  connect(link_, &AimdkLink::recovered, this, &Robot::recovered);
  connect(link_, &AimdkLink::currentMapChanged, this, &Robot::mapsChanged);
  thread_.start();
}

AimdkRobot::~AimdkRobot() {
  link_->disconnect(this);
  thread_.quit();
  thread_.wait();
}

void AimdkRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &AimdkLink::open); }

void AimdkRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

void AimdkRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &AimdkLink::close); }

QString AimdkRobot::limits() const {
  const QString pose = has_tf_ ? tr("Its live pose over rosbridge (/tf): not yet in this version.")
                               : tr("Its live pose: not yet in this version.");
  return tr("Read only: Agibot's interface offers no editing.") + QLatin1Char(' ') + pose;
}

void AimdkRobot::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  wire::askAcross(this, link_, lists_, std::move(reply),
                  [](AimdkLink& link, auto answer) { link.list(std::move(answer)); });
}

void AimdkRobot::describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) {
  // There is no question for one map alone that does not send its picture.
  list([key, reply = std::move(reply)](const Answer<std::vector<map::CatalogueEntry>>& entries) {
    if (!entries) {
      reply(tl::make_unexpected(entries.error()));
      return;
    }
    const auto found = std::find_if(entries->begin(), entries->end(),
                                    [&](const map::CatalogueEntry& entry) { return entry.key == key; });
    if (found != entries->end()) {
      reply(*found);
    } else {
      reply(tl::make_unexpected(
          map::Problem{map::Severity::Error, map::subjectOf(key), "The robot has no such map."}));
    }
  });
}

void AimdkRobot::thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) {
  QMetaObject::invokeMethod(
      this,
      [key, reply = std::move(reply)] {
        reply(tl::make_unexpected(map::Problem{map::Severity::Info, map::subjectOf(key),
                                               "The robot offers no small pictures of its maps."}));
      },
      Qt::QueuedConnection);
}

void AimdkRobot::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  wire::askAcross(this, link_, whole_maps_, std::move(reply),
                  [key](AimdkLink& link, auto answer) { link.fetch(key, std::move(answer)); });
}

void AimdkRobot::waypoints(const map::MapKey& key, AnswerTo<map::WaypointList> reply) {
  wire::askAcross(this, link_, waypoint_lists_, std::move(reply),
                  [key](AimdkLink& link, auto answer) { link.waypoints(key, std::move(answer)); });
}

}  // namespace mapwright::robot::aimdk
