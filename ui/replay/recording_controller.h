// The record button: writes what the robot sends to a file, until it is pressed again or the robot is
// disconnected.
#pragma once

#include <memory>
#include <optional>

#include <QPointer>

#include "recorder/recorder.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

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
  void reportProgress();
  /// The connection state: a recording has a gap while it is lost.
  void onLink();
  /// Adds the whole maps on screen to the recording.
  void wantOpenMaps();
  /// Why the file is incomplete; empty: it is not.
  QStringList lacks(const recorder::Recorder::Progress& done) const;
  /// The file is as complete as possible: reports it and releases its recorder.
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
  int not_had_ = 0;  // additional requests that failed
};

}  // namespace mapwright::ui
