#include "ui/plots/plot_selection.h"

#include <algorithm>

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::ui {

using series::Quantity;

namespace {

class PlotSelectionText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::ui::PlotSelection)
};

struct QuantityLook {
  Quantity quantity;
  const char* word;
  const char* name;
  const char* unit;  // "": none
};
constexpr QuantityLook kQuantityLooks[] = {
    {Quantity::X, "x", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Position x"),
     QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "m")},
    {Quantity::Y, "y", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Position y"),
     QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "m")},
    {Quantity::Yaw, "yaw", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Heading"), "°"},
    {Quantity::Speed, "speed", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Speed"),
     QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "m/s")},
    {Quantity::PositionQuality, "quality",
     QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Localization quality"), ""},
    {Quantity::MatchingScore, "score", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Matching score"),
     ""},
    {Quantity::Battery, "battery", QT_TRANSLATE_NOOP("mapwright::ui::PlotSelection", "Battery"), "%"}};

/// nullptr: a field.
const QuantityLook* lookOf(const PlotSelection& selection) {
  const auto* const quantity = std::get_if<Quantity>(&selection);
  return quantity ? &kQuantityLooks[std::size_t(*quantity)] : nullptr;
}

}  // namespace

QString plotName(const PlotSelection& selection) {
  if (const QuantityLook* const look = lookOf(selection)) return PlotSelectionText::tr(look->name);
  return words::plainName(std::get<series::FieldPath>(selection).text());
}

QString plotUnit(const PlotSelection& selection) {
  const QuantityLook* const look = lookOf(selection);
  return look && *look->unit ? PlotSelectionText::tr(look->unit) : QString();
}

QString plotWord(const PlotSelection& selection) {
  if (const QuantityLook* const look = lookOf(selection)) return QLatin1String(look->word);
  return QString::fromStdString(std::get<series::FieldPath>(selection).text());
}

std::optional<PlotSelection> plotFromWord(const QString& word) {
  for (const QuantityLook& look : kQuantityLooks) {
    if (word == QLatin1String(look.word)) return look.quantity;
  }
  if (auto path = series::FieldPath::parse(word.toStdString())) return PlotSelection(std::move(*path));
  return std::nullopt;
}

std::unique_ptr<QMimeData> mimeOf(const PlotSelection& selection) {
  auto mime = std::make_unique<QMimeData>();
  mime->setData(QLatin1String(kFieldMime), plotWord(selection).toUtf8());
  mime->setText(plotWord(selection));
  return mime;
}

std::optional<PlotSelection> plotFromMime(const QMimeData& mime) {
  if (mime.hasFormat(QLatin1String(kFieldMime)))
    return plotFromWord(QString::fromUtf8(mime.data(QLatin1String(kFieldMime))));
  // Any text could be a topic; only one that begins like a path counts.
  const QString text = mime.hasText() ? mime.text().trimmed() : QString();
  if (!text.startsWith(QLatin1Char('/')) && !text.startsWith(QLatin1String("\"/"))) return std::nullopt;
  auto path = series::FieldPath::parse(text.toStdString());
  return path ? std::optional<PlotSelection>(std::move(*path)) : std::nullopt;
}

}  // namespace mapwright::ui
