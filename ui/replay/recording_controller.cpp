#include "ui/replay/recording_controller.h"

#include <algorithm>

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QIcon>
#include <QStandardPaths>

#include "disk/file_error.h"
#include "recording/append_file.h"
#include "robot/delivery.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "submap/submap_store.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"
#include "ui/shell/current_session.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

const QString kRecordingFolderKey = QStringLiteral("recording/folder");
const QString kRecordingOwner = QStringLiteral("recording");
constexpr int kIconPx = 20;

/// "1:02:03".
QString recordedFor(double seconds) { return elapsedText(seconds).chopped(2); }

/// The robot's name, as far as it can be part of a file name.
QString fileNameFor(const robot::RobotIdentity& identity) {
  QString name;
  for (const QChar c : identity.name.isEmpty() ? identity.serial : identity.name)
    name += c.isLetterOrNumber() ? c : QLatin1Char('-');
  name = name.left(40);
  return QStringLiteral("%1-%2.mcap")
      .arg(name.isEmpty() ? QStringLiteral("robot") : name,
           QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
}

}  // namespace

RecordingController::RecordingController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), label_(new PlainLabel(&context.bar)) {
  action_ = context_.actions.add({.id = "record",
                                  .text = tr("R&ecord to a file…"),
                                  .icon = "record",
                                  .tip = tr("Record what the robot sends to a file; again to stop"),
                                  .toggle = true,
                                  .menu = {MenuGroup::Link, 30},
                                  .bar = {BarGroup::Robot, 20}},
                                 this, &RecordingController::toggle);
  label_->setSample(QStringLiteral("1:00:00, 1,000 MB"));
  label_->hide();
  context_.bar.addPermanentWidget(label_);
  connect(&context_.current, &CurrentSession::stateChanged, this, &RecordingController::refresh);
}

RecordingController::~RecordingController() {
  if (recorder_) recorder_->disconnect(this);
}

void RecordingController::setSession(session::Session* session) {
  if (recorder_) {
    // The robot is being left: first finishes the file.
    recorder_->disconnect(this);
    recorder_->finish();
    delete conclude();
  }
  session_ = session;
  if (session_) {
    connect(session_, &session::Session::connectionChanged, this, &RecordingController::onLink);
    for (const session::MapSlot* const slot : {&session_->wholeMap(), &session_->comparedMap()})
      connect(slot, &session::MapSlot::changed, this, &RecordingController::wantOpenMaps);
  }
  refresh();
}

void RecordingController::toggle() {
  if (recorder_) {
    stop();
  } else {
    askAndStart();
  }
  refresh();
}

