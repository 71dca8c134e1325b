#include "jobs/write_picture.h"

#include <QBuffer>
#include <QImageWriter>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "jobs/faults.h"

namespace mapwright::jobs {

std::optional<Fault> writePicture(const QImage& picture, const QString& path) {
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  QImageWriter writer(&png, "png");
  if (!writer.write(picture)) {
    return Fault(fault::PictureNotEncoded, {path.toStdString(), writer.errorString().toStdString()});
  }
  const auto fault = disk::writeFile(
      path.toStdString(), std::string_view(png.data().constData(), std::size_t(png.data().size())));
  return fault ? std::optional(disk::notWritten(*fault)) : std::nullopt;
}

}  // namespace mapwright::jobs
