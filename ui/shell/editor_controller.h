// What every editor in the window does: it follows the map on screen, keeps unsaved changes as a draft, asks
// before they are left behind, reports a map that the robot left while it had some, and continues with what
// was wanted once they are saved. GUI thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QMessageBox>
#include <QPointer>

#include "edit/edit_session.h"
#include "map/catalogue.h"
#include "ui/kit/controller.h"
#include "ui/shell/unsaved_question.h"
#include "ui/shell/window_context.h"
#include "ui/view/toast_stack.h"

class QDockWidget;

namespace mapwright::ui {

class EditorController : public Controller {
  Q_OBJECT
 public:
  EditorController(WindowContext& context, QObject* parent);

  /// Closes the map that was edited. Derived classes call syncMap() when they are ready for the new one.
  void setSession(session::Session* session) override;
  void beforeLeaving(std::function<void()> then) override;
  QMessageBox* question() const { return question_; }  // null: nothing is asked
  /// What is open for editing; null: nothing.
  virtual edit::EditSession* edited() const = 0;
  bool unsaved() const override;
  /// The draft that is offered, as a sentence; empty: none.
  QString offerText() const;

 protected:
  struct LeaveQuestion {
    QString title, sentence;
  };
  virtual LeaveQuestion leaveQuestion() const = 0;
  struct DraftWords {
    QString offer;       // %1: when it was made, %2: how much was changed
    QString not_backed;  // %1: why it is not on disk
    QString lost;        // %1: likewise
  };
  virtual DraftWords draftWords() const = 0;
  /// "3 changes".
  virtual QString amountText(qsizetype changes) const = 0;
  /// What is being typed or drawn becomes part of the changes.
  virtual void finishInput() {}
  /// Discards all changes, and calls `then` once that is done. Nothing is being saved.
  virtual void discardAll(std::function<void()> then) = 0;
  /// The map on screen, the robot's maps, or what can be done with them have changed.
  virtual void syncMap() = 0;
  virtual void closeMap() = 0;

  /// Text still being typed there counts.
  void finishTypingIn(const QWidget* panel);
  /// The document has changed: a draft that was written before no longer holds all of it.
  void onEdited() { may_leave_ = false; }
  /// All is saved: continues with what waited for that. Later, because leaving ends what calls this.
  void onAllSaved();
  /// Not all is saved: the user stays.
  void stay() { when_saved_ = nullptr; }
  bool leavingAllowed() const { return may_leave_; }

  /// The result of saving; it replaces an earlier one.
  void reportSaving(Mark mark, const QString& sentence, ToastOffer offer = {});
  /// Whether it is being saved, and if so, says that nothing can be discarded: the robot may have it by now.
  bool reportIfSaving();
  /// Nothing is saved before the user has decided about conflicts, which are shown in `panel`.
  void askToDecide(QDockWidget* panel, const QString& sentence);
  /// `sentence`: what has to be decided now; empty: nothing. Withdraws a request that was answered.
  void updateDecision(const QString& sentence);
  /// Emits unsavedChanged() if unsaved() or maySave() has changed.
  void updateUnsaved();

  /// Shows what it says of its drafts; with a `panel` also a message with a way there when one is offered.
  void followDrafts(edit::EditSession& session, QDockWidget* panel = nullptr);
  /// Before it is closed: unsaved changes stay as a draft; if that is impossible the user is told.
  void leaveDraft();
  bool keepsDraft() const;
  /// Why the draft is not on disk, as a sentence; empty: nothing is wrong.
  QString draftTroubleText() const;
  void turnDownDraft();

  /// The robot went on to another map while `map` had unsaved changes. `sentence`: what is kept of them.
  /// Shown in the strip above the map, with an offer to open that map again.
  void reportLeftMap(const map::MapKey& map, const QString& sentence);
  /// This one is edited now, or none.
  void onMapOpened(const std::optional<map::MapKey>& map);

  /// As it is called on the robot.
  QString nameOf(const map::MapKey& map) const;

  WindowContext& context_;
  QPointer<session::Session> session_;

 private:
  void answer(Leaving leaving);
  void forgetLeftMap();

  QPointer<QMessageBox> question_;
  std::function<void()> when_left_, when_saved_;
  bool may_leave_ = false;  // the draft is kept as it is
  bool was_unsaved_ = false, could_save_ = false;
  QString announced_;  // the offer that was shown last
  QString asked_;      // the last request to decide, until it is answered
  std::optional<map::MapKey> left_map_;
};

}  // namespace mapwright::ui
