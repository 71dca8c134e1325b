#include "jobs/map_folder.h"

#include <map>
#include <memory>
#include <utility>

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QTimer>

#include "disk/read_file.h"
#include "disk/written_file.h"
#include "jobs/change_map.h"
#include "jobs/faults.h"
#include "jobs/new_map.h"
#include "sentences/fault_sentence.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::jobs {
namespace {

class MapFolderText {
  Q_DECLARE_TR_FUNCTIONS(MapFolder)
};

using robot::MapFacts;
using robot::Outcome;

const QString kFactsFile = QStringLiteral("map.json"), kPictureFile = QStringLiteral("map.png"),
              kDataFile = QStringLiteral("map.pbstream"), kOverlaysFile = QStringLiteral("overlays.geojson");
const QString kLockFile = QStringLiteral("map.lock");  // while it is downloaded
const QString kPart = QStringLiteral(".part");         // a download that is not finished
const QString kFormat = QStringLiteral("mapwright map");
constexpr std::size_t kMostFactsBytes = std::size_t(1) << 20;
constexpr std::size_t kMostOverlayBytes = std::size_t(256) << 20;
constexpr std::size_t kMostDataBytes = std::size_t(768) << 20;  // as base64 in one request
constexpr qint64 kHashedAtOnce = qint64(4) << 20;

QString in(const QString& folder, const QString& file) { return QDir(folder).filePath(file); }

QJsonObject entryOfFile(std::int64_t bytes, const QByteArray& sha256) {
  return {{QStringLiteral("bytes"), qint64(bytes)},
          {QStringLiteral("sha256"), QString::fromLatin1(sha256.toHex())}};
}

QByteArray hashOf(std::string_view bytes) {
  return QCryptographicHash::hash(QByteArrayView(bytes.data(), qsizetype(bytes.size())),
                                  QCryptographicHash::Sha256);
}

QJsonValue orNull(const std::optional<int>& number) { return number ? QJsonValue(*number) : QJsonValue(); }

QByteArray factsJson(const MapFacts& facts, const QJsonObject& files) {
  const QJsonObject grid{{QStringLiteral("resolution"), facts.grid.resolution_m},
                         {QStringLiteral("origin"), QJsonArray{facts.grid.origin.x_m, facts.grid.origin.y_m}},
                         {QStringLiteral("size"), QJsonArray{facts.grid.width, facts.grid.height}}};
  const QJsonObject json{{QStringLiteral("format"), kFormat},
                         {QStringLiteral("version"), 1},
                         {QStringLiteral("id"), QString::fromStdString(facts.key.id)},
                         {QStringLiteral("uid"), QString::fromStdString(facts.uid)},
                         {QStringLiteral("name"), QString::fromStdString(facts.name)},
                         {QStringLiteral("map_version"), orNull(facts.map_version)},
                         {QStringLiteral("overlays_version"), orNull(facts.overlays_version)},
                         {QStringLiteral("grid"), grid},
                         {QStringLiteral("files"), files}};
  return QJsonDocument(json).toJson(QJsonDocument::Indented);
}

map::Failure aboutFile(const MapFacts& facts, Fault cause) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = map::subjectOf(facts.key, facts.name),
          .reason = map::FailureReason::Unfit,
          .cause = std::move(cause)};
}

/// One request after the other; the files that belong to the map are placed at the end.
class MapDownloading : public std::enable_shared_from_this<MapDownloading> {
 public:
  MapDownloading(robot::MapTransfer& transfer, map::MapKey key, QString folder,
                 robot::OutcomeTo<DownloadedMap> reply)
      : transfer_(transfer), reply_(std::move(reply)) {
    parts_.facts.key = std::move(key);
    done_.folder = std::move(folder);
    for (const QString& file : {kFactsFile, kPictureFile, kDataFile, kOverlaysFile})
      existing_[file] = disk::existingNow(in(done_.folder, file).toStdString());
  }

  robot::Call start() {
    // Weak, because what is in progress holds this object.
    state_->cancel = [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->cancel();
    };
    call_ = transfer_.parts(parts_.facts.key, [self = shared_from_this()](Outcome<robot::MapParts> parts) {
      self->onParts(std::move(parts));
    });
    return robot::Call(state_);
  }

 private:
  void cancel() {
    cancelled_ = true;
    call_.cancel();
  }

  void end(Outcome<DownloadedMap> outcome) {
    state_->over = true;
    lock_.reset();
    reply_(std::move(outcome));
  }

  void onParts(Outcome<robot::MapParts> parts) {
    if (!parts) return end(robot::fail(std::move(parts.error())));
    parts_ = std::move(*parts);
    if (!QDir().mkpath(done_.folder))
      return end(robot::fail(aboutFile(
          parts_.facts,
          disk::notWritten({done_.folder.toStdString(),
                            Fault(disk::fault::NoFileInFolder,
                                  {done_.folder.toStdString(), qt_error_string().toStdString()})}))));
    lock_ = std::make_unique<QLockFile>(in(done_.folder, kLockFile));
    lock_->setStaleLockTime(0);
    if (!lock_->tryLock(0))
      return end(robot::fail(aboutFile(
          parts_.facts,
          Fault(faultText("jobs", "Another download into %1 is under way."), {done_.folder.toStdString()}))));
    call_ = transfer_.download(
        parts_.facts, in(done_.folder, kDataFile),
        [self = shared_from_this()](Outcome<robot::DataDownload> data) { self->readData(std::move(data)); });
    call_.onProgress([state = state_](robot::Progress progress) {
      state->progress = progress;
      if (state->on_progress) state->on_progress(progress);
    });
  }

