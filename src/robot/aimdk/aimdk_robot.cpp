#include "robot/aimdk/aimdk_robot.h"

#include <algorithm>
#include <utility>

namespace mapwright::robot::aimdk {

AimdkRobot::AimdkRobot(QString address, LinkOptions options, std::unique_ptr<LiveBeside> live,
                       QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      live_(std::move(live)),
      deliveries_(std::make_shared<wire::DeliveryPlace>()),
      link_(new AimdkLink(std::move(options), deliveries_)),
      catalogue_({this, link_}),
      whole_maps_({this, link_}),
      points_({this, link_}) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  identity_.model = QStringLiteral("Agibot (AimDK)");
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("aimdk link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  connect(link_, &AimdkLink::silenceChanged, this, [this](const QDateTime& since) {
    if (std::exchange(silent_since_, since) != since) Q_EMIT connectionChanged();
  });
  connect(link_, &AimdkLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    state_ = state;
    Q_EMIT connectionChanged();
  });
  connect(link_, &AimdkLink::problemFound, this, &Robot::problemFound);
  connect(link_, &AimdkLink::recovered, this, &Robot::recovered);
  connect(link_, &AimdkLink::currentMapChanged, this, &Robot::mapsChanged);
  if (live_) {
    connect(live_.get(), &LiveBeside::topicReceived, this, &Robot::topicReceived);
    connect(live_.get(), &LiveBeside::rawReceived, this, &Robot::rawReceived);
    connect(live_.get(), &LiveBeside::problemFound, this, &Robot::problemFound);
    connect(live_.get(), &LiveBeside::recovered, this, &Robot::recovered);
    connect(live_.get(), &LiveBeside::topicsChanged, this, &Robot::capabilitiesChanged);
    connect(live_.get(), &LiveBeside::certificateChanged, this, &Robot::connectionChanged);
    connect(live_.get(), &LiveBeside::silenceChanged, this, &Robot::connectionChanged);
  }
  thread_.start();
}

AimdkRobot::~AimdkRobot() {
  live_.reset();
  link_->disconnect(this);
  thread_.quit();
  thread_.wait();
}

QDateTime AimdkRobot::silentSince() const {
  // The pose only comes from the other server.
  const bool by_other = live_ && state_.phase == ConnectionPhase::Online && !silent_since_.isValid();
  return by_other ? live_->silentSince() : silent_since_;
}

void AimdkRobot::connectToRobot() {
  QMetaObject::invokeMethod(link_, &AimdkLink::open);
  if (live_) live_->connectToRobot();
}

void AimdkRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

std::optional<UntrustedCertificate> AimdkRobot::certificateBeside() const {
  return live_ ? live_->connection().certificate : std::nullopt;
}

void AimdkRobot::trustBeside(const QString& sha256) {
  if (live_) live_->trustCertificate(sha256);
}

void AimdkRobot::disconnectFromRobot() {
  QMetaObject::invokeMethod(link_, &AimdkLink::close);
  if (live_) live_->disconnectFromRobot();
}

void AimdkRobot::setDeliveryTap(DeliveryTap tap) {
  deliveries_->set(tap);
  if (live_) live_->setDeliveryTap(std::move(tap));
}

Absence AimdkRobot::whyNot(Capability capability) const {
  if (capability == Capability::Administration || capability == Capability::WaypointEditing ||
      capability == Capability::PictureEditing)
    return {Absence::Reason::ReadOnly, {"Agibot"}};
  if (capability == Capability::Live) return {Absence::Reason::NoService, {"?tf=ws://HOST:9090"}};
  return {};
}

Call Catalogue::list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  return wire::askAcross(
      line_.asker, line_.link, lists_, map::Subject(map::SubjectKind::Catalogue, map::kMapsPart),
      std::move(reply),
      [](AimdkLink& link, auto errand, auto answer) { link.list(errand, std::move(answer)); });
}

Call Catalogue::describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  // There is no request for one map without its picture.
  return list([key, reply = std::move(reply)](const Outcome<std::vector<map::CatalogueEntry>>& entries) {
    if (!entries) {
      map::Failure failure = entries.error();
      failure.subject = map::subjectOf(key);
      reply(tl::make_unexpected(std::move(failure)));
      return;
    }
    const auto found = std::find_if(entries->begin(), entries->end(),
                                    [&](const map::CatalogueEntry& entry) { return entry.key == key; });
    if (found != entries->end()) {
      reply(*found);
    } else {
      reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                             .subject = map::subjectOf(key),
                                             .reason = map::FailureReason::NotThere}));
    }
  });
}

Call Catalogue::thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) {
  return wire::endLater<std::string>(
      line_.asker, thumbnails_, std::move(reply),
      tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                       .subject = map::subjectOf(key),
                                       .asked_for = map::AskedFor::SmallPicture,
                                       .reason = map::FailureReason::NotOffered}));
}

Call WholeMaps::fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  return wire::askAcross(
      line_.asker, line_.link, maps_, map::subjectOf(key), std::move(reply),
      [key](AimdkLink& link, auto errand, auto answer) { link.fetch(errand, key, std::move(answer)); });
}

Call Points::waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  return wire::askAcross(
      line_.asker, line_.link, lists_, map::placesOf(key), std::move(reply),
      [key](AimdkLink& link, auto errand, auto answer) { link.waypoints(errand, key, std::move(answer)); });
}

}  // namespace mapwright::robot::aimdk

#include "moc_aimdk_robot.cpp"
