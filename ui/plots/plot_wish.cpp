#include "ui/plots/plot_wish.h"

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::window {

using series::Quantity;

namespace {

class PlotWishText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::window::PlotWish)
 public:
  static QString name(Quantity quantity) {
    switch (quantity) {
      case Quantity::X:
        return tr("Position x");
      case Quantity::Y:
        return tr("Position y");
      case Quantity::Yaw:
        return tr("Heading");
      case Quantity::Speed:
        return tr("Speed");
      case Quantity::PositionQuality:
        return tr("Localization quality");
      case Quantity::MatchingScore:
        return tr("Matching score");
      case Quantity::Battery:
        return tr("Battery");
    }
    return {};
  }
  static QString unit(Quantity quantity) {
    switch (quantity) {
      case Quantity::X:
      case Quantity::Y:
        return tr("m");
      case Quantity::Yaw:
        return QStringLiteral("°");
      case Quantity::Speed:
        return tr("m/s");
      case Quantity::Battery:
        return QStringLiteral("%");
      default:
        return {};
    }
  }
};

QString wordOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::X:
      return QStringLiteral("x");
    case Quantity::Y:
      return QStringLiteral("y");
    case Quantity::Yaw:
      return QStringLiteral("yaw");
    case Quantity::Speed:
      return QStringLiteral("speed");
    case Quantity::PositionQuality:
      return QStringLiteral("quality");
    case Quantity::MatchingScore:
      return QStringLiteral("score");
    case Quantity::Battery:
      return QStringLiteral("battery");
  }
  return {};
}

}  // namespace

QString plotName(const PlotWish& wish) {
  if (const auto* quantity = std::get_if<Quantity>(&wish)) return PlotWishText::name(*quantity);
  return words::plainName(std::get<series::FieldPath>(wish).text());
}

QString plotUnit(const PlotWish& wish) {
  const auto* quantity = std::get_if<Quantity>(&wish);
  return quantity ? PlotWishText::unit(*quantity) : QString();
}

QString plotWord(const PlotWish& wish) {
  if (const auto* quantity = std::get_if<Quantity>(&wish)) return wordOf(*quantity);
  return QString::fromStdString(std::get<series::FieldPath>(wish).text());
}

std::optional<PlotWish> plotFromWord(const QString& word) {
  for (const Quantity quantity : series::kQuantities) {
    if (word == wordOf(quantity)) return quantity;
  }
  if (auto path = series::FieldPath::parse(word.toStdString())) return PlotWish(std::move(*path));
  return std::nullopt;
}

}  // namespace mapwright::window