  void readData(Outcome<robot::DataDownload> data) {
    const QString path = in(done_.folder, kDataFile);
    if (!data && data.error().robot_code == "404" && !parts_.facts.data_bytes) {
      notWhole();
      removeOld(kDataFile);  // it has none
      return place();
    }
    if (!data) return end(robot::fail(std::move(data.error())));
    notWhole();
    done_.resumed = data->resumed;
    if (data->bytes == 0) {
      QFile::remove(path);
      return place();
    }
    done_.has_data = true;
    file_.setFileName(path);
    if (!file_.open(QIODevice::ReadOnly)) return endByFile(file_.errorString());
    hash();
  }

  /// A map that was there is replaced from now on, and not before.
  void notWhole() { removeOld(kFactsFile); }
  /// What has come meanwhile stays.
  void removeOld(const QString& name) {
    if (existing_[name] == disk::Existing::Replace) QFile::remove(in(done_.folder, name));
  }

  void endByFile(const QString& why) {
    end(robot::fail(aboutFile(parts_.facts, Fault(disk::fault::FileNotWritten, {done_.folder.toStdString()},
                                                  {fault::said(why.toStdString())}))));
  }

  /// Piece by piece, because the window is drawn on the same thread.
  void hash() {
    if (cancelled_)
      return end(robot::fail(map::Failure{.kind = map::FailureKind::Cancelled,
                                          .subject = map::subjectOf(parts_.facts.key, parts_.facts.name)}));
    const QByteArray piece = file_.read(kHashedAtOnce);
    if (!piece.isEmpty()) {
      hash_.addData(piece);
      return QTimer::singleShot(0, [self = shared_from_this()] { self->hash(); });
    }
    if (file_.error() != QFileDevice::NoError) return endByFile(file_.errorString());
    files_[kDataFile] = entryOfFile(file_.size(), hash_.result());
    done_.bytes += file_.size();
    file_.close();
    place();
  }

  bool write(const QString& name, std::string_view bytes) {
    const auto error = disk::writeFile(in(done_.folder, name).toStdString(), bytes, existing_[name]);
    if (error) {
      end(robot::fail(aboutFile(parts_.facts, disk::notWritten(*error))));
      return false;
    }
    done_.bytes += std::int64_t(bytes.size());
    return true;
  }

  void place() {
    const MapFacts& facts = parts_.facts;
    files_[kPictureFile] = entryOfFile(std::int64_t(parts_.picture->size()), hashOf(*parts_.picture));
    if (!write(kPictureFile, *parts_.picture)) return;
    if (facts.overlays.empty()) {
      removeOld(kOverlaysFile);
    } else {
      files_[kOverlaysFile] = entryOfFile(std::int64_t(facts.overlays.size()), hashOf(facts.overlays));
      if (!write(kOverlaysFile, facts.overlays)) return;
    }
    const QByteArray json = factsJson(facts, files_);
    if (!write(kFactsFile, {json.constData(), std::size_t(json.size())})) return;
    done_.facts = facts;
    end(std::move(done_));
  }

  robot::MapTransfer& transfer_;
  robot::OutcomeTo<DownloadedMap> reply_;
  std::shared_ptr<robot::Call::State> state_ = std::make_shared<robot::Call::State>();
  robot::Call call_;
  bool cancelled_ = false;
  robot::MapParts parts_;
  DownloadedMap done_;
  std::map<QString, disk::Existing> existing_;  // by the names of its files
  QFile file_;
  std::unique_ptr<QLockFile> lock_;
  QCryptographicHash hash_{QCryptographicHash::Sha256};
  QJsonObject files_;
};

/// A file of the folder as map.json describes it.
tl::expected<std::string, QString> fileOf(const QString& folder, const QJsonObject& files,
                                          const QString& name, std::size_t most) {
  const QString path = in(folder, name), shown = words::plainName(path.toStdString());
  const QJsonObject told = files.value(name).toObject();
  auto bytes = disk::readFile(path.toStdString(), most + 1);
  if (!bytes) {
    return tl::make_unexpected(
        MapFolderText::tr("%1 cannot be read: %2.").arg(shown, sentences::wordsOf(bytes.error().cause)));
  }
  if (bytes->size() > most) return tl::make_unexpected(MapFolderText::tr("%1 is too large.").arg(shown));
  const bool same =
      qint64(bytes->size()) == qint64(told.value(QLatin1String("bytes")).toDouble(-1)) &&
      QString::fromLatin1(hashOf(*bytes).toHex()) == told.value(QLatin1String("sha256")).toString();
  if (!same)
    return tl::make_unexpected(
        MapFolderText::tr("%1 is not the file that was downloaded: its size or checksum differs.")
            .arg(shown));
  return std::move(*bytes);
}

}  // namespace

