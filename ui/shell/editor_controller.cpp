#include "ui/shell/editor_controller.h"

#include <utility>

#include <QDateTime>

#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/panels.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/view/map_overlay.h"

namespace mapwright::ui {

EditorController::EditorController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {}

void EditorController::setSession(session::Session* session) {
  if (session_) {
    session_->wholeMap().disconnect(this);
    session_->catalogue().disconnect(this);
    session_->robot().disconnect(this);
    session_->disconnect(this);
  }
  closeMap();
  forgetLeftMap();
  session_ = session;
  if (!session_) return;
  connect(&session_->wholeMap(), &session::MapSlot::changed, this, &EditorController::syncMap);
  connect(&session_->catalogue(), &session::Catalogue::changed, this, &EditorController::syncMap);
  connect(&session_->robot(), &robot::Robot::capabilitiesChanged, this, &EditorController::syncMap);
}

void EditorController::finishTypingIn(const QWidget* panel) {
  if (QWidget* const typing = context_.window.focusWidget(); typing && panel->isAncestorOf(typing))
    typing->clearFocus();
}

void EditorController::beforeLeaving(std::function<void()> then) {
  finishInput();
  if (!unsaved() || may_leave_) return then();
  when_left_ = std::move(then);
  if (question_) return question_->raise();
  const LeaveQuestion ask = leaveQuestion();
  question_ =
      askToLeave(this, &context_.window, ask.title, ask.sentence, keepsDraft(), [this](Leaving leaving) {
        question_ = nullptr;
        answer(leaving);
      });
}

void EditorController::answer(Leaving leaving) {
  const auto then = std::exchange(when_left_, nullptr);
  if (!then || leaving == Leaving::Stay) return;
  if (!unsaved()) return then();  // they went meanwhile
  if (leaving == Leaving::Save) {
    when_saved_ = then;
    save();
  } else if (leaving == Leaving::Discard) {
    if (!reportIfSaving()) discardAll(then);
  } else if (!keepsDraft()) {
    return;
  } else if (const auto trouble = edited()->drafts()->keep()) {
    context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(*trouble));
  } else {
    may_leave_ = true;
    then();
  }
}

void EditorController::onAllSaved() {
  if (const auto then = std::exchange(when_saved_, nullptr))
    QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
}

void EditorController::reportSaving(Mark mark, const QString& sentence, ToastOffer offer) {
  context_.overlay.toasts()->add(mark, sentence, std::move(offer),
                                 QString::fromLatin1(metaObject()->className()));
}

bool EditorController::reportIfSaving() {
  if (!edited() || !edited()->saving()) return false;
  reportSaving(Mark::Warning,
               tr("The changes are being saved, and cannot be discarded until that has ended."));
  return true;
}

void EditorController::askToDecide(QDockWidget* panel, const QString& sentence) {
  stay();
  asked_ = sentence;
  reportSaving(Mark::Warning, asked_);
  context_.panels.open(panel);
}

void EditorController::updateDecision(const QString& sentence) {
  if (!asked_.isEmpty() && asked_ != sentence)
    context_.overlay.toasts()->withdraw(std::exchange(asked_, QString()));
}

void EditorController::updateUnsaved() {
  const bool was_unsaved = std::exchange(was_unsaved_, unsaved());
  const bool could_save = std::exchange(could_save_, maySave());
  if (was_unsaved != was_unsaved_ || could_save != could_save_) Q_EMIT unsavedChanged();
}

bool EditorController::unsaved() const { return edited() && edited()->unsaved(); }

void EditorController::followDrafts(edit::EditSession& session, QDockWidget* panel) {
  may_leave_ = false;
  announced_.clear();
  connect(&session, &edit::EditSession::remarked, this, [this](const Fault& remark) {
    context_.overlay.toasts()->add(Mark::Warning, sentences::wordsOf(remark));
  });
  if (!panel) return;
  connect(&session, &edit::EditSession::changed, this, [this, panel] {
    const QString offer = offerText();
    if (std::exchange(announced_, offer) == offer || offer.isEmpty()) return;
    context_.overlay.toasts()->add(Mark::Neutral, offer,
                                   {tr("Show"), [this, panel] { context_.panels.open(panel); }});
  });
}

void EditorController::leaveDraft() {
  if (!edited()) return;
  const auto trouble = edited()->closeDrafts();
  if (trouble && unsaved())
    context_.overlay.toasts()->add(Mark::Bad, draftWords().lost.arg(sentences::wordsOf(*trouble)));
}

bool EditorController::keepsDraft() const { return edited() && edited()->drafts(); }

QString EditorController::draftTroubleText() const {
  const Fault trouble = keepsDraft() ? edited()->drafts()->trouble() : Fault();
  return trouble.any() ? draftWords().not_backed.arg(sentences::wordsOf(trouble)) : QString();
}

QString EditorController::offerText() const {
  const edit::Draft* const draft = keepsDraft() ? edited()->drafts()->offered() : nullptr;
  if (!draft) return {};
  return draftWords().offer.arg(draftTimeText(draft->made, context_.edit.now()),
                                amountText(qsizetype(draft->changes)));
}

void EditorController::turnDownDraft() {
  if (keepsDraft()) edited()->drafts()->turnDown();
}

void EditorController::reportLeftMap(const map::MapKey& map, const QString& sentence) {
  left_map_ = map;
  // With the time: what happens again is said again, also after the strip was closed.
  const QString said = tr("The robot changed to another map at %1. %2")
                           .arg(context_.edit.now().toString(QStringLiteral("HH:mm:ss")), sentence);
  context_.notices.set(NoticeRank::Draft, {Mark::Warning, said, tr("Show it"),
                                           [context = &context_, map] {
                                             if (session::Session* const session = context->current.session())
                                               session->openMap(map);
                                           },
                                           true});
}

void EditorController::onMapOpened(const std::optional<map::MapKey>& map) {
  if (map && map == left_map_) forgetLeftMap();
}

void EditorController::forgetLeftMap() {
  if (std::exchange(left_map_, std::nullopt)) context_.notices.clear(NoticeRank::Draft);
}

QString EditorController::nameOf(const map::MapKey& map) const {
  const map::CatalogueEntry* const entry = session_ ? session_->catalogue().find(map) : nullptr;
  return mapCalled(entry ? QString::fromStdString(entry->name) : QString(), map);
}

}  // namespace mapwright::ui

#include "moc_editor_controller.cpp"
