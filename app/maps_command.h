// Common to every `mapwright maps …`: its time limit, its robots, its one line on standard error, its report.
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
  /// `report_path`: where to write the JSON report; empty = nowhere.
  MapsCommand(double timeout_s, QString report_path);

  /// Connects; the result lives as long as this object.
  CommandResult<MapReading*> open(const QString& address, const Access& access, MapReading::Purpose purpose);
  /// Sets an entry of the report, replacing an earlier one of that name; also used by commands that fail.
  void report(const QString& name, const QJsonObject& done) {
    done_name_ = name;
    done_ = done;
  }
  /// True if everything that was requested could be loaded.
  bool complete() const;

  /// Sets up an application without a display, runs `work`, prints the final messages and returns the exit
  /// code. The process ends in time whatever `work` does.
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
