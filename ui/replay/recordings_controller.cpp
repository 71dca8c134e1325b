#include "ui/replay/recordings_controller.h"

#include <cmath>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QStandardPaths>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/replay/record_dialog.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/replay_state.h"
#include "ui/view/toast_stack.h"
#include "words/file_name.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using robot::BagKey;

namespace {

const QString kRecordingsFolderKey = QStringLiteral("recordings/folder");

QString sentence(const map::Failure& failure) { return words::plainName(sentences::sentenceOf(failure)); }

/// A file name from a robot's name.
QString fileNameOf(const BagKey& key) {
  return words::fileName(bagCalled(key), QStringLiteral("recording.bag"));
}

}  // namespace

RecordingsController::RecordingsController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new RecordingsDock(&context.window)) {
  context_.panels.add(dock_,
                      {.side = PanelPosition::Side::Bottom, .tab = 15, .menu_rank = 46, .open = false});
  QAction* const shows = context_.actions.add({.id = "showRecordings",
                                               .text = tr("Reco&rdings…"),
                                               .icon = "recordings",
                                               .tip = tr("The robot's recordings, which can be replayed"),
                                               .menu = {MenuGroup::Link, 35}},
                                              this, [this] { context_.panels.open(dock_); });
  connect(&context_.current, &CurrentSession::stateChanged, this, [this, shows] {
    const session::Session* const session = context_.current.session();
    const bool none = session && session->robot().isLocal() && !library();
    allow(shows, !none,
          none ? sentences::absenceReason(robot::Capability::Bags,
                                          session->robot().unavailableReason(robot::Capability::Bags))
               : QString());
  });
  connect(dock_, &RecordingsDock::refreshWanted, this, &RecordingsController::refresh);
  connect(dock_, &RecordingsDock::openWanted, this, &RecordingsController::open);
  connect(dock_, &RecordingsDock::downloadWanted, this, &RecordingsController::askWhereTo);
  connect(dock_, &RecordingsDock::recordWanted, this, &RecordingsController::askToRecord);
  connect(dock_, &RecordingsDock::deleteWanted, this, &RecordingsController::askToDelete);
  connect(dock_, &RecordingsDock::stopWanted, this, [this](const BagKey& key) {
    if (const auto found = downloads_.find(key); found != downloads_.end())
      robot::Call(found->second).cancel();
  });
  connect(dock_, &RecordingsDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
  showState();
}

RecordDialog* RecordingsController::recordDialog() const {
  return context_.window.findChild<RecordDialog*>();
}

robot::BagLibrary* RecordingsController::library() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().bagLibrary() : nullptr;
}

void RecordingsController::setSession(session::Session* session) {
  if (!downloads_.empty())
    context_.overlay.toasts()->add(Mark::Warning, tr("The downloads stopped when the robot was disconnected. "
                                                     "Download to the same file again to resume them."));
  downloads_.clear();
  delete question_;
  delete recordDialog();
  ++asked_;
  loading_ = listed_ = false;
  error_.clear();
  dock_->model()->clear();
  if (session && std::exchange(durations_of_, session->robot().address()) != session->robot().address())
    dock_->model()->forgetDurations();
  if (session) {
    const auto look = [this] {
      const session::Session* const present = context_.current.session();
      const bool online = present && present->connection().phase == robot::ConnectionPhase::Online;
      if (online && library() && !listed_ && !loading_) refresh();
      showState();
    };
    connect(session, &session::Session::connectionChanged, this, look);
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, look);
  }
  showState();
}

void RecordingsController::showState() {
  session::Session* const session = context_.current.session();
  RecordingsState state;
  state.connected = session != nullptr;
  state.online = session && session->connection().phase == robot::ConnectionPhase::Online;
  if (session && !library())
    state.unavailable_reason = sentences::absenceReason(
        robot::Capability::Bags, session->robot().unavailableReason(robot::Capability::Bags));
  state.loading = loading_;
  state.listed = listed_;
  state.error = error_;
  state.replaying = replayOf(session) != nullptr;
  dock_->setState(state);
}

void RecordingsController::refresh() {
  robot::BagLibrary* const library = this->library();
  if (!library) return showState();
  loading_ = true;
  library->list([this, number = ++asked_](robot::Outcome<std::vector<robot::BagEntry>> rows) {
    if (number != asked_) return;
    loading_ = false;
    error_.clear();
    if (rows) {
      listed_ = true;
      const auto selected = dock_->selected();
      dock_->model()->setRows(std::move(*rows));
      if (selected) dock_->select(*selected);
    } else {
      error_ = sentence(rows.error());
    }
    showState();
  });
  showState();
}

void RecordingsController::fail(const BagKey& key, const map::Failure& failure, const QString& path) {
  dock_->model()->setNote(key, {BagNote::Kind::Failed, sentence(failure), path});
}

void RecordingsController::open(const BagKey& key) {
  robot::BagLibrary* const library = this->library();
  if (!library) return;
  dock_->model()->setNote(key, {BagNote::Kind::Opening, tr("opening…")});
  library->info(key, [this, key](const robot::Outcome<robot::BagInfo>& outcome) {
    if (!outcome) return fail(key, outcome.error());
    dock_->model()->setNote(key, {});
    dock_->model()->setDuration(key, outcome->end_s - outcome->start_s);
    // This leaves the robot that is answering: not from within its answer.
    QMetaObject::invokeMethod(
        this, [this, key] { Q_EMIT openWanted(key); }, Qt::QueuedConnection);
  });
}

