#include "ui/maps/transfer_controller.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QAction>
#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardPaths>

#include "jobs/change_map.h"
#include "jobs/export_map.h"
#include "jobs/map_folder.h"
#include "jobs/new_map.h"
#include "map/live_state.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/new_map_dialog.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/file_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

const QString kDownloadsKey = QStringLiteral("maps/downloads");
constexpr int kPreviewPx = 800;

/// Where this map is downloaded to below `parent`: an interrupted download goes on, a whole one is kept.
QString folderFor(const QString& parent, const map::CatalogueEntry& map) {
  const QString name = words::shortFileName(
      QStringLiteral("%1-%2").arg(words::plainName(map.name).left(60), QString::fromStdString(map.key.id)),
      QStringLiteral("map"));
  for (int number = 1;; ++number) {
    const QString folder =
        QDir(parent).filePath(number == 1 ? name : QStringLiteral("%1-%2").arg(name).arg(number));
    if (jobs::noMapFolderReason(folder, false).isEmpty()) return folder;
  }
}

struct PreviewedPicture {
  QSize size;
  QImage shown;
};

tl::expected<PreviewedPicture, QString> previewOf(const QString& path) {
  const auto bytes = jobs::readMapPicture(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  const auto& png = *bytes;
  const auto size = jobs::sizeOfMapPicture(png);
  if (!size) return tl::make_unexpected(size.error());
  PreviewedPicture picture{{size->width, size->height}, {}};
  QByteArray raw = QByteArray::fromRawData(png->data(), qsizetype(png->size()));
  QBuffer buffer(&raw);
  QImageReader reader(&buffer, "png");
  reader.setScaledSize(picture.size.scaled(kPreviewPx, kPreviewPx, Qt::KeepAspectRatio));
  picture.shown = reader.read();
  return picture;
}

}  // namespace

TransferDialog::TransferDialog(const QString& title, const QString& what, QWidget* parent)
    : QDialog(parent),
      what_(wrappedLabel(what, this)),
      said_(wrappedLabel({}, this)),
      bar_(new QProgressBar(this)),
      again_(new QPushButton(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(title);
  setMinimumWidth(460);
  makeLine(*bar_);
  bar_->setVisible(true);
  bar_->setAccessibleName(tr("Progress"));
  again_->setVisible(false);
  giveRoles(*again_, {cancel_});
  said_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  said_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  said_->setText(tr("Asking the robot…"));
  setLayout(columnOf({what_, bar_, said_, rowOf({LayoutItem::rest(), cancel_, again_}, 8)}, 10,
                     QMargins(16, 16, 16, 16)));
  connect(again_, &QPushButton::clicked, this, &TransferDialog::againWanted);
  connect(cancel_, &QPushButton::clicked, this, &TransferDialog::reject);
}

void TransferDialog::setCall(const robot::Call& call) {
  call_ = call;
  call.onProgress([self = QPointer<TransferDialog>(this)](robot::Progress progress) {
    if (self) self->setProgress(progress);
  });
}

void TransferDialog::setProgress(const robot::Progress& progress) {
  const qint64 of = progress.of_bytes.value_or(0);
  bar_->setValue(of > 0 ? int(std::min<qint64>(1000, progress.bytes * 1000 / of)) : 0);
  said_->setText(of > 0 ? tr("%1 of %2").arg(bytesText(progress.bytes), bytesText(of))
                        : bytesText(progress.bytes));
}

void TransferDialog::setFailed(const QString& sentence, const QString& again) {
  failed_ = true;
  call_.reset();
  setTextColor(*said_, appColors().error_text);
  said_->setText(sentence);
  again_->setText(again);
  again_->setVisible(!again.isEmpty());
  cancel_->setText(tr("Close"));
}

QString TransferDialog::said() const { return said_->text(); }

void TransferDialog::reject() {
  // Its outcome closes the dialog.
  if (call_ && !call_->over()) {
    said_->setText(tr("Cancelling…"));
    return call_->cancel();
  }
  QDialog::reject();
}

TransferController::TransferController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), share_(context.workers) {
  upload_ =
      context_.actions.add({.id = "uploadMap",
                            .text = tr("&Add a downloaded map…"),
                            .tip = tr("Add a map that was downloaded from a robot to this robot's maps"),
                            .menu = {MenuGroup::Mapping, 40}},
                           this, [this] {
                             const QString folder = QFileDialog::getExistingDirectory(
                                 &context_.window, tr("Choose the folder of a downloaded map"),
                                 context_.settings.value(kDownloadsKey).toString());
                             if (!folder.isEmpty()) upload(folder);
                           });
  create_ = context_.actions.add({.id = "createMap",
                                  .text = tr("Add a map from a p&icture…"),
                                  .tip = tr("Make a map from a PNG and add it to this robot's maps"),
                                  .menu = {MenuGroup::Mapping, 50}},
                                 this, [this] {
                                   const QString path = QFileDialog::getOpenFileName(
                                       &context_.window, tr("Choose a picture"),
                                       lastMapFolder(context_.settings), tr("PNG pictures (*.png)"));
                                   if (path.isEmpty()) return;
                                   rememberMapFolder(context_.settings, QFileInfo(path).absolutePath());
                                   create(path);
                                 });
  connect(&context_.current, &CurrentSession::stateChanged, this, &TransferController::refresh);
  refresh();
}

