// Where on the map a picture lies, as the report of a snapshot says it (docs/command-line.md, "mapwright
// snapshot").
#pragma once

#include <optional>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include "compare/comparison.h"
#include "geometry/view_transform.h"

namespace mapwright::compare {

/// {"center", "scale", "size", "rotation_deg"}.
QJsonObject jsonOf(const geometry::ViewTransform& view);
/// The member "view" of a report; nullopt: it has none that is of use.
std::optional<geometry::ViewTransform> viewOf(const QJsonObject& report);
/// It can be about a picture of this size.
bool isOf(const geometry::ViewTransform& view, PictureSize size);
/// Of the report in a file.
std::optional<geometry::ViewTransform> viewIn(const QString& report);
/// Of the report beside a picture: "a.json" or "a.png.json" of "a.png". One of another size is not about it.
std::optional<geometry::ViewTransform> viewBeside(const QString& picture, PictureSize size);

/// The part of the map below a box.
geometry::WorldRect worldOf(const geometry::ViewTransform& view, const PixelBox& box);
/// {"box", "pixels", "world"}; "world" is [x, y, w, h] in metres from the lower left corner.
QJsonArray clustersJson(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view);

}  // namespace mapwright::compare