void RecordingsController::askWhereTo(const BagKey& key) {
  const BagNote note = dock_->model()->note(key);
  if (note.kind == BagNote::Kind::Stopped && !note.path.isEmpty()) return download(key, note.path);
  const QString downloads = QStandardPaths::writableLocation(QStandardPaths::DownloadLocation);
  const QDir folder(folderToWriteInto({context_.settings.value(kRecordingsFolderKey).toString(), downloads}));
  const QString path = QFileDialog::getSaveFileName(&context_.window, tr("Download %1").arg(bagCalled(key)),
                                                    folder.filePath(fileNameOf(key)));
  if (path.isEmpty()) return;
  context_.settings.setValue(kRecordingsFolderKey, QFileInfo(path).absolutePath());
  download(key, path);
}

void RecordingsController::download(const BagKey& key, const QString& path) {
  robot::BagLibrary* const library = this->library();
  if (!library || downloads_.contains(key)) return;
  dock_->model()->setNote(key, {BagNote::Kind::Downloading, tr("downloading…"), path});
  const robot::Call call =
      library->download(key, path, [this, key, path](const robot::Outcome<robot::BagDownload>& outcome) {
        onDownload(key, path, outcome);
      });
  downloads_[key] = call;
  call.onProgress([this, key, path](robot::Progress progress) {
    QString text = bytesText(progress.bytes);
    if (progress.of_bytes && *progress.of_bytes > 0) {
      const double share = double(progress.bytes) / double(*progress.of_bytes);
      text = tr("%1 %, %2 of %3")
                 .arg(int(std::floor(100 * std::min(share, 1.0))))
                 .arg(text, bytesText(*progress.of_bytes));
    }
    dock_->model()->setNote(key, {BagNote::Kind::Downloading, text, path});
  });
}

void RecordingsController::onDownload(const BagKey& key, const QString& path,
                                      const robot::Outcome<robot::BagDownload>& outcome) {
  downloads_.erase(key);
  if (outcome) {
    const QString where = QDir::toNativeSeparators(outcome->path);
    dock_->model()->setNote(
        key, {BagNote::Kind::Downloaded, tr("downloaded to %1").arg(words::plainName(where)), path});
    context_.overlay.toasts()->add(
        Mark::Good, tr("%1 was downloaded, %2.").arg(bagCalled(key), bytesText(outcome->bytes)));
  } else if (outcome.error().kind == map::FailureKind::Cancelled) {
    dock_->model()->setNote(key, {BagNote::Kind::Stopped, tr("stopped; can be resumed"), path});
  } else {
    fail(key, outcome.error(), path);
  }
}

void RecordingsController::askToRecord() {
  if (!library() || recordDialog()) return;
  auto* const dialog = new RecordDialog(&context_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RecordDialog::recordWanted, this, [this, dialog] { record(dialog); });
  dialog->open();
}

void RecordingsController::record(RecordDialog* asked) {
  robot::BagLibrary* const library = this->library();
  if (!library) return;
  asked->setAsking(true);
  library->record(asked->order(),
                  [this, asking = QPointer<QDialog>(asked)](const robot::Outcome<robot::BagEntry>& outcome) {
                    auto* const dialog = qobject_cast<RecordDialog*>(asking.data());
                    // If it was closed, the result is reported anyway.
                    const bool open = dialog && dialog->isVisible();
                    if (outcome) {
                      context_.overlay.toasts()->add(
                          Mark::Good, tr("The robot is recording %1.").arg(bagCalled(outcome->key)));
                      if (open) dialog->accept();
                    } else {
                      const QString why = tr("Nothing was recorded: %1").arg(sentence(outcome.error()));
                      open ? dialog->fail(why) : context_.overlay.toasts()->add(Mark::Bad, why);
                    }
                    refresh();
                  });
}

void RecordingsController::askToDelete(const BagKey& key) {
  const QModelIndex index = dock_->model()->indexOf(key);
  const robot::BagEntry* const entry = dock_->model()->entry(index.isValid() ? index.row() : -1);
  if (!entry || !library()) return;
  if (question_) return question_->raise();
  const QString size = index.siblingAtColumn(BagsModel::SizeColumn).data().toString();
  question_ = new QMessageBox(QMessageBox::Warning, tr("Delete from the robot"),
                              tr("Delete the %1 %2 (%3) from the robot? This cannot be undone.")
                                  .arg(kindWord(key.kind), bagCalled(key), size),
                              QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const yes = question_->addButton(tr("Delete"), QMessageBox::DestructiveRole);
  yes->setObjectName(QStringLiteral("deleteRecording"));
  question_->setDefaultButton(QMessageBox::Cancel);
  connect(yes, &QPushButton::clicked, this, [this, key] { remove(key); });
  question_->open();
}

void RecordingsController::remove(const BagKey& key) {
  robot::BagLibrary* const library = this->library();
  if (!library) return;
  dock_->model()->setNote(key, {BagNote::Kind::Deleting, tr("deleting…")});
  library->remove(key, [this, key](const robot::Outcome<BagKey>& outcome) {
    if (!outcome)
      return dock_->model()->setNote(
          key, {BagNote::Kind::Failed, tr("not deleted: %1").arg(sentence(outcome.error()))});
    dock_->model()->setNote(key, {});
    context_.overlay.toasts()->add(Mark::Good, tr("%1 was deleted.").arg(bagCalled(key)));
    refresh();
  });
}

}  // namespace mapwright::ui

#include "moc_recordings_controller.cpp"
