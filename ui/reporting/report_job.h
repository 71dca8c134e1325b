// The report of a moment as a file: gathers one run or two, and writes. For the window and commands alike.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <tl/expected.hpp>

#include "disk/existing.h"
#include "incident/report.h"
#include "map/failure.h"
#include "robot/bag_library.h"
#include "robot/robot.h"
#include "work/workers.h"

namespace mapwright::ui::reporting {

class Gathering;
struct Wanted;

struct ReportOrder {
  struct Part {
    /// Not connected. The error is a sentence.
    std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>()> robot;
    robot::BagKey bag;
    bool any_kind = false;       // only its name is known
    std::optional<double> at_s;  // of `against`, nullopt: when it was nearest to the same place
  };
  Part run;
  std::optional<Part> against;
  QString path;  // "-" is the standard output
  disk::Existing existing = disk::Existing::Replace;
};

class ReportJob : public QObject {
  Q_OBJECT
 public:
  ReportJob(ReportOrder order, std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  ~ReportJob() override;
  /// Ends in ended(). Deleting it cancels.
  void start();

  /// Why there is no report: a sentence; empty: it is written.
  const QString& error() const { return error_; }
  map::FailureKind failure() const { return failure_; }
  const incident::Report& report() const { return report_; }
  const QString& path() const { return order_.path; }

 Q_SIGNALS:
  void progressed(double share);  // 0..1
  void ended();

 private:
  void gather(const ReportOrder::Part& part, Wanted wanted);
  void onRun();
  void write();
  void fail(const QString& sentence, map::FailureKind kind = map::FailureKind::None);

  ReportOrder order_;
  std::shared_ptr<work::Workers> workers_;
  std::unique_ptr<Gathering> gathering_;
  incident::Report report_;
  bool first_done_ = false;
  QString error_;
  map::FailureKind failure_ = map::FailureKind::None;
};

}  // namespace mapwright::ui::reporting
