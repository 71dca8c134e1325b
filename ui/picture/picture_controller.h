// Editing the picture of the map on screen: the tool, the dock, saving, and changes by others.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QMessageBox>
#include <QPointer>

#include "robot/picture_store.h"
#include "ui/kit/status_text.h"
#include "ui/picture/picture_copies.h"
#include "ui/picture/picture_editing.h"
#include "ui/shell/editor_controller.h"

namespace mapwright::window {

class CopiesDialog;
class PictureDock;
class PictureTool;

class PictureController : public EditorController {
  Q_OBJECT
 public:
  explicit PictureController(WindowContext& context, QObject* parent = nullptr);
  ~PictureController() override;

  void setSession(session::Session* session) override;
  bool unsaved() const override { return editing_.unsaved(); }
  void save() override;
  bool escape() override;

  PictureEditing* editing() { return &editing_; }
  PictureTool* tool() const { return tool_; }
  PictureDock* dock() const { return dock_; }
  /// Before a robot's map is overwritten; null: nothing is asked.
  QMessageBox* sendingQuestion() const { return sending_question_; }
  CopiesDialog* copiesDialog() const;  // null: none is open
  bool saving() const { return saving_; }
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
  LeaveQuestion leaveQuestion() const override;
  void finishInput() override { editing_.endStroke(); }
  void discardAll(std::function<void()> then) override;
  void syncMap() override;
  void closeMap() override;
  void addActions();
  void reportForgotten();
  void openOnceChecked(const session::MapSlot& slot);
  void openMap(const session::MapSlot& slot);
  void onOtherPicture(const session::MapSlot& slot);
  void showCells();
  void refresh();
  QString unavailableReason() const;
  void onWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                 const robot::Outcome<robot::PictureReceipt>& outcome);
  void onMerged(qint64 taken, const std::string& revision);
  static QString decideText();
  void askToSend();
  void send();
  void write();
  void onCopied(const std::optional<Fault>& trouble);
  void reportNotWritten(const QString& sentence, map::Applied applied = map::Applied::No);
  void settleDoubt();
  void reportDoubt(Mark mark, const QString& sentence);
  QString copiesHere() const;
  void showCopies();
  QString notPutBackReason(const PictureCopy& copy) const;
  void putBack(const PictureCopy& copy);
  void onCopyRead(const QString& when, const tl::expected<ReadCopy, QString>& read);
  void turnInto(std::shared_ptr<const grids::GridPyramid> cells, const QString& when);
  void watchDrafts();
  void restoreDraft();
  /// The stored map that corresponds to the live map on screen: it can be edited instead.
  std::optional<map::MapKey> mapInstead() const;
  bool opening() const;
  QString mapName() const;

  PictureEditing editing_;
  PictureTool* tool_;
  PictureDock* dock_;
  QAction* tool_action_ = nullptr;
  std::optional<map::MapKey> open_map_;
  std::optional<map::MapKey> wanted_map_;  // requested by the tool
  robot::Call write_call_;
  bool forgetting_reported_ = false;
  /// A picture was sent, and it is not known whether the robot stored it.
  struct Doubt {
    std::shared_ptr<const picture::EditedGrid> sent, before;
    QString reported = {};  // what was found
  };
  std::optional<Doubt> doubt_;
  std::shared_ptr<const picture::EditedGrid> before_;  // on the robot when it was sent last
  std::shared_ptr<const grids::GridPyramid> seen_;     // of the last map received
  std::string revision_;                               // of what is saved
  std::set<std::string> past_revisions_;               // replaced by saving here; may still be on their way
  bool shown_ = false;                                 // the edited cells are drawn
  bool saving_ = false, again_ = false;                // again: saves once more after merging theirs
  bool conflicts_reported_ = false;                    // only once, however often others paint there
  quint64 opened_ = 0;                                 // counts maps: results about earlier ones are ignored
  QString trouble_;                                    // of saving
  QString copy_;                                       // of the robot's picture; empty: none
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

}  // namespace mapwright::window