robot::MapTransfer* TransferController::transfer() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().mapTransfer() : nullptr;
}

void TransferController::setSession(session::Session* session) {
  ++asked_;
  if (dialog_ && !dialog_->failed())
    context_.overlay.toasts()->add(
        Mark::Warning,
        tr("The transfer stopped when the robot was disconnected. Start a download again to resume it."));
  delete dialog_;
  delete new_map_;
  if (session)
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &TransferController::refresh);
  refresh();
}

void TransferController::refresh() {
  const session::Session* const session = context_.current.session();
  const bool online = session && session->connection().phase == robot::ConnectionPhase::Online;
  for (QAction* const action : {upload_, create_}) {
    action->setVisible(transfer() != nullptr);
    action->setEnabled(online && transfer() && !dialog_);
  }
}

void TransferController::fillMenu(QMenu* menu, const map::MapKey& key) {
  if (!transfer() || key.kind != map::MapKind::Stored) return;
  QAction* const action =
      menu->addAction(tr("Download with its data…"), this, [this, key] { askWhereTo(key, false); });
  action->setEnabled(!dialog_);
  QAction* const opens =
      menu->addAction(tr("Download and open its submaps…"), this, [this, key] { openSubmaps(key); });
  opens->setEnabled(!dialog_);
  opens->setToolTip(tr("Shows the SLAM state of this map from the downloaded file, without the robot"));
}

void TransferController::openSubmaps(const map::MapKey& key) {
  // One at a time.
  if (dialog_) return dialog_->raise();
  askWhereTo(key, true);
}

void TransferController::askWhereTo(const map::MapKey& key, bool open) {
  session::Session* const session = context_.current.session();
  const map::CatalogueEntry* const map = session ? session->catalogue().find(key) : nullptr;
  if (!map) return;
  const map::CatalogueEntry entry = *map;
  const QString downloads = QStandardPaths::writableLocation(QStandardPaths::DownloadLocation);
  const QString parent = QFileDialog::getExistingDirectory(
      &context_.window, tr("Choose where to create the folder of %1").arg(plainWords(entry.name, 60)),
      folderToWriteInto({context_.settings.value(kDownloadsKey).toString(), downloads}));
  if (parent.isEmpty()) return;
  context_.settings.setValue(kDownloadsKey, parent);
  download(key, words::plainName(entry.name), folderFor(parent, entry), open);
}

void TransferController::begin(const QString& title, const QString& what) {
  delete dialog_;
  dialog_ = new TransferDialog(title, what, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QObject::destroyed, this, &TransferController::refresh, Qt::QueuedConnection);
  dialog_->show();
  refresh();
}

void TransferController::download(const map::MapKey& key, const QString& name, const QString& folder,
                                  bool open) {
  robot::MapTransfer* const robots = transfer();
  if (!robots) return;
  const QString where = words::plainName(folder.toStdString());
  begin(tr("Download a map"), tr("%1 goes to %2").arg(name, where));
  connect(dialog_, &TransferDialog::againWanted, this, [this, key, name, folder, open] {
    // The dialog is the one that asks.
    QMetaObject::invokeMethod(
        this, [=, this] { download(key, name, folder, open); }, Qt::QueuedConnection);
  });
  // The checksum may be finished after the robot is left.
  const auto wanted = [self = QPointer<TransferController>(this), asked = asked_] {
    return self && asked == self->asked_ && self->dialog_;
  };
  dialog_->setCall(jobs::downloadMap(
      *robots, key, folder,
      [this, wanted, name, where, open](const robot::Outcome<jobs::DownloadedMap>& done) {
        if (!wanted()) return;
        if (!done) {
          const QString said = QString::fromStdString(sentences::sentenceOf(done.error()));
          return dialog_->setFailed(said, tr("Go on"));
        }
        context_.overlay.toasts()->add(
            done->has_data ? Mark::Good : Mark::Warning,
            done->has_data
                ? tr("%1 was downloaded to %2, %3.").arg(name, where, bytesText(done->bytes))
                : tr("%1 was downloaded to %2 without data: the robot has none for it.").arg(name, where));
        delete dialog_;  // now: what is opened leaves the robot, and nothing is on its way
        if (open && done->has_data)
          Q_EMIT openWanted(QDir(done->folder).filePath(QStringLiteral("map.pbstream")));
      }));
}

