#include "robot/axbot/axbot_robot.h"

#include <tuple>
#include <utility>

#include <QPointer>

namespace mapwright::robot::axbot {

AxbotRobot::AxbotRobot(QString address, LinkOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      mailbox_(std::make_shared<TopicMailbox>()),
      link_(new AxbotLink(std::move(options), mailbox_)) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<RobotIdentity>();
  qRegisterMetaType<map::TopicMessage>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  qRegisterMetaType<map::SubmapAnswer>();
  qRegisterMetaType<RawMessage>();
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("axbot link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  connect(link_, &AxbotLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    state_ = state;
    Q_EMIT connectionChanged();
  });
  connect(link_, &AxbotLink::identityChanged, this, [this](const RobotIdentity& identity) {
    if (identity == identity_) return;
    identity_ = identity;
    Q_EMIT identityChanged();
  });
  connect(link_, &AxbotLink::topicReceived, this, &AxbotRobot::takeTopic);
  connect(link_, &AxbotLink::mailArrived, this, &AxbotRobot::takeMail);
  connect(link_, &AxbotLink::rawReceived, this, &Robot::rawReceived);
  connect(link_, &AxbotLink::problemFound, this, &Robot::problemFound);
  connect(link_, &AxbotLink::recovered, this, &Robot::recovered);
  connect(link_, &AxbotLink::answered, this, [this](quint64 ticket, const map::SubmapAnswer& answer) {
    auto entry = replies_.extract(ticket);
    if (!entry.empty()) entry.mapped()(answer);
  });
  thread_.start();
}

AxbotRobot::~AxbotRobot() {
  link_->disconnect(this);
  thread_.quit();
  thread_.wait();
}

void AxbotRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::open); }

void AxbotRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

void AxbotRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::close); }

void AxbotRobot::fetch(const map::SubmapKey& key, Reply reply) {
  const quint64 ticket = next_ticket_++;
  replies_.emplace(ticket, std::move(reply));
  QMetaObject::invokeMethod(link_, [link = link_, ticket, key] { link->fetch(ticket, key); });
}

void AxbotRobot::cancelAll() { QMetaObject::invokeMethod(link_, &AxbotLink::cancelAll); }

void AxbotRobot::cancel(const map::SubmapKey& key) {
  QMetaObject::invokeMethod(link_, [link = link_, key] { link->cancel(key); });
}

void AxbotRobot::discard(const map::SubmapKey& key, std::int32_t answered_version) {
  QMetaObject::invokeMethod(link_,
                            [link = link_, key, answered_version] { link->discard(key, answered_version); });
}

void AxbotRobot::discardThumbnail(const map::MapKey& key) {
  QMetaObject::invokeMethod(link_, [link = link_, key] { link->maps().discardThumbnail(key); });
}

void AxbotRobot::discardPicture(const std::string& fingerprint) {
  QMetaObject::invokeMethod(link_, [link = link_, fingerprint] { link->discardPicture(fingerprint); });
}

void AxbotRobot::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  wire::askAcross(this, link_, lists_, std::move(reply),
                  [](AxbotLink& link, auto answer) { link.maps().list(std::move(answer)); });
}

void AxbotRobot::describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) {
  wire::askAcross(this, link_, descriptions_, std::move(reply),
                  [key](AxbotLink& link, auto answer) { link.maps().describe(key, std::move(answer)); });
}

void AxbotRobot::thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) {
  wire::askAcross(this, link_, thumbnails_, std::move(reply),
                  [key](AxbotLink& link, auto answer) { link.maps().thumbnail(key, std::move(answer)); });
}

void AxbotRobot::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  wire::askAcross(this, link_, whole_maps_, std::move(reply),
                  [key](AxbotLink& link, auto answer) { link.maps().fetch(key, std::move(answer)); });
}

void AxbotRobot::fetchOverview(double resolution_m, AnswerTo<map::WholeMap> reply) {
  wire::askAcross(this, link_, whole_maps_, std::move(reply), [resolution_m](AxbotLink& link, auto answer) {
    link.maps().fetchOverview(resolution_m, std::move(answer));
  });
}

void AxbotRobot::setWanted(const QStringList& topics) {
  QMetaObject::invokeMethod(link_, [link = link_, topics] { link->setWantedTopics(topics); });
}

void AxbotRobot::setBasics(const Basics& basics) {
  QMetaObject::invokeMethod(link_, [link = link_, basics] { link->setBasics(basics); });
}

void AxbotRobot::setWatching(bool on) {
  QMetaObject::invokeMethod(link_, [link = link_, on] { link->setWatching(on); });
}

void AxbotRobot::takeTopic(const map::TopicMessage& message) {
  bool other_map = false;
  if (const auto* info = std::get_if<map::MapInfo>(&message)) {
    const map::MapInfo known{info->name, info->uid, info->map_version, info->overlays_version, {}};
    other_map =
        last_map_info_ && std::tie(last_map_info_->name, last_map_info_->uid, last_map_info_->map_version,
                                   last_map_info_->overlays_version) !=
                              std::tie(known.name, known.uid, known.map_version, known.overlays_version);
    last_map_info_ = known;
  }
  const QPointer<AxbotRobot> alive(this);
  Q_EMIT topicReceived(message);
  if (alive && other_map) Q_EMIT mapsChanged();
}

void AxbotRobot::takeMail() {
  const QPointer<AxbotRobot> alive(this);
  for (const map::TopicMessage& message : mailbox_->take()) {
    if (alive) Q_EMIT topicReceived(message);
  }
}

}  // namespace mapwright::robot::axbot
