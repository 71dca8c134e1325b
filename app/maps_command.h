// The frame of every `mapwright maps …`: its time, its robots, its one line on standard error, its report.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include <QJsonObject>

#include "app/map_reading.h"

namespace mapwright::app {

class MapsCommand {
 public:
  /// `report_path`: where what was done is written as JSON; empty = nowhere.
  MapsCommand(double timeout_s, QString report_path);

  /// Connects; the reading lives as long as this.
  CommandResult<MapReading*> open(const QString& address, const Access& access, MapReading::Purpose purpose);
  /// What has been done, and under which name, for the report: told again, it replaces; failed commands tell
  /// it, too.
  void report(const QString& name, const QJsonObject& done) {
    done_name_ = name;
    done_ = done;
  }
  /// True when everything that was asked for could be had.
  bool complete() const;

  /// An application without a display, `work`, and what is to be said in the end; the exit code. The process
  /// ends in time, whatever `work` does.
  int run(int& argc, char** argv, const std::function<CommandResult<int>(MapsCommand&)>& work);

 private:
  int end(const CommandResult<int>& result) const;

  CommandTime time_;
  QString report_path_, done_name_;
  QJsonObject done_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();  // of all readings
  std::vector<std::unique_ptr<MapReading>> readings_;
  /// Of the first robot; shared with the deadline.
  std::shared_ptr<std::atomic<bool>> connected_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace mapwright::app