QString noMapFolderReason(const QString& folder, bool force) {
  const QString shown = words::plainName(folder.toStdString());
  const QFileInfo info(folder);
  if (folder.trimmed().isEmpty()) return MapFolderText::tr("A map is downloaded into a folder: name one.");
  if (info.exists() && !info.isDir()) return MapFolderText::tr("%1 is not a folder.").arg(shown);
  if (!force && QFileInfo::exists(in(folder, kFactsFile)))
    return MapFolderText::tr("%1 already holds a map.").arg(shown);
  const bool begun = QFileInfo::exists(in(folder, kDataFile + kPart));
  for (const QString& file : {kPictureFile, kDataFile, kOverlaysFile}) {
    if (!force && !begun && QFileInfo::exists(in(folder, file)))
      return MapFolderText::tr("%1 already holds a file %2 that is of no downloaded map.").arg(shown, file);
  }
  return {};
}

robot::Call downloadMap(robot::MapTransfer& transfer, const map::MapKey& key, const QString& folder,
                        robot::OutcomeTo<DownloadedMap> reply) {
  return std::make_shared<MapDownloading>(transfer, key, folder, std::move(reply))->start();
}

bool isAboutFiles(const map::Failure& failure) {
  return failure.kind == map::FailureKind::Unsupported && failure.reason == map::FailureReason::Unfit;
}

tl::expected<robot::NewMap, QString> readMapFolder(const QString& folder, bool as_new) {
  const QString shown = words::plainName(folder.toStdString());
  const auto no = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  const auto text = disk::readFile(in(folder, kFactsFile).toStdString(), kMostFactsBytes);
  if (!text) {
    if (QFileInfo::exists(in(folder, kDataFile + kPart)))
      return no(MapFolderText::tr("The download into %1 is not finished.").arg(shown));
    return no(MapFolderText::tr("%1 holds no downloaded map: there is no %2 that can be read.")
                  .arg(shown, kFactsFile));
  }
  const QJsonObject json =
      QJsonDocument::fromJson(QByteArray(text->data(), qsizetype(text->size()))).object();
  const QJsonObject grid = json.value(QLatin1String("grid")).toObject();
  const QJsonValue uid = json.value(QLatin1String("uid"));
  const QJsonArray origin = grid.value(QLatin1String("origin")).toArray();
  if (json.value(QLatin1String("format")).toString() != kFormat ||
      json.value(QLatin1String("version")).toInt() != 1 || origin.size() != 2 || !origin[0].isDouble() ||
      !origin[1].isDouble() || !(uid.isString() || uid.isNull() || uid.isUndefined()))
    return no(MapFolderText::tr("The %2 of %1 does not describe a downloaded map.").arg(shown, kFactsFile));
  robot::NewMap map;
  map.name = json.value(QLatin1String("name")).toString().toStdString();
  map.grid.resolution_m = grid.value(QLatin1String("resolution")).toDouble();
  map.grid.origin = {origin[0].toDouble(), origin[1].toDouble(), 0};
  if (const QString why = noMapNameReason(QString::fromStdString(map.name)); !why.isEmpty()) return no(why);
  const QString why = noPlaceOfMapReason(map.grid.resolution_m, map.grid.origin.x_m, map.grid.origin.y_m);
  if (!why.isEmpty()) return no(why);
  const QJsonObject files = json.value(QLatin1String("files")).toObject();
  for (const QString& file : {kDataFile, kOverlaysFile}) {
    if (!files.contains(file) && QFileInfo::exists(in(folder, file)))
      return no(MapFolderText::tr("The %3 of %1 does not list %2, which lies beside it.")
                    .arg(shown, file, kFactsFile));
  }
  auto picture = fileOf(folder, files, kPictureFile, kMostOverlayBytes);
  if (!picture) return no(picture.error());
  map.picture = std::make_shared<const std::string>(std::move(*picture));
  const auto size = sizeOfMapPicture(map.picture);
  if (!size) return no(words::about(kPictureFile, size.error()));
  map.grid.width = size->width;
  map.grid.height = size->height;
  if (files.contains(kDataFile)) {
    auto data = fileOf(folder, files, kDataFile, kMostDataBytes);
    if (!data) return no(data.error());
    map.data = std::make_shared<const std::string>(std::move(*data));
  }
  if (files.contains(kOverlaysFile)) {
    auto overlays = fileOf(folder, files, kOverlaysFile, kMostOverlayBytes);
    if (!overlays) return no(overlays.error());
    map.overlays = std::move(*overlays);
  }
  if (as_new) return map;
  const auto version = [&](const char* name) -> std::optional<int> {
    const QJsonValue value = json.value(QLatin1String(name));
    return value.isDouble() ? std::optional(value.toInt()) : std::nullopt;
  };
  map.uid = uid.toString().toStdString();
  map.map_version = version("map_version");
  map.overlays_version = version("overlays_version");
  return map;
}

}  // namespace mapwright::jobs
