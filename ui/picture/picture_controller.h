// Editing the picture of the map on screen: the tool, the dock, saving, and changes by others.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include <QMessageBox>
#include <QPointer>

#include "edit/picture/picture_copies.h"
#include "edit/picture/picture_editing.h"
#include "edit/picture/picture_session.h"
#include "session/session.h"
#include "ui/kit/status_text.h"
#include "ui/shell/editor_controller.h"

namespace mapwright::ui {

class CopiesDialog;
class PictureDock;
class PictureTool;

class PictureController : public EditorController {
  Q_OBJECT
 public:
  explicit PictureController(WindowContext& context, QObject* parent = nullptr);
  ~PictureController() override;

  void setSession(session::Session* session) override;
  void save() override;
  edit::EditSession* edited() const override { return picture_.get(); }
  bool escape() override;

  edit::PictureEditing* editing() { return &editing_; }
  PictureTool* tool() const { return tool_; }
  PictureDock* dock() const { return dock_; }
  /// Before a robot's map is overwritten; null: nothing is asked.
  QMessageBox* sendingQuestion() const { return sending_question_; }
  CopiesDialog* copiesDialog() const;  // null: none is open
  bool saving() const { return picture_ && picture_->saving(); }
  /// Addresses of robots, and what these are called.
  using Named = std::vector<std::pair<QString, QString>>;
  void setNamed(std::function<Named()> named) { named_ = std::move(named); }

 Q_SIGNALS:
  /// Compare the saved map with the edited one.
  void compareWanted();
  /// The picture was written from here.
  void written();
  /// Open a local map.
  void fileWanted(const QString& path);

 private:
  DraftWords draftWords() const override;
  QString amountText(qsizetype changes) const override;
  LeaveQuestion leaveQuestion() const override;
  void finishInput() override { editing_.endStroke(); }
  void discardAll(std::function<void()> then) override;
  void syncMap() override;
  void closeMap() override;
  void addActions();
  void reportForgotten();
  void openOnceChecked(const session::MapSlot& slot);
  void openMap(const session::MapSlot& slot);
  edit::PictureSession::Picture pictureOf(const session::MapSlot& slot) const;
  void onReplaced(qint64 lost);
  void showCells();
  void refresh();
  QString unavailableReason() const;
  void onSaved(const QString& copy);
  void onEnded(const std::optional<map::Failure>& failure, const QString& copy);
  void onMerged(qint64 cells, bool again);
  static QString decideText();
  void askToSend();
  void send(const QString& copy);
  void reportNotWritten(const QString& sentence, map::Applied applied = map::Applied::No);
  void onDoubtSettled(edit::PictureSession::DoubtEnd end);
  void reportDoubt(Mark mark, const QString& sentence);
  QString copiesHere() const;
  void showCopies();
  QString notPutBackReason(const edit::PictureCopy& copy) const;
  void putBack(const edit::PictureCopy& copy);
  void onCopyRead(const QString& when, const tl::expected<edit::ReadCopy, QString>& read);
  void turnInto(std::shared_ptr<const grids::GridPyramid> cells, const QString& when);
  /// The stored map that corresponds to the live map on screen: it can be edited instead.
  std::optional<map::MapKey> mapInstead() const;
  bool opening() const;
  QString mapName() const;

  edit::PictureEditing editing_;
  PictureTool* tool_;
  PictureDock* dock_;
  QAction* tool_action_ = nullptr;
  std::unique_ptr<edit::PictureSession> picture_;  // null: none is open
  std::optional<map::MapKey> wanted_map_;          // requested by the tool
  bool forgetting_reported_ = false;
  QString doubt_reported_;           // what was found of a doubt
  bool shown_ = false;               // the edited cells are drawn
  bool conflicts_reported_ = false;  // only once, however often others paint there
  quint64 opened_ = 0;               // counts maps: results about earlier ones are ignored
  QString trouble_;                  // of saving
  QPointer<QMessageBox> sending_question_;
  QPointer<CopiesDialog> copies_;
  std::function<Named()> named_;
  std::shared_ptr<std::atomic<bool>> stop_reading_;  // the copy that is to be put back
  std::function<void()> when_reverted_;
  /// Whether all cells of a map can be written is checked before painting starts.
  struct CellCheck {
    std::shared_ptr<const grids::GridPyramid> cells;
    std::shared_ptr<std::atomic<bool>> stop;
    bool done = false;
    std::optional<std::uint8_t> between;  // a cell that cannot be
  };
  CellCheck cell_check_;
  work::Tasks share_;  // last
};

}  // namespace mapwright::ui
