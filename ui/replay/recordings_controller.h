// The bags and recordings of the robot: list, open, download, record and delete.
#pragma once

#include <cstdint>
#include <map>

#include <QMessageBox>
#include <QPointer>

#include "robot/bag_library.h"
#include "ui/kit/controller.h"
#include "ui/replay/recordings_dock.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class RecordDialog;

class RecordingsController : public Controller {
  Q_OBJECT
 public:
  explicit RecordingsController(WindowContext& context, QObject* parent = nullptr);

  RecordingsDock* dock() const { return dock_; }
  QMessageBox* question() const { return question_; }  // null: none is open
  RecordDialog* recordDialog() const;                  // null: not open
  void setSession(session::Session* session) override;
  void refresh();
  /// Requests its times from the robot first: a missing or damaged one shows the error on its row, and the
  /// screen stays as it is.
  void open(const robot::BagKey& key);
  /// To this file; resumes an earlier attempt if the robot supports it.
  void download(const robot::BagKey& key, const QString& path);

 Q_SIGNALS:
  void openWanted(const mapwright::robot::BagKey& key);

 private:
  robot::BagLibrary* library() const;
  void showState();
  void fail(const robot::BagKey& key, const map::Failure& failure, const QString& path = {});
  void askWhereTo(const robot::BagKey& key);
  void onDownload(const robot::BagKey& key, const QString& path,
                  const robot::Outcome<robot::BagDownload>& outcome);
  void askToRecord();
  void record(RecordDialog* dialog);
  void askToDelete(const robot::BagKey& key);
  void remove(const robot::BagKey& key);

  WindowContext& context_;
  RecordingsDock* dock_;
  QString durations_of_;  // the address of the robot whose bag lengths the model knows
  bool loading_ = false, listed_ = false;
  QString error_;
  std::uint64_t asked_ = 0;  // identifies the latest request for the list
  std::map<robot::BagKey, robot::Call> downloads_;
  QPointer<QMessageBox> question_;
};

}  // namespace mapwright::ui
