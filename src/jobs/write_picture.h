// A painted picture as a PNG file.
#pragma once

#include <optional>

#include <QImage>
#include <QString>

#include "map/reason.h"

namespace mapwright::jobs {

/// Whole or not at all; what a path may be says disk::WrittenFile. nullopt = written, else why not.
std::optional<map::Reason> writePicture(const QImage& picture, const QString& path);

}  // namespace mapwright::jobs
