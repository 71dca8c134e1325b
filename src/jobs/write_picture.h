// Writes a painted picture to a PNG file.
#pragma once

#include <optional>

#include <QImage>
#include <QString>

#include "fault/fault.h"

namespace mapwright::jobs {

/// Completely or not at all; disk::WrittenFile describes which paths are possible. nullopt = written,
/// otherwise why not.
std::optional<Fault> writePicture(const QImage& picture, const QString& path);

}  // namespace mapwright::jobs
