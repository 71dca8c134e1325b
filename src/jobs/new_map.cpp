#include "jobs/new_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QImageWriter>

#include "disk/read_file.h"
#include "grids/byte_source.h"
#include "grids/grid_pyramid.h"
#include "grids/picture_rows.h"
#include "jobs/change_map.h"
#include "jobs/change_overlays.h"
#include "sentences/fault_sentence.h"
#include "words/decimal.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::jobs {
namespace {

class NewMapText {
  Q_DECLARE_TR_FUNCTIONS(NewMap)
};

constexpr std::size_t kMostPictureBytes = std::size_t(128) << 20;
constexpr int kMostEdge = 20'000;
constexpr std::int64_t kMostCells = 100'000'000;
constexpr double kFarthestOriginM = 1e7;  // as maps of everybody: UTM
constexpr double kSameM = 1e-4;           // robots keep single precision

/// Whether both show the same gray levels.
bool showTheSame(const std::shared_ptr<const std::string>& one,
                 const std::shared_ptr<const std::string>& two) {
  if (one && two && *one == *two) return true;
  const auto cellsOf =
      [](const std::shared_ptr<const std::string>& png) -> std::shared_ptr<const grids::GridPyramid> {
    if (!png) return nullptr;
    grids::GridOptions every_gray;
    every_gray.code = grids::CellCode::FullGray;
    auto reading = grids::openGrid(png, every_gray);
    if (!reading || (*reading)->read(std::atomic<bool>(false), [] {})) return nullptr;
    return (*reading)->pyramid();
  };
  const auto first = cellsOf(one), second = cellsOf(two);
  if (!first || !second || first->width() != second->width() || first->height() != second->height())
    return false;
  grids::GridRows sent(*first), held(*second);
  for (int y = 0; y < first->height(); ++y) {
    const std::uint8_t* const row = sent.row(y);
    if (!std::equal(row, row + first->width(), held.row(y))) return false;
  }
  return true;
}

bool holdsOverlays(const std::string& held, const std::string& sent) {
  if (held == sent) return true;
  const auto one = overlays::OverlayDocument::read(sent), two = overlays::OverlayDocument::read(held);
  return one && two && otherwiseHeld(*one, *two).empty();
}

/// The gray levels of a picture, transparent ones as 128; nullptr if it has no transparent pixel, or cannot
/// be encoded.
std::shared_ptr<const std::string> opaqueOf(const std::shared_ptr<const std::string>& png) {
  const auto header = grids::openPicture(grids::ByteSource(png));
  if (!header || !(*header)->format().has_alpha) return nullptr;
  grids::GridOptions options;
  options.code = grids::CellCode::ClearGray;
  auto reading = grids::openGrid(png, options);
  if (!reading || (*reading)->read(std::atomic<bool>(false), [] {})) return nullptr;
  const grids::GridPyramid& cells = *(*reading)->pyramid();
  QImage gray(cells.width(), cells.height(), QImage::Format_Grayscale8);
  if (gray.isNull()) return nullptr;
  grids::GridRows rows(cells);
  for (int y = 0; y < cells.height(); ++y) std::copy_n(rows.row(y), cells.width(), gray.scanLine(y));
  QBuffer out;
  if (!out.open(QIODevice::WriteOnly) || !QImageWriter(&out, "png").write(gray)) return nullptr;
  return std::make_shared<const std::string>(out.data().toStdString());
}

bool isPng(const std::string& bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

}  // namespace

QString noPlaceOfMapReason(double resolution_m, double x_m, double y_m) {
  if (!(resolution_m >= kFinestMapM && resolution_m <= kCoarsestMapM))
    return NewMapText::tr("The resolution must be between %1 and %2 metres per cell, for example 0.05.")
        .arg(kFinestMapM)
        .arg(kCoarsestMapM);
  if (!(std::abs(x_m) <= kFarthestOriginM && std::abs(y_m) <= kFarthestOriginM))
    return NewMapText::tr("The origin must be within 10,000 km.");
  return {};
}

tl::expected<std::shared_ptr<const std::string>, QString> readMapPicture(const QString& path) {
  const auto no = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  const QString shown = words::plainName(path.toStdString());
  auto bytes = disk::readFile(path.toStdString(), kMostPictureBytes + 1);
  if (!bytes)
    return no(NewMapText::tr("%1 cannot be read: %2.").arg(shown, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > kMostPictureBytes) return no(NewMapText::tr("%1 is larger than 128 MiB.").arg(shown));
  return std::make_shared<const std::string>(std::move(*bytes));
}

tl::expected<PictureSize, QString> sizeOfMapPicture(const std::shared_ptr<const std::string>& png) {
  const auto no = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  if (!png || !isPng(*png)) return no(NewMapText::tr("It is not a PNG picture."));
  auto reading = grids::openGrid(png, {});
  if (!reading) return no(sentences::sentenceOf(reading.error()));
  const int width = (*reading)->pyramid()->width(), height = (*reading)->pyramid()->height();
  if (width > kMostEdge || height > kMostEdge || std::int64_t(width) * height > kMostCells)
    return no(
        NewMapText::tr("It has %1 x %2 pixels. At most %3 along an edge, and 100 million in all, can be "
                       "the map of a robot.")
            .arg(width)
            .arg(height)
            .arg(kMostEdge));
  if ((*reading)->read(std::atomic<bool>(false), [] {}))
    return no(NewMapText::tr("The picture is damaged or cut off."));
  return PictureSize{width, height};
}

tl::expected<MapFromPicture, QString> newMapFrom(const PictureMap& picture) {
  const auto no = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  if (const QString why = noMapNameReason(picture.name); !why.isEmpty()) return no(why);
  if (const QString why = noPlaceOfMapReason(picture.resolution_m, picture.x_m, picture.y_m); !why.isEmpty())
    return no(why);
  auto bytes = readMapPicture(picture.path);
  if (!bytes) return no(bytes.error());
  MapFromPicture from;
  robot::NewMap& made = from.map;
  made.picture = std::move(*bytes);
  const auto size = sizeOfMapPicture(made.picture);
  if (!size) return no(words::about(words::plainName(picture.path.toStdString()), size.error()));
  made.name = picture.name.toStdString();
  made.grid = {size->width, size->height, picture.resolution_m, {picture.x_m, picture.y_m, 0}};
  if (auto opaque = opaqueOf(made.picture)) {
    made.picture = std::move(opaque);
    from.made_opaque = true;
  }
  return from;
}

QStringList differences(const robot::NewMap& sent, const robot::MapParts& held) {
  const robot::MapFacts& now = held.facts;
  QStringList all;
  if (now.name != sent.name) all << NewMapText::tr("it is called \"%1\"").arg(words::plainName(now.name));
  const auto other = [](double one, double two) { return !(std::abs(one - two) <= kSameM); };
  if (other(now.grid.resolution_m, sent.grid.resolution_m))
    all << NewMapText::tr("its resolution is %1 m").arg(words::decimal(now.grid.resolution_m));
  if (other(now.grid.origin.x_m, sent.grid.origin.x_m) || other(now.grid.origin.y_m, sent.grid.origin.y_m))
    all << NewMapText::tr("its lower left corner is at %1, %2 m")
               .arg(words::decimal(now.grid.origin.x_m), words::decimal(now.grid.origin.y_m));
  if (sent.data && now.data_bytes && *now.data_bytes != std::int64_t(sent.data->size()))
    all << NewMapText::tr("its data has %1 of %2 bytes").arg(*now.data_bytes).arg(sent.data->size());
  if (!held.picture) {
    all << NewMapText::tr("its picture cannot be loaded");
  } else if (!showTheSame(sent.picture, held.picture)) {
    all << NewMapText::tr("its picture is another one");
  }
  if (!sent.overlays.empty() && !holdsOverlays(now.overlays, sent.overlays))
    all << (now.overlays.empty() ? NewMapText::tr("it has no overlays")
                                 : NewMapText::tr("its overlays are other ones"));
  if (!sent.uid.empty() && now.uid != sent.uid) all << NewMapText::tr("it has another uid");
  return all;
}

}  // namespace mapwright::jobs
