// The red button: what the robot sends goes into a file, until it is pressed again or the robot is left.
#pragma once

#include <memory>
#include <optional>

#include <QPointer>

#include "recorder/recorder.h"
#include "window/controller.h"
#include "window/window_context.h"

namespace mapwright::window {

class PlainLabel;

class RecordingController : public Controller {
  Q_OBJECT
 public:
  explicit RecordingController(WindowContext& context, QObject* parent = nullptr);
  ~RecordingController() override;

  void setSession(session::Session* session) override;

  /// The error is a sentence.
  std::optional<QString> startInto(const QString& path);
  void stop();
  bool recording() const { return recorder_ && !recorder_->stopped(); }
  /// "0:12, 3.4 MB"; empty while nothing is recorded.
  QString shown() const;

 Q_SIGNALS:
  /// A file that was recorded.
  void playWanted(const QString& path);

 private:
  void toggle();
  void askAndStart();
  void refresh();
  void tellProgress();
  /// How the link stands: a recording has a gap where it was away.
  void takeLink();
  /// Whole maps that are on screen belong to the recording.
  void wantOpenMaps();
  /// Why the file is not all that was sent; empty: it is.
  QStringList lacks(const recorder::Recorder::Progress& done) const;
  /// The file is complete, or as complete as it can be: says so, and gives away its recorder.
  recorder::Recorder* conclude();

  WindowContext& context_;
  QAction* action_;
  PlainLabel* label_;
  QPointer<session::Session> session_;
  std::unique_ptr<recorder::Recorder> recorder_;
  QString path_;
  std::optional<disk::FileError> told_;  // why nothing is being written
  bool away_ = false;                    // the link is lost
  int interruptions_ = 0;
  int not_had_ = 0;  // what was asked for besides
};

}  // namespace mapwright::window