void RecordingController::askAndStart() {
  if (!session_) return;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QDir folder(folderToWriteInto({context_.settings.value(kRecordingFolderKey).toString(), documents}));
  QString path = QFileDialog::getSaveFileName(&context_.window, tr("Record to a file"),
                                              folder.filePath(fileNameFor(session_->robot().identity())),
                                              tr("Recordings (*.mcap)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive)) path += QLatin1String(".mcap");
  context_.settings.setValue(kRecordingFolderKey, QFileInfo(path).absolutePath());
  if (const auto error = startInto(path)) context_.overlay.toasts()->add(Mark::Bad, *error);
}

std::optional<QString> RecordingController::startInto(const QString& path) {
  if (!session_ || recorder_) return tr("There is no robot to record from.");
  auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
  if (!target) return sentences::wordsOf(disk::notWritten(target.error()));
  recorder::Recorder::Options options;
  options.kind = context_.addresses.kindOf(session_->robot().address());
  options.recorded_by = std::string("mapwright ") + MAPWRIGHT_VERSION;
  auto started = recorder::Recorder::start(session_->robot(), std::move(*target), std::move(options));
  if (!started) return sentences::wordsOf(disk::notWritten(started.error()));
  recorder_ = std::move(*started);
  path_ = path;
  told_.reset();
  interruptions_ = not_had_ = 0;
  away_ = false;
  connect(recorder_.get(), &recorder::Recorder::progressed, this, &RecordingController::reportProgress);
  // It must not be destroyed while it emits a signal.
  connect(recorder_.get(), &recorder::Recorder::finished, this, [this] { conclude()->deleteLater(); });
  connect(recorder_.get(), &recorder::Recorder::notHad, this, [this](const map::Failure& failure) {
    ++not_had_;
    if (session_) session_->report(map::problemOf(failure, map::Severity::Warning));
  });
  // Everything it can send, not only what is on screen.
  session_->want(kRecordingOwner, recorder::everyStream());
  map::SubmapList listed;
  listed.uuid = session_->submaps().uuid();
  for (const auto& [id, row] : session_->submaps().rows()) listed.entries.push_back(row.entry);
  if (!listed.entries.empty()) recorder_->fetches().onList(listed);
  wantOpenMaps();
  onLink();
  refresh();
  return std::nullopt;
}

void RecordingController::stop() {
  if (!recorder_) return;
  if (session_) session_->want(kRecordingOwner, {});
  recorder_->stop();  // conclude() follows
  refresh();
}

recorder::Recorder* RecordingController::conclude() {
  recorder::Recorder* const recorder = recorder_.release();
  if (session_) session_->want(kRecordingOwner, {});
  const recorder::Recorder::Progress done = recorder->progress();
  const QString file = QDir::toNativeSeparators(path_);
  ToastStack* const toasts = context_.overlay.toasts();
  const ToastOffer play{tr("Play"), [this, path = path_] { Q_EMIT playWanted(path); }};
  if (done.end_fault) {
    disk::FileError fault = *done.end_fault;
    if (fault.path.empty()) fault.path = path_.toStdString();
    toasts->add(Mark::Bad, sentences::wordsOf(disk::notWritten(fault)));
  } else if (const QStringList lacks = this->lacks(done); !lacks.isEmpty()) {
    toasts->add(Mark::Warning,
                tr("Recorded to %1, but it is incomplete: %2.").arg(file, words::joined(lacks)), play);
  } else {
    toasts->add(Mark::Good, tr("Recorded to %1").arg(file), play);
  }
  refresh();
  return recorder;
}

QStringList RecordingController::lacks(const recorder::Recorder::Progress& done) const {
  QStringList lacks;
  if (interruptions_ > 0) {
    QString lost = tr("the connection was lost, times: %1").arg(interruptions_);
    if (away_) lost += tr(", and not restored at the end");
    lacks << lost;
  }
  if (done.written.lost > 0)
    lacks << tr("messages lost because the disk or this computer was too slow: %1").arg(done.written.lost);
  if (not_had_ > 0) lacks << tr("maps, lists or waypoints that could not be loaded: %1").arg(not_had_);
  return lacks;
}

void RecordingController::onLink() {
  if (!recording() || !session_) return;
  const robot::ConnectionState link = session_->connection();
  const bool lost =
      link.phase == robot::ConnectionPhase::Interrupted || link.phase == robot::ConnectionPhase::Refused;
  const QString after = recordedFor(recorder_->progress().seconds);
  if (lost && !away_) {
    away_ = true;
    ++interruptions_;
    context_.overlay.toasts()->add(Mark::Warning,
                                   tr("The recording has a gap: the connection was lost after %1. %2")
                                       .arg(after, sentences::wordsOf(link.reason)));
  } else if (away_ && link.phase == robot::ConnectionPhase::Online) {
    away_ = false;
    context_.overlay.toasts()->add(Mark::Neutral,
                                   tr("Reconnected after %1: recording continues.").arg(after));
  }
  reportProgress();
}

void RecordingController::wantOpenMaps() {
  if (!recording() || !session_) return;
  for (const session::MapSlot* const slot : {&session_->wholeMap(), &session_->comparedMap()}) {
    const map::MapKey& key = slot->key();
    // A map kept for comparing is not one of the robot's maps.
    const bool kept = slot->shown().key == key && slot->shown().state_of;
    if (slot->phase() != session::MapSlot::Phase::Empty && key.kind != map::MapKind::Live && !kept)
      recorder_->fetches().wantMap(key);
  }
}

QString RecordingController::shown() const {
  return label_->isVisibleTo(&context_.bar) ? label_->text() : QString();
}

void RecordingController::refresh() {
  const bool can = session_ && robot::deliversOf(session_->robot()) != nullptr;
  // A recording in progress continues when the connection is lost; a new one cannot be started.
  const bool online = session_ && session_->connection().phase == robot::ConnectionPhase::Online;
  action_->setEnabled(can && (recorder_ ? !recorder_->stopped() : online));
  action_->setToolTip(session_ && !can ? tr("There is no robot to record from.")
                      : can && !online && !recorder_
                          ? tr("The robot cannot be reached at the moment.")
                          : tr("Record what the robot sends to a file; again to stop"));
  action_->setChecked(recording());
  const QColor red = appColors().error;
  QIcon icon = themedIcon(QStringLiteral("record"));
  if (action_->isEnabled())
    icon = QIcon(iconPixmap(QStringLiteral("record"), kIconPx, context_.window.devicePixelRatioF(), red));
  action_->setIcon(icon);
  label_->setVisible(recorder_ != nullptr);
  if (recorder_) reportProgress();
}

void RecordingController::reportProgress() {
  if (!recorder_) return;
  const recorder::Recorder::Progress now = recorder_->progress();
  QString text = tr("%1, %2").arg(recordedFor(now.seconds), bytesText(qint64(now.written.bytes)));
  if (now.written.lost > 0) text += tr(", lost: %1").arg(now.written.lost);
  if (away_) text += tr(", no connection");
  label_->setIcon(QStringLiteral("record"), appColors().error);
  label_->setText(text);
  ToastStack* const toasts = context_.overlay.toasts();
  if (now.written.fault && now.written.fault != told_) {
    disk::FileError fault = *now.written.fault;
    if (fault.path.empty()) fault.path = path_.toStdString();
    toasts->add(Mark::Bad, tr("%1 Recording continues when there is enough disk space.")
                               .arg(sentences::wordsOf(disk::notWritten(fault))));
  } else if (!now.written.fault && told_) {
    toasts->add(Mark::Good, tr("Recording to the file continues."));
  }
  told_ = now.written.fault;
}

}  // namespace mapwright::ui

#include "moc_recording_controller.cpp"
