// One snapshot from connecting to the picture. The same session and scene as the window's.
#pragma once

#include <functional>
#include <memory>
#include <set>

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/snapshot_options.h"
#include "session/session.h"

namespace mapwright::app {

class SnapshotRun : public QObject {
  Q_OBJECT
 public:
  SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot);
  ~SnapshotRun() override;

  void start();
  QJsonObject report() const;               // cli.md, "Subcommands"
  QString error() const { return error_; }  // the sentence when nothing could be made
  QStringList warnings() const;
  const SnapshotOptions& options() const { return options_; }

 Q_SIGNALS:
  void progressed(const QString& line);
  void finished(int exit_code);

 private:
  void look();  // whatever may have changed: is it time for the next step?
  void timeOut();
  void paint(bool complete);
  bool isLocal() const;
  bool wantsSubmaps() const;
  bool wantsWhole() const;
  void askForWhole();
  void askForTopics();
  bool topicsIn() const;
  bool everythingIn() const;
  bool mapComplete() const;
  bool writeRaw();
  bool writeScene();
  void fail(int exit_code, const QString& sentence);
  void finish(int exit_code);
  geometry::ViewTransform chooseView() const;
  double seconds() const { return double(clock_.nsecsElapsed()) / 1e9; }

  SnapshotOptions options_;
  session::Session session_;
  std::unique_ptr<scene::MapScene> scene_;
  QElapsedTimer clock_;
  QTimer timeout_, settle_, poll_;
  geometry::ViewTransform view_;
  double connected_s_ = -1, first_paint_s_ = -1, complete_s_ = -1;
  bool painting_ = false, done_ = false, complete_ = false, timed_out_ = false;
  bool whole_asked_ = false, live_map_broken_ = false;
  std::set<QString> topics_awaited_;
  QString error_;
  QStringList notes_;
};

}  // namespace mapwright::app
