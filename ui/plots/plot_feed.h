// The samples for plots: from the ranges of a bag as they are read, or from a live robot. GUI-thread object;
// messages of bags are parsed in the background.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>

#include "replay/reading.h"
#include "series/series.h"
#include "session/session.h"
#include "ui/plots/plot_selection.h"
#include "work/workers.h"

namespace mapwright::ui {

class PlotFeed : public QObject {
  Q_OBJECT
 public:
  using SeriesPtr = std::shared_ptr<series::Series>;
  static constexpr double kLive_s = 30 * 60;              // how much to keep of a live robot
  static constexpr std::size_t kMostSamples = 1'000'000;  // of each curve; eight hours at 30 Hz

  /// `wall`: seconds since the epoch; none = the system's.
  explicit PlotFeed(std::shared_ptr<work::Workers> workers, std::function<double()> wall = {},
                    QObject* parent = nullptr);
  ~PlotFeed() override;

  /// An open bag; null = none. Drops all earlier data.
  void setReading(replay::Reading* reading);
  bool replays() const { return reading_ != nullptr; }
  /// The robot; null = none. For one that replays a bag use setReading() instead.
  void setSession(session::Session* session);
  /// There is a live robot.
  bool live() const { return live_ != nullptr && !replays(); }

  /// Its samples, from now on until it is released as often as it was requested. Reads data again if
  /// necessary.
  SeriesPtr want(const PlotSelection& selection);
  void letGo(const PlotSelection& selection);

  /// Paths that can be plotted, for completion; from the messages in memory.
  QStringList fields() const;
  /// The last message of its topic is known, and has numbers, but not this one.
  bool lacks(const series::FieldPath& path) const;
  double now() const { return wall_(); }

 Q_SIGNALS:
  /// Samples have come or gone.
  void changed();
  /// Raw messages of the robot are needed, or no longer.
  void rawWanted(bool wanted);

 private:
  struct Entry {
    SeriesPtr series;
    int users = 0;
  };
  struct Read {
    PlotSelection selection;
    std::vector<series::Sample> samples;
  };
  using Selections = std::vector<PlotSelection>;

  void clear();
  void updateSoon();
  /// The last message of each topic in memory.
  void eachLast(const std::function<void(const std::string& topic, std::string_view json)>& see) const;
  // Of a bag.
  void catchUp();
  void addPoses(const replay::Digest& digest, const Selections& selections);
  void addMessages(const replay::ChunkPtr& chunk);
  void putIn(double from_s, double until_s, std::vector<Read> all);
  Selections lacking(double from_s, double until_s, bool poses) const;
  // Of a robot.
  void listen();
  void subscribe();
  void heard(const map::StampedMessage& message);
  void heardRaw(const robot::RawMessage& message);
  void add(const PlotSelection& selection, double at_s, double value);
  void coverLive();

  std::function<double()> wall_;
  std::map<PlotSelection, Entry> entries_;
  series::Series x_, y_;  // to compute speeds
  QPointer<replay::Reading> reading_;
  QPointer<session::Session> session_;
  robot::Robot* live_ = nullptr;
  std::optional<double> live_since_s_;
  bool raw_wanted_ = false;
  std::map<std::string, QByteArray> last_raw_;  // a message of each topic, small ones
  std::shared_ptr<int> reading_number_ = std::make_shared<int>(0);
  QTimer catch_up_, note_, tick_;
  work::Tasks share_;
};

}  // namespace mapwright::ui
