// The picture of the map on screen, edited in the window: the tool, the dock, saving, what others change
// meanwhile, and what is asked before the map is left.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QPointer>

#include "robot/picture_store.h"
#include "window/controller.h"
#include "window/picture/picture_editing.h"
#include "window/window_context.h"

class QMessageBox;

namespace mapwright::window {

class PictureDock;
class PictureDrafts;
class PictureTool;

class PictureController : public Controller {
  Q_OBJECT
 public:
  explicit PictureController(WindowContext& context, QObject* parent = nullptr);
  ~PictureController() override;

  void setSession(session::Session* session) override;
  bool unsaved() const override { return editing_.unsaved(); }
  void save() override;
  void beforeLeaving(std::function<void()> then) override;

  PictureEditing* editing() { return &editing_; }
  PictureTool* tool() const { return tool_; }
  PictureDock* dock() const { return dock_; }
  PictureDrafts* drafts() const { return drafts_.get(); }  // null: none are kept
  QMessageBox* question() const;                           // null: nothing is asked
  QMessageBox* sendingQuestion() const;                    // the same, before a robot's map is overwritten
  bool saving() const { return saving_; }

 Q_SIGNALS:
  /// What is saved beside what it is now.
  void compareWanted();
  /// The picture has been written from here.
  void written();
  /// A local map is to be opened.
  void fileWanted(const QString& path);

 private:
  void addActions();
  void syncMap();
  void noteForgotten();
  void openOnceLookedAt(const session::MapSlot& slot);
  void openMap(const session::MapSlot& slot);
  void closeMap();
  void takeOther(const session::MapSlot& slot);
  void showCells();
  void refresh();
  QString whyNot() const;
  void noteWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                   const robot::Outcome<robot::PictureReceipt>& outcome);
  void noteMerged(qint64 taken, const std::string& revision);
  void askToDecide();
  void askToSend();
  void send();
  void write();
  void noteCopied(const std::optional<Fault>& trouble);
  void noteNotWritten(const QString& sentence);
  QString copiesHere() const;
  void watchDrafts();
  void keepDraft();
  void answer(int button);
  /// The map that is kept, of which what is sent now is on screen: it would be edited instead.
  std::optional<map::MapKey> mapInstead() const;
  bool opening() const;
  QString mapName() const;

  WindowContext& context_;
  QPointer<session::Session> session_;
  PictureEditing editing_;
  PictureTool* tool_;
  PictureDock* dock_;
  QAction* tool_action_ = nullptr;
  std::optional<map::MapKey> open_map_;
  std::optional<map::MapKey> wanted_map_;  // that the tool has asked for
  robot::Call write_call_;
  bool forgetting_told_ = false;
  std::shared_ptr<const grids::GridPyramid> seen_;  // what came with the map last
  std::string revision_;                            // of what is saved
  std::set<std::string> own_revisions_;             // that were saved from here since somebody else did
  bool shown_ = false;                              // the edited cells are what is drawn
  bool saving_ = false, again_ = false;             // again: saved once more when theirs has been taken in
  bool was_unsaved_ = false;
  bool conflicts_told_ = false;  // once, however often others paint there
  std::unique_ptr<PictureDrafts> drafts_;
  bool may_leave_ = false;  // the draft is to be kept as it is
  quint64 opened_ = 0;      // counts maps: answers about earlier ones are of no use
  QString trouble_;         // of saving
  QString copy_;            // of what the robot has; empty: none is kept
  QPointer<QMessageBox> question_, sending_question_;
  std::function<void()> when_left_, when_saved_, when_reverted_;
  /// Whether the cells of a map can all be written again is known before anything is painted.
  struct Looked {
    std::shared_ptr<const grids::GridPyramid> cells;
    std::shared_ptr<std::atomic<bool>> stop;
    bool done = false;
    std::optional<std::uint8_t> between;  // a cell that cannot be
  };
  Looked looked_;
  work::Share share_;  // last
};

}  // namespace mapwright::window
