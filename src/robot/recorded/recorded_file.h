// One recording, read on a thread of its own: files may be large and disks slow.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include <QObject>
#include <QString>
#include <QStringList>

#include "map/stream.h"
#include "recording/source.h"
#include "robot/bag_library.h"
#include "robot/offers_topics.h"
#include "robot/recorded/kept_things.h"
#include "robot/recorded/range_job.h"
#include "robot/robot.h"
#include "robot/wire/task.h"

namespace mapwright::robot::recorded {

struct RecordedOptions {
  QString path;    // absolute
  std::string ns;  // "/robot1": the robot that is shown; empty = none was given
  recording::Limits limits{std::uint64_t(256) << 20, std::uint64_t(64) << 20, std::size_t(64) << 20};
};

/// What is known of an open recording.
struct RecordingFacts {
  RobotIdentity identity;                      // as recorded, otherwise that of the file
  std::map<map::Stream, QStringList> streams;  // which topics bring them
  QStringList topics;                          // those that are understood
  std::vector<OfferedTopic> offered;           // all of them
  std::map<map::Stream, QStringList> choices;  // which could bring them
};

/// Opened by the first request. Everything ends early when its thread is asked to stop.
class RecordedFile : public QObject {
  Q_OBJECT
 public:
  explicit RecordedFile(RecordedOptions options);
  ~RecordedFile() override;

  void open();  // says opened() or refused()
  /// Uses these topics from now on.
  void choose(const ros::Choices& choices);

  Outcome<std::vector<BagEntry>> bags();
  Outcome<BagInfo> info(const BagKey& key);
  void messages(const wire::TaskPtr& task, const BagKey& key, const BagRange& range,
                OutcomeTo<BagChunkPtr> reply);
  Outcome<std::shared_ptr<const std::string>> picture(const std::string& topic, const std::string& name);
  map::SubmapAnswer submap(const map::SubmapKey& key);
  Outcome<map::WaypointList> waypoints(const map::MapKey& key);
  // The maps that lie in it.
  Outcome<std::vector<map::CatalogueEntry>> list();
  Outcome<map::CatalogueEntry> describe(const map::MapKey& key);
  Outcome<map::WholeMap> fetch(const map::MapKey& key);

 Q_SIGNALS:
  void opened(const mapwright::robot::recorded::RecordingFacts& facts);
  void refused(const mapwright::Fault& why);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);

 private:
  struct Job;
  /// Data derived from the file; dropped and rebuilt together.
  struct Parts {
    Parts(std::unique_ptr<recording::Source> source, const ros::Choices& choices, const std::string& ns);
    std::unique_ptr<recording::Source> file;
    MessageFields fields;
    RosShape shape;
    Lasting lasting;
    GridFolds folds;
    KeptThings kept;
    std::vector<std::string> robots;  // robotNames()
  };
  BagKey ownKey() const;
  bool ready();
  std::optional<map::Failure> unavailableReason(const map::Subject& subject);
  bool refresh();
  void reportNotes();
  /// Why the file has nothing of the robot that was asked for; nullopt: it has.
  std::optional<Fault> noRobotReason() const;
  /// Reports that its end is missing, as long as that is so.
  void reportInterruption();
  /// Messages without a valid time that no chunk has counted yet: they are in no range.
  std::size_t newlyUntimed();
  void reportOnce(const map::Problem& problem);
  RecordingFacts facts() const;
  /// The number of messages of each topic, and how they are stored.
  void notifyContent(BagInfo& info, const recording::Summary& summary);
  using Form = std::tuple<std::string, std::string, std::string>;  // topic, type, encoding
  std::map<Form, double> rates(const std::map<std::uint32_t, std::uint64_t>& counts);
  void proceed(const std::shared_ptr<Job>& job);

  RecordedOptions options_;
  ros::Choices choices_;
  std::unique_ptr<Parts> parts_;
  std::optional<Fault> trouble_;
  std::optional<BagInfo> told_info_;  // of the file's last state
  bool info_is_old_ = false;          // the file has grown since
  std::optional<std::int64_t> counted_until_ns_;
  std::map<std::uint32_t, std::uint64_t> counted_of_;  // by channel, if the file does not say
  std::map<std::uint32_t, std::int64_t> first_of_;     // by channel: when its first message arrived
  std::set<std::string> told_;
  std::size_t told_untimed_ = 0;
  bool told_interrupted_ = false;
};

}  // namespace mapwright::robot::recorded
