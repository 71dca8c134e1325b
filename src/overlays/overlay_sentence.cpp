#include "overlays/overlay_sentence.h"

#include <QCoreApplication>
#include <QStringList>

#include "overlays/overlay_edits.h"
#include "overlays/overlay_shapes.h"
#include "sentences/overlay_name.h"
#include "sentences/plural.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::overlays {
namespace {

using sentences::counted;
using sentences::formOf;

struct OverlayText {
  Q_DECLARE_TR_FUNCTIONS(OverlayText)
};

constexpr qsizetype kLongestShown = 60;

/// How far, if all positions of one are those of the other, shifted.
std::optional<double> distanceMoved(const Feature& before, const Feature& after) {
  const auto was = verticesOf(before), is = verticesOf(after);
  if (was.empty() || was.size() != is.size() || was[0].empty() || is[0].empty()) return std::nullopt;
  const Eigen::Vector2d by = is[0][0] - was[0][0];
  const double same_m = std::min(1e-3, by.norm() / 2);
  for (std::size_t ring = 0; ring < was.size(); ++ring) {
    if (was[ring].size() != is[ring].size()) return std::nullopt;
    for (std::size_t i = 0; i < was[ring].size(); ++i) {
      if ((is[ring][i] - was[ring][i] - by).norm() > same_m) return std::nullopt;
    }
  }
  // Heights changed, say, or how far is a question of rounding.
  return by.norm() < 5e-4 ? std::nullopt : std::optional(by.norm());
}

QString metresAt(const Eigen::Vector2d& at_m) {
  return QStringLiteral("%1, %2 m").arg(words::fixed(at_m.x(), 2), words::fixed(at_m.y(), 2));
}

/// "3 points from 16.50, 3.25 m".
QString placeText(const std::string& geometry) {
  const auto shapes = shapesOf(Feature("{\"geometry\":" + geometry + "}"));
  qsizetype count = 0;
  for (const Path& path : shapes.paths) count += qsizetype(path.points.size());
  const auto first = shapes.somewhere();
  if (!first) return OverlayText::tr("no place");
  if (count == 1) return metresAt(*first);
  return OverlayText::tr("%1 from %2")
      .arg(counted(OverlayText::tr("%1 points", nullptr, formOf(count)), count), metresAt(*first));
}

/// One without a name by where it lies.
QString calledForSure(const Feature& feature) {
  const auto at = shapesOf(feature).somewhere();
  if (!feature.name().empty() || !at) return overlayCalled(feature);
  return OverlayText::tr("%1 at %2").arg(overlayCalled(feature), metresAt(*at));
}

QString featureChange(const OverlayChange& change, const Feature& before, const Feature& after,
                      Telling telling) {
  const auto say = [telling](const QString& deed, const QString& event) {
    return telling == Telling::Deed ? deed : event;
  };
  const QString called = calledForSure(before);
  QStringList parts;
  for (const PartChange& each : change.parts) {
    const Part& part = each.part;
    const bool of_feature = part.of == Part::Of::Property;
    const QString was = valueText(part, each.before), is = valueText(part, each.after);
    if (part.of == Part::Of::Member && part.name == "geometry") {
      if (const auto by_m = distanceMoved(before, after)) {
        parts << say(OverlayText::tr("Move %1 by %2 m"), OverlayText::tr("%1 moved by %2 m"))
                     .arg(called, words::fixed(*by_m, *by_m < 0.01 ? 3 : 2));
      } else {
        parts << say(OverlayText::tr("Reshape %1"), OverlayText::tr("%1 has another shape")).arg(called);
      }
    } else if (of_feature && part.name == "name") {
      parts << say(OverlayText::tr("Rename %1 to %2"), OverlayText::tr("%1 is called %2 now"))
                   .arg(called, overlayName(after));
    } else if (of_feature && part.name == typeProperty(after.shape())) {
      parts << say(OverlayText::tr("Make %1 a %2"), OverlayText::tr("%1 became a %2"))
                   .arg(called, overlayKind(after).toLower());
    } else if (of_feature && part.name == "yaw" && each.before && each.after) {
      parts << say(OverlayText::tr("Turn %1 to %2 (was %3)"), OverlayText::tr("%1 turned from %3 to %2"))
                   .arg(called, is, was);
    } else if (each.after && !each.before) {
      parts << say(OverlayText::tr("Set %1 of %2 to %3"), OverlayText::tr("%1 of %2 is %3 now"))
                   .arg(partName(part), called, is);
    } else if (each.after) {
      parts << say(OverlayText::tr("Set %1 of %2 to %3 (was %4)"),
                   OverlayText::tr("%1 of %2 went from %4 to %3"))
                   .arg(partName(part), called, is, was);
    } else {
      parts << say(OverlayText::tr("Remove %1 of %2 (was %3)"), OverlayText::tr("%1 of %2 is gone (was %3)"))
                   .arg(partName(part), called, was);
    }
  }
  return words::joined(parts);
}

}  // namespace