void TransferController::upload(const QString& folder, bool as_new) {
  const QString where = words::plainName(folder.toStdString());
  add(tr("Add a downloaded map"), tr("Sending %1 to the robot").arg(where),
      [folder, as_new] { return jobs::readMapFolder(folder, as_new); });
  connect(dialog_, &TransferDialog::againWanted, this, [this, folder] {
    // The dialog is the one that asks.
    QMetaObject::invokeMethod(
        this, [this, folder] { upload(folder, true); }, Qt::QueuedConnection);
  });
}

void TransferController::create(const QString& path) {
  share_.startLong([this, path, asked = asked_] {
    auto preview = std::make_shared<tl::expected<PreviewedPicture, QString>>(previewOf(path));
    QMetaObject::invokeMethod(
        this,
        [this, path, asked, preview] {
          if (asked != asked_) return;
          if (*preview) return askForPlace(path, (*preview)->size, (*preview)->shown);
          context_.overlay.toasts()->add(
              Mark::Bad,
              tr("%1 cannot be a map: %2").arg(plainWords(QFileInfo(path).fileName(), 80), preview->error()));
        },
        Qt::QueuedConnection);
  });
}

void TransferController::askForPlace(const QString& path, const QSize& size, const QImage& shown) {
  session::Session* const session = context_.current.session();
  if (!session || !transfer()) return;
  delete new_map_;
  new_map_ = new NewMapDialog(path, size, shown, &context_.window);
  new_map_->setRemark([this](const QString& name) { return alsoCalledSo(name); });
  new_map_->setAttribute(Qt::WA_DeleteOnClose);
  new_map_->setPresent(context_.scene.contentBounds(), session->live().robot_pose);
  connect(new_map_, &QDialog::accepted, this, [this] {
    const jobs::PictureMap picture = new_map_->picture();
    add(tr("A map from a picture"),
        tr("Sending %1 to the robot").arg(words::plainName(picture.name.toStdString())),
        [picture]() -> tl::expected<robot::NewMap, QString> {
          auto made = jobs::newMapFrom(picture);
          if (!made) return tl::make_unexpected(made.error());
          return std::move(made->map);
        });
  });
  new_map_->open();
}

void TransferController::add(const QString& title, const QString& what,
                             std::function<tl::expected<robot::NewMap, QString>()> read) {
  if (!transfer()) return;
  begin(title, what);
  share_.startLong([this, read = std::move(read), asked = asked_] {
    auto map = std::make_shared<tl::expected<robot::NewMap, QString>>(read());
    QMetaObject::invokeMethod(
        this,
        [this, asked, map] {
          if (asked != asked_ || !dialog_) return;
          if (!*map) return dialog_->setFailed(map->error(), {});
          send(**map);
        },
        Qt::QueuedConnection);
  });
}

void TransferController::send(const robot::NewMap& map) {
  robot::MapTransfer* const robots = transfer();
  if (!robots) return;
  const QString also = alsoCalledSo(QString::fromStdString(map.name));
  dialog_->setCall(robots->add(map, [this, map, also](const robot::Outcome<robot::MapParts>& held) {
    if (!dialog_) return;
    if (!held) {
      map::Failure failure = held.error();
      failure.asked_for = map::AskedFor::Addition;
      return dialog_->setFailed(
          QString::fromStdString(sentences::sentenceOf(failure)),
          failure.kind == map::FailureKind::Conflict ? tr("Add as another map") : QString());
    }
    share_.startLong([this, map, held = *held, also, asked = asked_] {
      const QStringList odd = jobs::differences(map, held);
      QMetaObject::invokeMethod(
          this,
          [this, asked, odd, also, name = plainWords(held.facts.name, 80)] {
            if (asked == asked_ && dialog_) reportAdded(name, odd, also);
          },
          Qt::QueuedConnection);
    });
  }));
}

void TransferController::reportAdded(const QString& name, const QStringList& odd, const QString& also) {
  context_.overlay.toasts()->add(
      odd.isEmpty() ? Mark::Good : Mark::Warning,
      words::paragraph(odd.isEmpty() ? QStringList{tr("%1 was added to the robot's maps.").arg(name), also}
                                     : QStringList{tr("The robot accepted %1, but stored it differently: %2.")
                                                       .arg(name, words::joined(odd))}));
  if (session::Session* const session = context_.current.session()) session->catalogue().refresh();
  dialog_->accept();
}

QString TransferController::alsoCalledSo(const QString& name) const {
  const session::Session* const session = context_.current.session();
  return session ? jobs::alsoCalledSo({.change = robot::MapChange::Save, .name = name.toStdString()},
                                      session->catalogue().entries())
                 : QString();
}

}  // namespace mapwright::ui

#include "moc_transfer_controller.cpp"
