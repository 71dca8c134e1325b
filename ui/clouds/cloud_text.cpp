#include "ui/clouds/cloud_text.h"

#include <QCoreApplication>

#include "sentences/plural.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

class CloudTextText {
  Q_DECLARE_TR_FUNCTIONS(CloudText)
};

QString metres(double value, int decimals) {
  if (std::abs(value) < std::pow(10, -decimals) / 2) value = 0;
  return QString::number(value, 'f', decimals);
}

QString grouped(std::uint64_t number) { return QString::fromStdString(words::grouped(std::int64_t(number))); }

}  // namespace

QString cloudSumsText(const clouds::CloudSums& sums) {
  if (sums.clouds == 0) return CloudTextText::tr("Nothing has been fetched yet.");
  const auto count = [](std::uint64_t number) { return sentences::formOf(qint64(number)); };
  QStringList lines;
  if (sums.shown == sums.came) {
    lines << sentences::counted(CloudTextText::tr("%1 points are shown.", nullptr, count(sums.shown)),
                                qint64(sums.shown));
  } else {
    lines << CloudTextText::tr("%1 points of %2 are shown.").arg(grouped(sums.shown), grouped(sums.came));
  }
  if (sums.left_out > 0) {
    lines << sentences::counted(
        CloudTextText::tr("%1 more have invalid or absurdly large coordinates and were left out.", nullptr,
                          count(sums.left_out)),
        qint64(sums.left_out));
  }
  if (sums.thinned > 0) {
    lines << sentences::counted(CloudTextText::tr("%1 points, evenly spread, are not shown, to save memory.",
                                                  nullptr, count(sums.thinned)),
                                qint64(sums.thinned));
  }
  if (sums.forgotten > 0) {
    lines << sentences::counted(
        CloudTextText::tr("%1 older clouds were discarded to save memory.", nullptr, count(sums.forgotten)),
        qint64(sums.forgotten));
  }
  if (sums.without_z) lines << CloudTextText::tr("Some points have no height: they are drawn at 0 m.");
  if (sums.voxels) {
    lines << (sums.voxel_m
                  ? CloudTextText::tr("The cell size appears to be %1 m.").arg(metres(*sums.voxel_m, 3))
                  : CloudTextText::tr("The cell size cannot be determined from the positions of the cells."));
  }
  if (sums.frames.size() > 1) {
    QStringList names;
    for (const std::string& frame : sums.frames) names << words::plainName(frame);
    lines << CloudTextText::tr("They are in different frames (%1) and may not align.")
                 .arg(words::listed(names));
  }
  lines << CloudTextText::tr("%1 of memory").arg(megabytesText(std::int64_t(sums.bytes)));
  return lines.join(QLatin1Char('\n'));
}

QString sectionText(const clouds::Section& section) {
  if (section.points == 0) return CloudTextText::tr("There are no points in the strip.");
  QString text =
      sentences::counted(CloudTextText::tr("%1 points", nullptr, sentences::formOf(qint64(section.points))),
                         qint64(section.points));
  text = CloudTextText::tr("%1, from %2 m to %3 m")
             .arg(text, metres(section.low_m, 2), metres(section.high_m, 2));
  if (section.one_of > 1)
    text = CloudTextText::tr("%1; one in %2 is drawn").arg(text, grouped(section.one_of));
  return text;
}

QString sectionPlaceText(const Eigen::Vector2d& at, const std::optional<Eigen::Vector2d>& nearest) {
  const QString place =
      CloudTextText::tr("along %1 m, height %2 m").arg(metres(at.x(), 3), metres(at.y(), 3));
  if (!nearest) return place;
  return CloudTextText::tr("%1; point at %2 m, %3 m")
      .arg(place, metres(nearest->x(), 3), metres(nearest->y(), 3));
}

QString megabytesText(std::int64_t bytes) {
  return CloudTextText::tr("%1 MB").arg(QString::number(double(bytes) / 1e6, 'f', 1));
}

}  // namespace mapwright::ui