QString overlayKind(const Feature& feature) {
  switch (feature.shape()) {
    case Shape::Point:
      return sentences::nameOf(map::OverlayShape::Point, feature.type());
    case Shape::Line:
      return sentences::nameOf(map::OverlayShape::Line, feature.type());
    case Shape::Polygon:
      return sentences::nameOf(map::OverlayShape::Polygon, feature.type());
    case Shape::None:
    case Shape::Other:
      break;
  }
  return OverlayText::tr("Feature");
}

QString overlayName(const Feature& feature) {
  const QString name = words::plainName(feature.name()).left(200);
  return name.isEmpty() ? OverlayText::tr("(no name)") : name;
}

QString overlayCalled(const Feature& feature) {
  const QString kind = overlayKind(feature).toLower();
  const QString name = words::plainName(feature.name()).left(kLongestShown);
  return name.isEmpty() || name.toLower() == kind ? kind : kind + QLatin1Char(' ') + name;
}

QString featuresText(qsizetype count) {
  return counted(OverlayText::tr("%1 features", nullptr, formOf(count)), count);
}

QString featureCalled(const std::string& id, const std::string& name) {
  return words::plainName(name.empty() ? id.empty() ? OverlayText::tr("(no id)").toStdString() : id : name);
}

QString featuresCalled(const std::vector<OverlayChange>& changes) {
  constexpr qsizetype kMost = 5;
  QStringList names;
  for (const OverlayChange& change : changes) {
    if (names.size() == kMost) {
      names << QStringLiteral("…");
      break;
    }
    names << (change.collection ? OverlayText::tr("the collection") : featureCalled(change.id, change.name));
  }
  return words::listed(names);
}

QString overlayChangesText(qsizetype count) {
  return counted(OverlayText::tr("%1 changes", nullptr, formOf(count)), count);
}

QString changeText(const OverlayChange& change, const OverlayDocument& before, const OverlayDocument& after,
                   Telling telling) {
  const bool deed = telling == Telling::Deed;
  if (change.collection) {
    QStringList names;
    for (const auto& part : change.parts)
      names << OverlayText::tr("%1 to %2").arg(partName(part.part), valueText(part.part, part.after));
    return (deed ? OverlayText::tr("Change the defaults of the map: %1")
                 : OverlayText::tr("the defaults of the map changed: %1"))
        .arg(words::listed(names));
  }
  const Feature* const was = change.from ? &before.features()[*change.from] : nullptr;
  const Feature* const is = change.to ? &after.features()[*change.to] : nullptr;
  if (was && is) return featureChange(change, *was, *is, telling);
  if (is) return (deed ? OverlayText::tr("Add %1") : OverlayText::tr("%1 is new")).arg(calledForSure(*is));
  if (!was) return {};
  return (deed ? OverlayText::tr("Delete %1") : OverlayText::tr("%1 is gone")).arg(calledForSure(*was));
}

QString partName(const Part& part) {
  if (part.of == Part::Of::Whole) return OverlayText::tr("all of it");
  if (part.name == "geometry" && part.of == Part::Of::Member) return OverlayText::tr("place");
  if (part.of == Part::Of::Property) {
    if (part.name == "name") return OverlayText::tr("name");
    if (part.name == "yaw") return OverlayText::tr("heading");
    if (part.name == "type" || part.name == "lineType" || part.name == "regionType")
      return OverlayText::tr("type");
    if (part.name == "defaultRackWidth") return OverlayText::tr("default width of racks");
    if (part.name == "defaultRackDepth") return OverlayText::tr("default depth of racks");
    if (part.name == "defaultPalletWidth") return OverlayText::tr("default width of pallets");
    if (part.name == "defaultPalletDepth") return OverlayText::tr("default depth of pallets");
  }
  return words::plainName(part.name).left(kLongestShown);
}

QString valueText(const Part& part, const std::optional<std::string>& value) {
  if (!value) return part.of == Part::Of::Whole ? OverlayText::tr("deleted") : OverlayText::tr("none");
  if (part.of == Part::Of::Whole) return OverlayText::tr("kept, with changes");
  if (part.of == Part::Of::Member && part.name == "geometry") return placeText(*value);
  const auto json = JsonText::read(*value);
  const bool is_text = json && json->root().kind() == JsonKind::String;
  QString text = words::plainName(is_text ? json->root().string() : *value);
  if (part.name == "yaw" && part.of == Part::Of::Property) text += QChar(0xb0);
  return words::shortened(text, kLongestShown);
}

}  // namespace mapwright::overlays
