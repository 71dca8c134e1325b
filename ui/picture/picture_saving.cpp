// PictureController: saving, its result, and leaving.
#include <utility>

#include <QDir>
#include <QMessageBox>
#include <QPushButton>

#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/panels.h"
#include "ui/picture/picture_controller.h"
#include "ui/picture/picture_copies.h"
#include "ui/picture/picture_dock.h"
#include "ui/picture/picture_drafts.h"
#include "ui/picture/picture_text.h"
#include "ui/view/map_overlay.h"
#include "ui/view/on_screen.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {

namespace {
constexpr int kKeep = -1;  // the answer for which QMessageBox has no name
}

void PictureController::askToDecide() {
  when_saved_ = nullptr;
  context_.overlay.toasts()->add(Mark::Warning, tr("The map is not saved yet: some cells were changed both "
                                                   "here and elsewhere. Choose which ones to keep."));
  context_.panels.open(dock_);
}

void PictureController::save() {
  editing_.endStroke();
  if (saving_ || !editing_.unsaved() || !session_ || !open_map_) return;
  if (editing_.conflicts() > 0) return askToDecide();
  // A robot drives by it from then on.
  session_->robot().isLocal() ? send() : askToSend();
}

void PictureController::askToSend() {
  if (sending_question_) return sending_question_->raise();
  sending_question_ =
      new QMessageBox(QMessageBox::Question, tr("Send the map to the robot"),
                      tr("Overwrite %1 on the robot %2?").arg(mapName(), robotCalled(session_->robot())),
                      QMessageBox::Cancel, &context_.window);
  sending_question_->setTextFormat(Qt::PlainText);
  const QString copies = copiesHere();
  QString about = tr("%1 changed. The robot will use the new picture. It does not keep the old one.")
                      .arg(cellsText(editing_.changedCells()));
  if (!copies.isEmpty())
    about += QLatin1Char('\n') + tr("A copy of the old picture is saved in %1 as a local map. The latest %2 "
                                    "copies of each map are kept.")
                                     .arg(QDir::toNativeSeparators(copies))
                                     .arg(kMostCopies);
  sending_question_->setInformativeText(about);
  sending_question_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const send_button = sending_question_->addButton(tr("Send"), QMessageBox::AcceptRole);
  send_button->setObjectName(QStringLiteral("sendPicture"));
  sending_question_->setDefaultButton(QMessageBox::Cancel);
  sending_question_->setEscapeButton(QMessageBox::Cancel);
  connect(sending_question_, &QMessageBox::finished, this, [this, send_button, opened = opened_] {
    QMessageBox* const asked = std::exchange(sending_question_, nullptr);
    if (asked->clickedButton() == send_button && opened == opened_) {
      const QString folder = copiesHere();
      copy_ = folder.isEmpty() ? QString() : copyPath(folder, context_.edit.now());
      return send();
    }
    when_saved_ = nullptr;
  });
  sending_question_->open();
}

QMessageBox* PictureController::sendingQuestion() const { return sending_question_; }

void PictureController::send() {
  if (saving_ || !editing_.unsaved() || !session_ || !open_map_) return;
  if (editing_.conflicts() > 0) return askToDecide();
  if (editing_.merging()) {
    again_ = true;  // it would be refused: the stored picture has already changed
    return;
  }
  if (!session_->robot().pictureStore()) return;
  saving_ = true;
  trouble_.clear();
  refresh();
  if (copy_.isEmpty()) return write();
  share_.startLong(
      [this, path = copy_, cells = editing_.saved(), place = editing_.reference(), opened = opened_] {
        const auto trouble = keepCopy(*cells, place, path);
        QMetaObject::invokeMethod(
            this,
            [this, trouble, opened] {
              if (opened == opened_) noteCopied(trouble);
            },
            Qt::QueuedConnection);
      });
}

QString PictureController::copiesHere() const {
  return copiesFolder(context_.edit.drafts_folder, session_->robot().address(), mapName());
}

/// Without a backup nothing is overwritten.
void PictureController::noteCopied(const std::optional<Fault>& trouble) {
  if (!saving_) return;
  if (!trouble) return write();
  saving_ = false;
  noteNotWritten(tr("Nothing was sent, because the robot's map could not be backed up: %1")
                     .arg(sentences::wordsOf(*trouble)));
  syncMap();
}

void PictureController::noteNotWritten(const QString& sentence) {
  when_saved_ = nullptr;
  trouble_ = sentence;
  context_.overlay.toasts()->add(Mark::Bad, tr("The map was not saved. %1").arg(trouble_));
}

