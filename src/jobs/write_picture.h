// A painted picture as a PNG file.
#pragma once

#include <optional>

#include <QImage>
#include <QString>

#include "fault/fault.h"

namespace mapwright::jobs {

/// Whole or not at all; what a path may be says disk::WrittenFile. nullopt = written, else why not.
std::optional<Fault> writePicture(const QImage& picture, const QString& path);

}  // namespace mapwright::jobs
