// An Autoxing robot behind the port. Source: axbot.md.
#pragma once

#include <unordered_map>

#include <QThread>

#include "robot/axbot/axbot_link.h"
#include "robot/robot.h"
#include "robot/wire/pending_answers.h"

namespace mapwright::robot::axbot {

class AxbotRobot : public Robot,
                   private SubmapSource,
                   private MapCatalogue,
                   private WholeMapSource,
                   private LiveTopics {
  Q_OBJECT
 public:
  AxbotRobot(QString address, LinkOptions options, QObject* parent = nullptr);
  ~AxbotRobot() override;

  QString address() const override { return address_; }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override;
  ConnectionState connection() const override { return state_; }
  RobotIdentity identity() const override { return identity_; }
  SubmapSource* submapSource() override { return this; }
  MapCatalogue* mapCatalogue() override { return this; }
  WholeMapSource* wholeMapSource() override { return this; }
  LiveTopics* liveTopics() override { return this; }

 private:
  void fetch(const map::SubmapKey& key, Reply reply) override;
  void cancelAll() override;
  void cancel(const map::SubmapKey& key) override;
  void discard(const map::SubmapKey& key, std::int32_t answered_version) override;

  void list(AnswerTo<std::vector<map::CatalogueEntry>> reply) override;
  void describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) override;
  void thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) override;
  void discardThumbnail(const map::MapKey& key) override;

  void fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) override;
  bool offersOverview() const override { return true; }
  void fetchOverview(double resolution_m, AnswerTo<map::WholeMap> reply) override;
  void discardPicture(const std::string& fingerprint) override;

  QStringList known() const override { return knownTopics(); }
  void setWanted(const QStringList& topics) override;
  void setBasics(const Basics& basics) override;
  void setWatching(bool on) override;

  void takeTopic(const map::TopicMessage& message);
  void takeMail();

  QString address_;
  std::shared_ptr<TopicMailbox> mailbox_;
  QThread thread_;
  AxbotLink* link_;  // lives on thread_, deleted when it ends
  ConnectionState state_;
  RobotIdentity identity_;
  quint64 next_ticket_ = 1;
  std::unordered_map<quint64, Reply> replies_;
  wire::PendingAnswers<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingAnswers<map::CatalogueEntry> descriptions_;
  wire::PendingAnswers<std::string> thumbnails_;
  wire::PendingAnswers<map::WholeMap> whole_maps_;
  std::optional<map::MapInfo> last_map_info_;  // without overlays
};

}  // namespace mapwright::robot::axbot
