#include "compare/comparison_sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include "compare/picture_view.h"
#include "sentences/plural.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::compare {
namespace {

struct ComparisonText {
  Q_DECLARE_TR_FUNCTIONS(ComparisonText)
};

QString sizeText(PictureSize size) {
  return QString::fromStdString(words::dimensions(size.width, size.height));
}

QString figure(double value, int digits) { return QLocale::c().toString(value, 'f', digits); }

/// "12.5 m²", "0.08 m²", "0.0025 m²".
QString areaText(double area_m2) {
  return figure(area_m2, area_m2 >= 1 ? 1 : area_m2 >= 0.01 ? 2 : 4) + QStringLiteral(" m²");
}

QString pixelsText(qint64 count) {
  return sentences::counted(ComparisonText::tr("%1 pixels", nullptr, sentences::formOf(count)), count);
}

}  // namespace

QString placeText(const Eigen::Vector2d& at_m) {
  return QStringLiteral("(%1, %2)").arg(figure(at_m.x(), 1), figure(at_m.y(), 1));
}

QString sizesText(const Comparison& comparison) {
  if (comparison.sameSize()) return {};
  return ComparisonText::tr("The sizes differ: %1 expected, %2 here.")
      .arg(sizeText(comparison.expected), sizeText(comparison.actual));
}

QString clustersText(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view) {
  if (comparison.clusters.empty()) return {};
  const Cluster& largest = comparison.clusters.front();
  QString area = pixelsText(largest.pixels);
  QString place = QStringLiteral("(%1, %2)").arg(largest.box.x).arg(largest.box.y);
  if (view) {
    area = areaText(double(largest.pixels) * view->scale_m_per_px * view->scale_m_per_px);
    place = placeText(worldOf(*view, largest.box).center());
  }
  if (comparison.clusters_in_all == 1) {
    return view ? ComparisonText::tr("1 cluster of %1 at %2").arg(area, place)
                : ComparisonText::tr("1 cluster of %1 at pixel %2").arg(area, place);
  }
  const QString clusters = QString::fromStdString(words::grouped(comparison.clusters_in_all));
  return view ? ComparisonText::tr("%1 clusters, the largest %2 at %3").arg(clusters, area, place)
              : ComparisonText::tr("%1 clusters, the largest %2 at pixel %3").arg(clusters, area, place);
}

QString amountText(const Comparison& comparison) {
  const QString pixels = sentences::counted(
      ComparisonText::tr("%1 pixels differ", nullptr, sentences::formOf(comparison.differing)),
      comparison.differing);
  const QString share = QLocale::c().toString(comparison.percent(), 'g', 3);
  return ComparisonText::tr("%1 (%2 %), by up to %3").arg(pixels, share, QString::number(comparison.max));
}

QString comparisonText(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view) {
  if (comparison.differing == 0) {
    return comparison.max == 0
               ? ComparisonText::tr("The pictures are the same.")
               : ComparisonText::tr(
                     "The pictures are equal: no channel differs by more than is allowed (%1 at most).")
                     .arg(comparison.max);
  }
  QString text = words::paragraph({sizesText(comparison), amountText(comparison)});
  if (const QString clusters = clustersText(comparison, view); !clusters.isEmpty())
    text = words::about(text, clusters);
  text = words::asSentence(text);
  if (!comparison.equal) return text;
  return words::paragraph({text, ComparisonText::tr("That is allowed.")});
}

}  // namespace mapwright::compare