void PictureController::write() {
  robot::PictureStore* const store = session_->robot().pictureStore();
  if (!store) {
    saving_ = false;
    return refresh();
  }
  const auto cells = editing_.snapshot();
  write_call_ = store->write({*open_map_, cells, revision_},
                             [this, cells, opened = opened_](robot::Outcome<robot::PictureReceipt> outcome) {
                               if (opened == opened_) noteWritten(cells, outcome);
                             });
  write_call_.onProgress([this, opened = opened_](robot::Progress progress) {
    if (opened != opened_ || !saving_ || !progress.of_bytes || *progress.of_bytes <= 0) return;
    dock_->setTravelled(double(progress.bytes) / double(*progress.of_bytes));
  });
  refresh();
}

void PictureController::noteWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                                    const robot::Outcome<robot::PictureReceipt>& outcome) {
  saving_ = false;
  dock_->setTravelled(std::nullopt);
  if (outcome) {
    revision_ = outcome->revision;
    own_revisions_.insert(revision_);
    Q_EMIT written();
    editing_.noteSaved(cells);
    if (copy_.isEmpty()) {
      context_.overlay.toasts()->add(Mark::Good, tr("%1 saved").arg(mapName()));
    } else {
      context_.overlay.toasts()->add(
          Mark::Good, tr("%1 saved. Previous version: %2").arg(mapName(), QDir::toNativeSeparators(copy_)),
          {tr("Open it"), [this, copy = copy_] { Q_EMIT fileWanted(copy); }});
    }
    // Leaving ends the session, and its robot is emitting this signal.
    if (const auto then = std::exchange(when_saved_, nullptr))
      QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
  } else if (outcome.error().kind == map::FailureKind::Conflict) {
    again_ = true;
    trouble_ = tr("It was changed elsewhere in the meantime and is being reloaded.");
  } else if (outcome.error().kind == map::FailureKind::Cancelled &&
             outcome.error().applied == map::Applied::No) {
    when_saved_ = nullptr;
  } else {
    noteNotWritten(QString::fromStdString(sentences::sentenceOf(outcome.error())));
  }
  // Changes that arrived during the write were ignored.
  syncMap();
}

void PictureController::noteMerged(qint64 taken, const std::string& revision) {
  revision_ = revision;
  trouble_.clear();
  const bool again = std::exchange(again_, false);
  if (editing_.conflicts() == 0) conflicts_told_ = false;
  if (editing_.conflicts() > 0) {
    if (!std::exchange(conflicts_told_, true) || again) askToDecide();
  } else if (again) {
    if (editing_.unsaved()) {
      send();
    } else if (const auto then = std::exchange(when_saved_, nullptr)) {
      QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
    }
  } else if (taken > 0) {
    const QString told = tr("%1 was changed elsewhere. The two versions were merged.").arg(mapName());
    // Someone painting there causes this with every stroke.
    if (!context_.overlay.toasts()->texts().contains(told))
      context_.overlay.toasts()->add(Mark::Warning, told);
  }
  refresh();
}

QString PictureController::mapName() const {
  return session_ ? mapCalled(session_->wholeMap().name(), session_->wholeMap().key()) : QString();
}

void PictureController::beforeLeaving(std::function<void()> then) {
  editing_.endStroke();
  if (!unsaved() || may_leave_) return then();
  when_left_ = std::move(then);
  if (question_) return question_->raise();
  question_ = new QMessageBox(
      QMessageBox::Question, tr("The map is not saved"),
      tr("Changes to %1 are not saved: %2.").arg(mapName(), cellsText(editing_.changedCells())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Save);
  if (drafts_) {
    QPushButton* const keep = question_->addButton(tr("Keep as draft"), QMessageBox::ActionRole);
    keep->setObjectName(QStringLiteral("keepDraft"));
    keep->setToolTip(tr("They will be offered when you open this map again"));
  }
  connect(question_, &QMessageBox::finished, this, [this] {
    QMessageBox* const asked = std::exchange(question_, nullptr);
    QAbstractButton* const clicked = asked->clickedButton();
    if (!clicked) return answer(QMessageBox::Cancel);
    const auto standard = asked->standardButton(clicked);
    answer(standard == QMessageBox::NoButton ? kKeep : int(standard));
  });
  question_->open();
}

void PictureController::answer(int button) {
  const auto then = std::exchange(when_left_, nullptr);
  if (!then || !open_map_) return;
  if (button == QMessageBox::Save) {
    when_saved_ = then;
    save();
  } else if (button == QMessageBox::Discard) {
    editing_.revert();
    if (!editing_.reckoning()) return then();
    when_reverted_ = then;
  } else if (button == kKeep && drafts_) {
    if (const auto trouble = drafts_->keep()) {
      context_.overlay.toasts()->add(Mark::Bad, sentences::wordsOf(*trouble));
    } else {
      may_leave_ = true;
      then();
    }
  }
}

}  // namespace mapwright::window
